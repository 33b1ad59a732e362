//! Geometry creation: extrusion, assets, primitives, envelopes.

use super::super::{
    Allowed, Default, Effect, FILE, FS, FileUse, Operation, Param, ParamBounds, Params, Str, UvEffect, bounds, file,
    float, length, of, or, outdated, renamed, uv_set, within, word,
};
use super::{moves, old, op, rigid, tagging, upright, uvs, with};

const EXTRUDE_ALONG: Param = outdated(
    &[("world.y", "world.up")],
    renamed(
        &[("world.y", "WorldUp")],
        word(
            "extrusionType",
            "ExtrudeAlong",
            &["face.normal", "vertex.normal", "world.up", "world.y", "world.up.flatTop"],
        ),
    ),
);

const EXTRUDE_AXIS: Param = word("axis", "ExtrudeAxis", &["x", "y", "z", "world.x", "world.z"]);

const UP_AXIS: Param = word("upAxisOfGeometry", "UpAxis", &["yUp", "zUp"]);

const INSERT_MODE: Param =
    word("insertMode", "InsertMode", &["alignSizeAndPosition", "keepSizeAndPosition", "keepSizeAlignPosition"]);

const CLEANUP_MODE: Param = word("cleanupMode", "CleanupMode", &["numericalCleanup", "noCleanup"]);

const HEIGHT_DIRECTION: Param = word("heightDirection", "HeightDirection", &["scope.y", "vertex.normal"]);

const HEIGHT_ALIGNMENT: Param = word("heightAlignment", "HeightAlignment", &["alignPosition", "keepPosition"]);

const DIRECTION: Param = word("direction", "EnvelopeAlong", &["normal", "world.up"]);

const KEEP_FACES: Param = word("keepFaces", "OffsetFaces", &["all", "inside", "border"]);

/// *primitiveDisk*, *primitiveSphere*, *primitiveCylinder* and *primitiveCone operation*.
static CORNERS: ParamBounds = bounds(Allowed::AtLeast(3.0), "there are at least 3");

/// *primitiveSphere operation*.
static DIVISIONS: ParamBounds = bounds(Allowed::AtLeast(2.0), "there are at least 2");

const N_VERTICES: Param = within(float("nVertices"), &CORNERS);
const SIDES: Param = within(float("sides"), &CORNERS);
const N_DIVISIONS: Param = within(float("divisions"), &DIVISIONS);

const SIXTEEN: Default = Default::Float(16.0);

/// Assets are trimmed at the trim planes of the shape.
const SPHERE: &str = "replaces the geometry by a sphere that fills the scope";
const VOLUME: &str = "makes the largest volume that the limits allow";

/// The bounds of a parameter of an envelope.
const fn envelope_bounds(values: Allowed, about: Str) -> ParamBounds {
    ParamBounds { result: Some("the shape stays as it is"), ..bounds(values, about) }
}

/// *envelope operation*: the volume ends at this height.
static MAX_HEIGHTS: ParamBounds = envelope_bounds(Allowed::Above(0.0), "a maximum height is above 0");

/// *envelope operation*: sides rise from the face.
static BASE_HEIGHTS: ParamBounds = envelope_bounds(Allowed::AtLeast(0.0), "base heights are at least 0");

/// *envelope operation*: slopes lean inwards.
static SLOPE_ANGLES: ParamBounds =
    envelope_bounds(Allowed::Between(0.0, 90.0), "slope angles are from 0 to 90 degrees");

/// *envelope operation*: surplus elements have no edge.
static EACH_BASE_HEIGHT: ParamBounds = ParamBounds {
    element: Some(&ParamBounds { result: Some("a shape with this edge stays as it is"), ..BASE_HEIGHTS }),
    ..BASE_HEIGHTS
};
static EACH_SLOPE_ANGLE: ParamBounds = ParamBounds {
    element: Some(&ParamBounds { result: Some("a shape with this edge stays as it is"), ..SLOPE_ANGLES }),
    ..SLOPE_ANGLES
};

const MAX_HEIGHT: Param = within(float("maxHeight"), &MAX_HEIGHTS);

const fn base(name: Str) -> Param {
    within(float(name), &BASE_HEIGHTS)
}

const fn slope(name: Str) -> Param {
    within(float(name), &SLOPE_ANGLES)
}

/// Heights and angles of each side.
const ENVELOPE: &[Param] = &[
    DIRECTION,
    MAX_HEIGHT,
    base("frontBaseHeight"),
    slope("frontAngle"),
    base("backBaseHeight"),
    slope("backAngle"),
    base("rightBaseHeight"),
    slope("rightAngle"),
    base("leftBaseHeight"),
    slope("leftAngle"),
];

/// Both sides alike.
const ENVELOPE_SIDES: &[Param] = &[
    DIRECTION,
    MAX_HEIGHT,
    base("frontBaseHeight"),
    slope("frontAngle"),
    base("backBaseHeight"),
    slope("backAngle"),
    base("sideBaseHeight"),
    slope("sideAngle"),
];

const INSERTED: Param = file("filePath", FileUse::Inserted);

const EXTRUDE_TAGS: &[&str] = &["extrude.bottom", "extrude.top", "extrude.side.outer", "extrude.side.inner"];

const ENVELOPE_TAGS: &[&str] =
    &["envelope.bottom", "envelope.top", "envelope.side.base", "envelope.side.slope", "envelope.side.inner"];

/// A row of `extrude`.
const fn extrudes(row: Operation) -> Operation {
    tagging(EXTRUDE_TAGS, keeps_uvs(row))
}

/// A row of `envelope`.
const fn envelope(call: Str, params: Params, about: Str) -> Operation {
    tagging(ENVELOPE_TAGS, op("envelope", call, params, about))
}

/// The row of an operation whose new faces have no texture coordinates.
const fn keeps_uvs(row: Operation) -> Operation {
    uvs(UvEffect::Keeps, row)
}

/// A primitive. It only has the first uv set (*primitiveCube operation*).
const fn primitive(name: Str, call: Str, params: Params, about: Str) -> Operation {
    rigid(uvs(UvEffect::First, op(name, call, params, about)))
}

/// A primitive that fills a scope with a size along all axes.
const fn filling(name: Str, call: Str, params: Params, about: Str) -> Operation {
    with(Effect::Fills, primitive(name, call, params, about))
}

/// An asset along texture coordinates.
const fn along_uv(call: Str, params: Params) -> Operation {
    uvs(UvEffect::Follows, op("insertAlongUV", call, params, "bends copies of an asset along texture coordinates"))
}

/// The first parameters of a list.
const fn first(count: usize, params: Params) -> Params {
    params.split_at(count).0
}

/// An envelope without the direction.
const fn undirected(call: Str, params: Params) -> Operation {
    old(envelope(call, params.split_at(1).1, VOLUME), "give the up direction: `envelope(normal, …)`")
}

const OFFSET: &str = "moves the outline of each face in or out, with faces for the difference";

pub(super) static ROWS: &[Operation] = &[
    extrudes(with(
        Effect::Extrudes,
        moves(op("extrude", "extrude", &[length("distance")], "extrudes each face along its normal")),
    )),
    upright(extrudes(op(
        "extrude",
        "extrude_along",
        &[EXTRUDE_ALONG, length("distance")],
        "extrudes faces along normals or upwards",
    ))),
    old(
        upright(extrudes(op("extrude", "extrude_axis", &[EXTRUDE_AXIS, length("distance")], "extrudes along an axis"))),
        "write `extrude(world.up, …)` to extrude upwards",
    ),
    with(
        Effect::Fills,
        rigid(op("i", "insert", &[INSERTED], "replaces the geometry by an asset that fills the scope")),
    ),
    rigid(op(
        "i",
        "insert_with",
        &[
            INSERTED,
            UP_AXIS,
            or(INSERT_MODE, Default::Word("alignSizeAndPosition")),
            or(CLEANUP_MODE, Default::Word("numericalCleanup")),
        ],
        "replaces the geometry by an asset, optionally with its own up axis, size and position",
    )),
    along_uv("insert_along_uv", &[uv_set("uvSet"), FILE, float("height")]),
    along_uv("insert_along_uv_with", &[uv_set("uvSet"), FILE, float("height"), HEIGHT_DIRECTION, HEIGHT_ALIGNMENT]),
    primitive("primitiveQuad", "quad", &[], "replaces the geometry by a rectangle that fills the scope"),
    primitive(
        "primitiveQuad",
        "quad_sized",
        &[float("width"), float("length")],
        "replaces the geometry by a rectangle of that size",
    ),
    primitive(
        "primitiveDisk",
        "disk",
        &[or(N_VERTICES, SIXTEEN)],
        "replaces the geometry by a disk that fills the scope",
    ),
    primitive(
        "primitiveDisk",
        "disk_sized",
        &[N_VERTICES, float("radius")],
        "replaces the geometry by a disk of that size",
    ),
    with(
        Effect::FillsWithBox,
        primitive("primitiveCube", "cube", &[], "replaces the geometry by a box that fills the scope"),
    ),
    primitive(
        "primitiveCube",
        "cube_sized",
        &[float("width"), float("height"), float("depth")],
        "replaces the geometry by a box of that size",
    ),
    filling("primitiveSphere", "sphere", &[], SPHERE),
    filling("primitiveSphere", "sphere_sides", &[SIDES, N_DIVISIONS], SPHERE),
    primitive(
        "primitiveSphere",
        "sphere_sized",
        &[SIDES, N_DIVISIONS, float("radius")],
        "replaces the geometry by a sphere of that size",
    ),
    filling("primitiveCylinder", "cylinder", &[], "replaces the geometry by a cylinder that fills the scope"),
    filling(
        "primitiveCylinder",
        "cylinder_sides",
        &[SIDES],
        "replaces the geometry by a cylinder that fills the scope, with the given number of sides",
    ),
    primitive(
        "primitiveCylinder",
        "cylinder_sized",
        &[SIDES, float("radius"), float("height")],
        "replaces the geometry by a cylinder of that size",
    ),
    filling("primitiveCone", "cone", &[or(SIDES, SIXTEEN)], "replaces the geometry by a cone that fills the scope"),
    primitive(
        "primitiveCone",
        "cone_sized",
        &[SIDES, float("radius"), float("height")],
        "replaces the geometry by a cone of that size",
    ),
    tagging(
        &["taper.bottom", "taper.side"],
        rigid(keeps_uvs(op("taper", "taper", &[float("height")], "makes a pyramid over the first face"))),
    ),
    // Only the form with a selector makes an occluder (*offset operation*).
    rigid(keeps_uvs(op("offset", "offset", &[float("distance")], OFFSET))),
    rigid(keeps_uvs(op("offset", "offset_selected", &[float("distance"), KEEP_FACES], OFFSET))),
    upright(with(
        Effect::Flattens,
        op("footprint", "footprint", &[], "replaces the geometry by its outline seen from above"),
    )),
    envelope("envelope_front", first(4, ENVELOPE), VOLUME),
    envelope("envelope_front_back", first(6, ENVELOPE), VOLUME),
    envelope("envelope_sides", ENVELOPE_SIDES, VOLUME),
    envelope("envelope_all", ENVELOPE, VOLUME),
    envelope(
        "envelope_edges",
        &[
            DIRECTION,
            MAX_HEIGHT,
            within(of("baseHeights", FS), &EACH_BASE_HEIGHT),
            within(of("angles", FS), &EACH_SLOPE_ANGLE),
        ],
        "makes the largest volume that the limits allow, with heights and angles edge by edge",
    ),
    // Without a direction, as before 2013.1 (*CGA changelog*).
    undirected("envelope_old_front", first(4, ENVELOPE)),
    undirected("envelope_old_front_back", first(6, ENVELOPE)),
    undirected("envelope_old_sides", ENVELOPE_SIDES),
    undirected("envelope_old_all", ENVELOPE),
];
