//! Geometry creation: extrusion, assets, primitives, envelopes.

use super::super::{
    Bounds, Default, Effect, FILE, FS, Operation, Param, ParamKind, Uses, Values, bounds, float, length, of, or,
    uv_set, within, word,
};
use super::{later, moves, old, op, using, with};
use crate::code::Code;

const EXTRUDE_ALONG: ParamKind = ParamKind::Word {
    rust: "ExtrudeAlong",
    words: &[
        ("face.normal", "FaceNormal"),
        ("vertex.normal", "VertexNormal"),
        ("world.up", "WorldUp"),
        ("world.y", "WorldUp"),
        ("world.up.flatTop", "WorldUpFlatTop"),
    ],
    old: &[("world.y", "world.up")],
    unknown: Code::UnknownWord,
};

const EXTRUDE_AXIS: Param =
    word("axis", "ExtrudeAxis", &[("x", "X"), ("y", "Y"), ("z", "Z"), ("world.x", "WorldX"), ("world.z", "WorldZ")]);

const UP_AXIS: Param = word("upAxisOfGeometry", "UpAxis", &[("yUp", "YUp"), ("zUp", "ZUp")]);

const INSERT_MODE: Param = word(
    "insertMode",
    "InsertMode",
    &[
        ("alignSizeAndPosition", "AlignSizeAndPosition"),
        ("keepSizeAndPosition", "KeepSizeAndPosition"),
        ("keepSizeAlignPosition", "KeepSizeAlignPosition"),
    ],
);

const CLEANUP_MODE: Param =
    word("cleanupMode", "CleanupMode", &[("numericalCleanup", "NumericalCleanup"), ("noCleanup", "NoCleanup")]);

const HEIGHT_DIRECTION: Param =
    word("heightDirection", "HeightDirection", &[("scope.y", "ScopeY"), ("vertex.normal", "VertexNormal")]);

const HEIGHT_ALIGNMENT: Param =
    word("heightAlignment", "HeightAlignment", &[("alignPosition", "AlignPosition"), ("keepPosition", "KeepPosition")]);

const DIRECTION: Param = word("direction", "EnvelopeDirection", &[("normal", "Normal"), ("world.up", "WorldUp")]);

const KEEP_FACES: Param =
    word("keepFaces", "OffsetFaces", &[("all", "All"), ("inside", "Inside"), ("border", "Border")]);

/// *primitiveDisk*, *primitiveSphere*, *primitiveCylinder* and *primitiveCone operation*.
static CORNERS: Bounds = bounds(Values::AtLeast(3.0), "there are at least 3");

/// *primitiveSphere operation*.
static DIVISIONS: Bounds = bounds(Values::AtLeast(2.0), "there are at least 2");

const N_VERTICES: Param = within(float("nVertices"), &CORNERS);
const SIDES: Param = within(float("sides"), &CORNERS);
const N_DIVISIONS: Param = within(float("divisions"), &DIVISIONS);

const SIXTEEN: Default = Default::Float(16.0);

/// Assets are trimmed at the planes of the shape.
const FROM_FILE: Uses = Uses::WHOLE.and(Uses::SAYS);

const NO_DIRECTION: &str = "say which way is up: `envelope(normal, …)`";

pub(super) static ROWS: &[Operation] = &[
    moves(op("extrude", "extrude", &[length("distance")], "extrudes each face along its normal")),
    op(
        "extrude",
        "extrude_along",
        &[super::super::param("extrusionType", EXTRUDE_ALONG), length("distance")],
        "extrudes faces along normals or upwards",
    ),
    old(
        op("extrude", "extrude_axis", &[EXTRUDE_AXIS, length("distance")], "extrudes along an axis"),
        "write `extrude(world.up, …)` to extrude upwards",
    ),
    with(
        Effect::Fills,
        using(FROM_FILE, op("i", "insert", &[FILE], "replaces the geometry by an asset that fills the scope")),
    ),
    using(
        FROM_FILE,
        op(
            "i",
            "insert_with",
            &[
                FILE,
                UP_AXIS,
                or(INSERT_MODE, Default::Word("alignSizeAndPosition")),
                or(CLEANUP_MODE, Default::Word("numericalCleanup")),
            ],
            "replaces the geometry by an asset, which may lie down or keep its size and place",
        ),
    ),
    op(
        "insertAlongUV",
        "insert_along_uv",
        &[uv_set("uvSet"), FILE, float("height")],
        "bends copies of an asset along texture coordinates",
    ),
    op(
        "insertAlongUV",
        "insert_along_uv_with",
        &[uv_set("uvSet"), FILE, float("height"), HEIGHT_DIRECTION, HEIGHT_ALIGNMENT],
        "bends copies of an asset along texture coordinates",
    ),
    op("primitiveQuad", "quad", &[], "replaces the geometry by a rectangle that fills the scope"),
    op(
        "primitiveQuad",
        "quad_sized",
        &[float("width"), float("length")],
        "replaces the geometry by a rectangle of that size",
    ),
    op("primitiveDisk", "disk", &[or(N_VERTICES, SIXTEEN)], "replaces the geometry by a disk that fills the scope"),
    op("primitiveDisk", "disk_sized", &[N_VERTICES, float("radius")], "replaces the geometry by a disk of that size"),
    with(Effect::FillsWithBox, op("primitiveCube", "cube", &[], "replaces the geometry by a box that fills the scope")),
    op(
        "primitiveCube",
        "cube_sized",
        &[float("width"), float("height"), float("depth")],
        "replaces the geometry by a box of that size",
    ),
    with(Effect::Fills, op("primitiveSphere", "sphere", &[], "replaces the geometry by a sphere that fills the scope")),
    with(
        Effect::Fills,
        op(
            "primitiveSphere",
            "sphere_sides",
            &[SIDES, N_DIVISIONS],
            "replaces the geometry by a sphere that fills the scope",
        ),
    ),
    op(
        "primitiveSphere",
        "sphere_sized",
        &[SIDES, N_DIVISIONS, float("radius")],
        "replaces the geometry by a sphere of that size",
    ),
    with(
        Effect::Fills,
        op("primitiveCylinder", "cylinder", &[], "replaces the geometry by a cylinder that fills the scope"),
    ),
    with(
        Effect::Fills,
        op(
            "primitiveCylinder",
            "cylinder_sides",
            &[SIDES],
            "replaces the geometry by a cylinder that fills the scope, with so many sides",
        ),
    ),
    op(
        "primitiveCylinder",
        "cylinder_sized",
        &[SIDES, float("radius"), float("height")],
        "replaces the geometry by a cylinder of that size",
    ),
    with(
        Effect::Fills,
        op("primitiveCone", "cone", &[or(SIDES, SIXTEEN)], "replaces the geometry by a cone that fills the scope"),
    ),
    op(
        "primitiveCone",
        "cone_sized",
        &[SIDES, float("radius"), float("height")],
        "replaces the geometry by a cone of that size",
    ),
    later("taper", &[float("height")], "makes a pyramid over the first face"),
    op(
        "offset",
        "offset",
        &[float("distance"), or(KEEP_FACES, Default::Word("all"))],
        "moves the outline of each face in or out, with faces for the difference",
    ),
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
