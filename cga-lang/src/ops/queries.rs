//! The functions that look at the shape, its geometry, the run and files.

use super::{
    B, BS, Default, F, FILE, FS, Function, Needs, Param, ParamKind, Run, T, TS, Uses, boolean, float, of, or, param,
    text, uv_set, word,
};
use crate::code::Code;
use crate::types::Type;

const fn row(
    name: &'static str,
    call: &'static str,
    params: &'static [Param],
    ty: Type,
    (needs, uses): (Needs, Uses),
    about: &'static str,
) -> Function {
    Function { name, run: Run::Now(call), params, ty, needs, uses, pure: false, old: None, about }
}

/// Asks the shape alone.
const fn shape(
    name: &'static str,
    call: &'static str,
    params: &'static [Param],
    ty: Type,
    about: &'static str,
) -> Function {
    row(name, call, params, ty, (Needs::Shape, Uses::WHOLE), about)
}

/// Asks the shape and the run.
const fn both(
    name: &'static str,
    call: &'static str,
    params: &'static [Param],
    ty: Type,
    about: &'static str,
) -> Function {
    row(name, call, params, ty, (Needs::Both, Uses::WHOLE), about)
}

/// Asks the run alone: prints and files.
const fn run(
    name: &'static str,
    call: &'static str,
    params: &'static [Param],
    ty: Type,
    about: &'static str,
) -> Function {
    row(name, call, params, ty, (Needs::Env, Uses::SAYS), about)
}

/// The directions that faces can look in; of areas also all. `$no_street` is the new spelling of `noStreetSide`, which is
/// deprecated like `streetSide` (*CGA changelog 2012.1*).
macro_rules! directions {
    ($no_street:literal $(, $more:expr)*) => {
        param("faceOrientation", ParamKind::Word {
            rust: "Word",
            words: &[
                $($more,)*
                ("front", "Front"),
                ("back", "Back"),
                ("left", "Left"),
                ("right", "Right"),
                ("top", "Top"),
                ("bottom", "Bottom"),
                ("side", "Side"),
                ("object.front", "ObjectFront"),
                ("object.back", "ObjectBack"),
                ("object.left", "ObjectLeft"),
                ("object.right", "ObjectRight"),
                ("object.top", "ObjectTop"),
                ("object.bottom", "ObjectBottom"),
                ("object.side", "ObjectSide"),
                ("world.south", "WorldSouth"),
                ("world.north", "WorldNorth"),
                ("world.west", "WorldWest"),
                ("world.east", "WorldEast"),
                ("world.up", "WorldUp"),
                ("world.down", "WorldDown"),
                ("world.side", "WorldSide"),
                ("street.front", "StreetFront"),
                ("street.back", "StreetBack"),
                ("street.left", "StreetLeft"),
                ("street.right", "StreetRight"),
                ("street.side", "StreetSide"),
                ("streetSide", "StreetFront"),
                ("noStreetSide", "NotStreetFront"),
            ],
            old: &[("streetSide", "street.front"), ("noStreetSide", $no_street)],
            unknown: Code::UnknownWord,
        })
    };
}

const FACES: Param = or(
    directions!("geometry.area() - geometry.area(street.front)", ("all", "All"), ("surface", "All")),
    Default::Word("all"),
);
const DIRECTION: Param = directions!("geometry.area(street.front) < geometry.area()");

const ANGLE: Param =
    word("angleType", "AngleType", &[("maxSlope", "MaxSlope"), ("azimuth", "Azimuth"), ("zenith", "Zenith")]);

const TOLERANCE: Param = float("tolerance");

/// The geometry of the shape.
pub(super) static GEOMETRY: &[Function] = &[
    both("geometry.area", "geometry_area", &[FACES], F, "the area of the faces, in square metres"),
    shape("geometry.volume", "geometry_volume", &[], F, "what the faces enclose, in cubic metres"),
    shape("geometry.height", "geometry_height", &[], F, "the height in the world, in metres"),
    shape(
        "geometry.boundaryLength",
        "geometry_boundary_length",
        &[],
        F,
        "the length of the edges that no two faces share, in metres",
    ),
    shape("geometry.angle", "geometry_angle", &[ANGLE], F, "how steep the steepest face is, or where it looks"),
    shape("geometry.nVertices", "geometry_n_vertices", &[], F, "how many vertices there are"),
    shape("geometry.nEdges", "geometry_n_edges", &[], F, "how many edges there are"),
    shape("geometry.nFaces", "geometry_n_faces", &[], F, "how many faces there are"),
    shape("geometry.nHoles", "geometry_n_holes", &[], F, "how many holes the faces have"),
    shape("geometry.isConcave", "geometry_is_concave", &[], B, "whether a face turns inwards somewhere"),
    shape("geometry.isClosedSurface", "geometry_is_closed_surface", &[], B, "whether two faces share every edge"),
    shape("geometry.isInstanced", "geometry_is_instanced", &[], B, "whether it is an asset that nothing has changed"),
    both(
        "geometry.isRectangular",
        "geometry_is_rectangular",
        &[TOLERANCE],
        B,
        "whether all faces are rectangles, within so many degrees",
    ),
    both(
        "geometry.isPlanar",
        "geometry_is_planar",
        &[TOLERANCE],
        B,
        "whether all faces are flat, within so many degrees",
    ),
    both("geometry.isOriented", "geometry_is_oriented", &[DIRECTION], B, "whether a face looks there"),
    both("geometry.groups", "geometry_groups", &[], TS, "the names of the groups that have faces"),
    shape("geometry.materials", "geometry_materials", &[], TS, "the names of the materials that faces have"),
];

const SYSTEMS: &[(&str, &str)] = &[("scope", "Scope"), ("pivot", "Pivot"), ("object", "Object"), ("world", "World")];
const FROM: Param = word("fromSystem", "System", SYSTEMS);
const TO: Param = word("toSystem", "System", SYSTEMS);
const WHAT: Param = word("type", "ConvertWhat", &[("pos", "Pos"), ("orient", "Orient")]);
const COORDINATE: Param = word("coordinate", "Axis", &[("x", "X"), ("y", "Y"), ("z", "Z")]);

const SOURCE: Param =
    word("source", "MaterialSource", &[("used", "Used"), ("shape", "Shape"), ("geometry", "Geometry")]);
const MODE: Param = word("mode", "MaterialMode", &[("changed", "Changed"), ("all", "All")]);

/// The same row, of a function that asks for texture coordinates, which may follow from the place in the world.
const fn placed(row: Function) -> Function {
    Function { uses: Uses::WHOLE.and(Uses::PLACE), ..row }
}

const UV_SET: Param = or(uv_set("uvSet"), Default::Float(0.0));

const SPACE: Param = word("surfaceParameterization", "TextureSpace", &[("uvSpace", "Uv"), ("unitSpace", "Unit")]);

/// Texture coordinates.
pub(super) static TEXTURE: &[Function] = &[
    placed(both(
        "geometry.du",
        "geometry_du",
        &[uv_set("uvSet"), SPACE],
        F,
        "the extent in u, in coordinates or about in metres",
    )),
    placed(both(
        "geometry.dv",
        "geometry_dv",
        &[uv_set("uvSet"), SPACE],
        F,
        "the extent in v, in coordinates or about in metres",
    )),
    placed(both("geometry.uMin", "geometry_u_min", &[UV_SET], F, "the smallest u")),
    placed(both("geometry.uMax", "geometry_u_max", &[UV_SET], F, "the largest u")),
    placed(both("geometry.vMin", "geometry_v_min", &[UV_SET], F, "the smallest v")),
    placed(both("geometry.vMax", "geometry_v_max", &[UV_SET], F, "the largest v")),
    placed(both("geometry.hasUVs", "geometry_has_uvs", &[], B, "whether there are texture coordinates")),
    placed(both(
        "geometry.hasUVs",
        "geometry_has_uv_set",
        &[uv_set("uvSet")],
        B,
        "whether there are texture coordinates of a set",
    )),
];

/// The shape itself, its material, and what is printed on the way.
pub(super) static SHAPES: &[Function] = &[
    both(
        "convert",
        "convert",
        &[COORDINATE, FROM, TO, WHAT, float("x"), float("y"), float("z")],
        F,
        "a position or orientation in another coordinate system",
    ),
    both(
        "convert",
        "convert_array",
        &[FROM, TO, WHAT, of("coordinates", FS)],
        FS,
        "a position or orientation in another coordinate system",
    ),
    both("getMaterial", "get_material", &[SOURCE, MODE], TS, "the attributes of the material, as names and values"),
    run("print", "print", &[float("value")], F, "shows a value and gives it"),
    run("print", "print", &[boolean("value")], B, "shows a value and gives it"),
    run("print", "print", &[text("value")], T, "shows a value and gives it"),
    run("print", "print", &[of("value", FS)], FS, "shows a value and gives it"),
    run("print", "print", &[of("value", BS)], BS, "shows a value and gives it"),
    run("print", "print", &[of("value", TS)], TS, "shows a value and gives it"),
];

/// What it finds is named so that it is found from the rule file.
const QUERY: Param = param("searchQuery", ParamKind::File);

const ASSET: Param = word(
    "attribute",
    "AssetDimension",
    &[("sx", "Sx"), ("sy", "Sy"), ("sz", "Sz"), ("tx", "Tx"), ("ty", "Ty"), ("tz", "Tz")],
);
const IMAGE: Param = word("attribute", "ImageDimension", &[("sx", "Sx"), ("sy", "Sy")]);
const NAMING: Param = word("namingAttribute", "AssetNaming", &[("g", "Groups"), ("m", "Materials")]);

/// Files and what is in them.
pub(super) static FILES: &[Function] = &[
    run("fileExists", "file_exists", &[FILE], B, "whether there is a file that can be used"),
    run("fileSearch", "file_search", &[QUERY], T, "the files that a query finds, as a list"),
    run("filesSearch", "files_search", &[QUERY], TS, "the files that a query finds"),
    row(
        "fileRandom",
        "file_random",
        &[QUERY],
        T,
        (Needs::Both, Uses::DRAWS.and(Uses::SAYS)),
        "one of the files that a query finds",
    ),
    run("assetInfo", "asset_info", &[FILE, ASSET], F, "a size or coordinate of the box around an asset, in metres"),
    run(
        "assetNamingInfo",
        "asset_naming_info",
        &[FILE, NAMING],
        T,
        "the names of an asset's groups or materials, as a list",
    ),
    run("assetNamingInfos", "asset_naming_infos", &[FILE, NAMING], TS, "the names of an asset's groups or materials"),
    run("imageInfo", "image_info", &[FILE, IMAGE], F, "the width or height of an image, in pixels"),
    run("readTextFile", "read_text_file", &[FILE], T, "the text of a file"),
    run("readStringTable", "read_string_table", &[FILE], TS, "the table of a file, as text"),
    run("readFloatTable", "read_float_table", &[FILE], FS, "the table of a file, as numbers"),
];
