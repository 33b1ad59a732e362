//! The functions that query the shape, its geometry, the run and files.

use super::base::function;
use super::{
    AssetNames, B, BS, Default, F, FILE, FS, FileUse, Function, Needs, Param, Params, Str, T, TS, Uses, boolean, file,
    float, of, or, outdated, renamed, text, uv_set, word,
};
use crate::types::Type;

const fn row(name: Str, call: Str, params: Params, ty: Type, (needs, uses): (Needs, Uses), about: Str) -> Function {
    Function { needs, uses, ..function(name, call, params, ty, about) }
}

/// A query of the shape.
const fn shape(name: Str, call: Str, params: Params, ty: Type, about: Str) -> Function {
    row(name, call, params, ty, (Needs::Shape, Uses::WHOLE), about)
}

/// A query of the shape and the run.
const fn both(name: Str, call: Str, params: Params, ty: Type, about: Str) -> Function {
    row(name, call, params, ty, (Needs::Both, Uses::WHOLE), about)
}

/// The row of a query with the same result in every place.
const fn rigid(row: Function) -> Function {
    Function { uses: Uses::BODY, ..row }
}

/// The row of a query with the same result in every place with the same orientation.
const fn upright(row: Function) -> Function {
    Function { uses: Uses::BODY.and(Uses::AXES), ..row }
}

/// A query of the run: prints and files.
const fn run(name: Str, call: Str, params: Params, ty: Type, about: Str) -> Function {
    row(name, call, params, ty, (Needs::Env, Uses::SAYS), about)
}

/// The directions that faces can have; for areas also `all`. `$no_street` is the new spelling of `noStreetSide`,
/// which is deprecated like `streetSide` (*CGA changelog 2012.1*).
macro_rules! directions {
    ($no_street:literal $(, $more:expr)*) => {
        outdated(
            &[("streetSide", "street.front"), ("noStreetSide", $no_street)],
            renamed(
                &[("surface", "All"), ("streetSide", "StreetFront"), ("noStreetSide", "NotStreetFront")],
                word(
                    "faceOrientation",
                    "Word",
                    &[
                        $($more,)*
                        "front",
                        "back",
                        "left",
                        "right",
                        "top",
                        "bottom",
                        "side",
                        "object.front",
                        "object.back",
                        "object.left",
                        "object.right",
                        "object.top",
                        "object.bottom",
                        "object.side",
                        "world.south",
                        "world.north",
                        "world.west",
                        "world.east",
                        "world.up",
                        "world.down",
                        "world.side",
                        "street.front",
                        "street.back",
                        "street.left",
                        "street.right",
                        "street.side",
                        "streetSide",
                        "noStreetSide",
                    ],
                ),
            ),
        )
    };
}

const FACES: Param =
    or(directions!("geometry.area() - geometry.area(street.front)", "all", "surface"), Default::Word("all"));
const DIRECTION: Param = directions!("geometry.area(street.front) < geometry.area()");

const ANGLE: Param = word("angleType", "AngleType", &["maxSlope", "azimuth", "zenith"]);

const TOLERANCE: Param = float("tolerance");

/// The geometry of the shape.
pub(super) static GEOMETRY: &[Function] = &[
    rigid(both("geometry.area", "geometry_area", &[FACES], F, "the area of the faces, in square metres")),
    rigid(shape("geometry.volume", "geometry_volume", &[], F, "the volume that the faces enclose, in cubic metres")),
    upright(shape("geometry.height", "geometry_height", &[], F, "the height in the world, in metres")),
    rigid(shape(
        "geometry.boundaryLength",
        "geometry_boundary_length",
        &[],
        F,
        "the length of the edges that no two faces share, in metres",
    )),
    upright(shape(
        "geometry.angle",
        "geometry_angle",
        &[ANGLE],
        F,
        "the slope of the steepest face, or the direction that it faces",
    )),
    rigid(shape("geometry.nVertices", "geometry_n_vertices", &[], F, "how many vertices there are")),
    rigid(shape("geometry.nEdges", "geometry_n_edges", &[], F, "how many edges there are")),
    rigid(shape("geometry.nFaces", "geometry_n_faces", &[], F, "how many faces there are")),
    rigid(shape("geometry.nHoles", "geometry_n_holes", &[], F, "how many holes the faces have")),
    rigid(shape("geometry.isConcave", "geometry_is_concave", &[], B, "whether a face turns inwards somewhere")),
    rigid(shape(
        "geometry.isClosedSurface",
        "geometry_is_closed_surface",
        &[],
        B,
        "whether two faces share every edge",
    )),
    rigid(shape(
        "geometry.isInstanced",
        "geometry_is_instanced",
        &[],
        B,
        "whether it is an asset that nothing has changed",
    )),
    rigid(both(
        "geometry.isRectangular",
        "geometry_is_rectangular",
        &[TOLERANCE],
        B,
        "whether all faces are rectangles, within a tolerance in degrees",
    )),
    rigid(both(
        "geometry.isPlanar",
        "geometry_is_planar",
        &[TOLERANCE],
        B,
        "whether all faces are flat, within a tolerance in degrees",
    )),
    both("geometry.isOriented", "geometry_is_oriented", &[DIRECTION], B, "whether a face looks there"),
    Function {
        names: Some(AssetNames::Groups),
        ..both("geometry.groups", "geometry_groups", &[], TS, "the names of the groups that have faces")
    },
    Function {
        names: Some(AssetNames::Materials),
        ..both("geometry.materials", "geometry_materials", &[], TS, "the names of the materials that faces have")
    },
];

pub(super) const SYSTEMS: &[&str] = &["scope", "pivot", "object", "world"];
const FROM: Param = word("fromSystem", "System", SYSTEMS);
const TO: Param = word("toSystem", "System", SYSTEMS);
const WHAT: Param = word("type", "ConvertWhat", &["pos", "orient"]);
const COORDINATE: Param = word("coordinate", "Axis", &["x", "y", "z"]);

const SOURCE: Param = word("source", "MaterialSource", &["used", "shape", "geometry"]);
const MODE: Param = word("mode", "MaterialMode", &["changed", "all"]);

/// The row with uses of texture coordinates, which may depend on the place in the world.
const fn placed(row: Function) -> Function {
    Function { uses: Uses::WHOLE.and(Uses::PLACE), ..row }
}

/// The row of a function that measures a uv set and returns 0 if it is missing (*geometry.du, dv*, *geometry.uMin
/// …*).
const fn measured(row: Function) -> Function {
    Function { needs_uv_set: true, ..placed(row) }
}

const UV_SET: Param = or(uv_set("uvSet"), Default::Float(0.0));

pub(super) const SPACE: Param = renamed(
    &[("uvSpace", "Uv"), ("unitSpace", "Unit")],
    word("surfaceParameterization", "TextureSpace", &["uvSpace", "unitSpace"]),
);

/// Texture coordinates.
pub(super) static TEXTURE: &[Function] = &[
    measured(both(
        "geometry.du",
        "geometry_du",
        &[uv_set("uvSet"), SPACE],
        F,
        "the extent in u, in coordinates or about in metres",
    )),
    measured(both(
        "geometry.dv",
        "geometry_dv",
        &[uv_set("uvSet"), SPACE],
        F,
        "the extent in v, in coordinates or about in metres",
    )),
    measured(both("geometry.uMin", "geometry_u_min", &[UV_SET], F, "the smallest u")),
    measured(both("geometry.uMax", "geometry_u_max", &[UV_SET], F, "the largest u")),
    measured(both("geometry.vMin", "geometry_v_min", &[UV_SET], F, "the smallest v")),
    measured(both("geometry.vMax", "geometry_v_max", &[UV_SET], F, "the largest v")),
    placed(both("geometry.hasUVs", "geometry_has_uvs", &[], B, "whether there are texture coordinates")),
    placed(both(
        "geometry.hasUVs",
        "geometry_has_uv_set",
        &[uv_set("uvSet")],
        B,
        "whether there are texture coordinates of a set",
    )),
];

/// The shape itself, its material, and printing.
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

/// The names of the found files are relative to the rule file.
const QUERY: Param = file("searchQuery", FileUse::Searched);

const ASSET: Param = word("attribute", "AssetDimension", &["sx", "sy", "sz", "tx", "ty", "tz"]);
const IMAGE: Param = word("attribute", "ImageDimension", &["sx", "sy"]);
const NAMING: Param =
    renamed(&[("g", "Groups"), ("m", "Materials")], word("namingAttribute", "AssetNaming", &["g", "m"]));

/// Files and their contents.
pub(super) static FILES: &[Function] = &[
    run(
        "fileExists",
        "file_exists",
        &[file("filePath", FileUse::Asked)],
        B,
        "whether there is a file that can be used",
    ),
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
