//! Geometry creation: extrusion, assets, primitives, envelopes.

use super::super::{
    Allowed, Bounds, Default, Effect, FILE, FS, FileUse, Operation, Param, Uses, UvEffect, bounds, file, float, length,
    of, or, outdated, renamed, uv_set, within, word, words,
};
use super::{later, moves, old, op, using, uvs, with};

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

const DIRECTION: Param = words("direction", &["normal", "world.up"]);

const KEEP_FACES: Param = word("keepFaces", "OffsetFaces", &["all", "inside", "border"]);

/// *primitiveDisk*, *primitiveSphere*, *primitiveCylinder* and *primitiveCone operation*.
static CORNERS: Bounds = bounds(Allowed::AtLeast(3.0), "there are at least 3");

/// *primitiveSphere operation*.
static DIVISIONS: Bounds = bounds(Allowed::AtLeast(2.0), "there are at least 2");

const N_VERTICES: Param = within(float("nVertices"), &CORNERS);
const SIDES: Param = within(float("sides"), &CORNERS);
const N_DIVISIONS: Param = within(float("divisions"), &DIVISIONS);

const SIXTEEN: Default = Default::Float(16.0);

/// Assets are trimmed at the trim planes of the shape.
const FROM_FILE: Uses = Uses::WHOLE.and(Uses::SAYS);

const NO_DIRECTION: &str = "give the up direction: `envelope(normal, …)`";

const INSERTED: Param = file("filePath", FileUse::Inserted);

/// The row of an operation whose new faces have no texture coordinates.
const fn keeps_uvs(row: Operation) -> Operation {
    uvs(UvEffect::Keeps, row)
}

/// A primitive. It only has the first uv set (*primitiveCube operation*).
const fn primitive(name: &'static str, call: &'static str, params: &'static [Param], about: &'static str) -> Operation {
    uvs(UvEffect::First, op(name, call, params, about))
}

pub(super) static ROWS: &[Operation] = &[
    keeps_uvs(with(
        Effect::Extrudes,
        moves(op("extrude", "extrude", &[length("distance")], "extrudes each face along its normal")),
    )),
    keeps_uvs(op(
        "extrude",
        "extrude_along",
        &[EXTRUDE_ALONG, length("distance")],
        "extrudes faces along normals or upwards",
    )),
    old(
        keeps_uvs(op("extrude", "extrude_axis", &[EXTRUDE_AXIS, length("distance")], "extrudes along an axis")),
        "write `extrude(world.up, …)` to extrude upwards",
    ),
    with(
        Effect::Fills,
        using(FROM_FILE, op("i", "insert", &[INSERTED], "replaces the geometry by an asset that fills the scope")),
    ),
    using(
        FROM_FILE,
        op(
            "i",
            "insert_with",
            &[
                INSERTED,
                UP_AXIS,
                or(INSERT_MODE, Default::Word("alignSizeAndPosition")),
                or(CLEANUP_MODE, Default::Word("numericalCleanup")),
            ],
            "replaces the geometry by an asset, which may lie down or keep its size and place",
        ),
    ),
    uvs(
        UvEffect::Follows,
        op(
            "insertAlongUV",
            "insert_along_uv",
            &[uv_set("uvSet"), FILE, float("height")],
            "bends copies of an asset along texture coordinates",
        ),
    ),
    uvs(
        UvEffect::Follows,
        op(
            "insertAlongUV",
            "insert_along_uv_with",
            &[uv_set("uvSet"), FILE, float("height"), HEIGHT_DIRECTION, HEIGHT_ALIGNMENT],
            "bends copies of an asset along texture coordinates",
        ),
    ),
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
    with(
        Effect::Fills,
        primitive("primitiveSphere", "sphere", &[], "replaces the geometry by a sphere that fills the scope"),
    ),
    with(
        Effect::Fills,
        primitive(
            "primitiveSphere",
            "sphere_sides",
            &[SIDES, N_DIVISIONS],
            "replaces the geometry by a sphere that fills the scope",
        ),
    ),
    primitive(
        "primitiveSphere",
        "sphere_sized",
        &[SIDES, N_DIVISIONS, float("radius")],
        "replaces the geometry by a sphere of that size",
    ),
    with(
        Effect::Fills,
        primitive("primitiveCylinder", "cylinder", &[], "replaces the geometry by a cylinder that fills the scope"),
    ),
    with(
        Effect::Fills,
        primitive(
            "primitiveCylinder",
            "cylinder_sides",
            &[SIDES],
            "replaces the geometry by a cylinder that fills the scope, with the given number of sides",
        ),
    ),
    primitive(
        "primitiveCylinder",
        "cylinder_sized",
        &[SIDES, float("radius"), float("height")],
        "replaces the geometry by a cylinder of that size",
    ),
    with(
        Effect::Fills,
        primitive(
            "primitiveCone",
            "cone",
            &[or(SIDES, SIXTEEN)],
            "replaces the geometry by a cone that fills the scope",
        ),
    ),
    primitive(
        "primitiveCone",
        "cone_sized",
        &[SIDES, float("radius"), float("height")],
        "replaces the geometry by a cone of that size",
    ),
    keeps_uvs(op("taper", "taper", &[float("height")], "makes a pyramid over the first face")),
    keeps_uvs(op(
        "offset",
        "offset",
        &[float("distance"), or(KEEP_FACES, Default::Word("all"))],
        "moves the outline of each face in or out, with faces for the difference",
    )),
    later("footprint", &[], "replaces the geometry by its outline seen from above"),
    later(
        "envelope",
        &[DIRECTION, float("maxHeight"), float("frontBaseHeight"), float("frontAngle")],
        "makes the volume that may be built on",
    ),
    later(
        "envelope",
        &[
            DIRECTION,
            float("maxHeight"),
            float("frontBaseHeight"),
            float("frontAngle"),
            float("backBaseHeight"),
            float("backAngle"),
        ],
        "makes the volume that may be built on",
    ),
    later(
        "envelope",
        &[
            DIRECTION,
            float("maxHeight"),
            float("frontBaseHeight"),
            float("frontAngle"),
            float("backBaseHeight"),
            float("backAngle"),
            float("sideBaseHeight"),
            float("sideAngle"),
        ],
        "makes the volume that may be built on",
    ),
    later(
        "envelope",
        &[
            DIRECTION,
            float("maxHeight"),
            float("frontBaseHeight"),
            float("frontAngle"),
            float("backBaseHeight"),
            float("backAngle"),
            float("rightBaseHeight"),
            float("rightAngle"),
            float("leftBaseHeight"),
            float("leftAngle"),
        ],
        "makes the volume that may be built on",
    ),
    later(
        "envelope",
        &[DIRECTION, float("maxHeight"), of("baseHeights", FS), of("angles", FS)],
        "makes the volume that may be built on, with heights and angles edge by edge",
    ),
    // Without a direction, as before 2013.1 (*CGA changelog*).
    old(
        later(
            "envelope",
            &[float("maxHeight"), float("frontBaseHeight"), float("frontAngle")],
            "makes the volume that may be built on",
        ),
        NO_DIRECTION,
    ),
    old(
        later(
            "envelope",
            &[
                float("maxHeight"),
                float("frontBaseHeight"),
                float("frontAngle"),
                float("backBaseHeight"),
                float("backAngle"),
            ],
            "makes the volume that may be built on",
        ),
        NO_DIRECTION,
    ),
    old(
        later(
            "envelope",
            &[
                float("maxHeight"),
                float("frontBaseHeight"),
                float("frontAngle"),
                float("backBaseHeight"),
                float("backAngle"),
                float("sideBaseHeight"),
                float("sideAngle"),
            ],
            "makes the volume that may be built on",
        ),
        NO_DIRECTION,
    ),
    old(
        later(
            "envelope",
            &[
                float("maxHeight"),
                float("frontBaseHeight"),
                float("frontAngle"),
                float("backBaseHeight"),
                float("backAngle"),
                float("rightBaseHeight"),
                float("rightAngle"),
                float("leftBaseHeight"),
                float("leftAngle"),
            ],
            "makes the volume that may be built on",
        ),
        NO_DIRECTION,
    ),
];
