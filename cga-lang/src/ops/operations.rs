//! The operations.

use super::{Block, Operation, Param, ParamKind, Run, float, length, param, text};

const fn op(name: &'static str, call: &'static str, params: &'static [Param], about: &'static str) -> Operation {
    Operation { name, run: Run::Now(call), params, block: Block::None, uses_base: false, old: None, about }
}

/// Every operation.
pub static OPERATIONS: &[&[Operation]] = &[SHAPE];

const CENTER_AXES: ParamKind = ParamKind::Word {
    rust: "CenterAxes",
    words: &[("x", "X"), ("y", "Y"), ("z", "Z"), ("xy", "Xy"), ("xz", "Xz"), ("yz", "Yz"), ("xyz", "Xyz")],
    old: &[],
};

const ROTATE_ABOUT: ParamKind = ParamKind::Word {
    rust: "RotateAbout",
    words: &[("scopeOrigin", "ScopeOrigin"), ("scopeCenter", "ScopeCenter")],
    old: &[],
};

const EXTRUDE_ALONG: ParamKind = ParamKind::Word {
    rust: "ExtrudeAlong",
    words: &[("face.normal", "FaceNormal"), ("world.up", "WorldUp"), ("world.y", "WorldUp")],
    old: &[("world.y", "world.up")],
};

/// The operations that change the current shape.
static SHAPE: &[Operation] = &[
    op("s", "size", &[length("x"), length("y"), length("z")], "sets the size of the scope"),
    op("t", "translate", &[length("x"), length("y"), length("z")], "moves along the axes of the scope"),
    op("r", "rotate", &[float("x"), float("y"), float("z")], "rotates about the origin of the scope, in degrees"),
    op(
        "r",
        "rotate_about",
        &[param("about", ROTATE_ABOUT), float("x"), float("y"), float("z")],
        "rotates about the origin or the centre of the scope, in degrees",
    ),
    Operation {
        uses_base: true,
        ..op(
            "center",
            "center",
            &[param("axes", CENTER_AXES)],
            "moves the centre of the scope to the centre it had before",
        )
    },
    op("color", "color_hex", &[text("rrggbb")], "sets the colour, as in \"#ff8000\""),
    op("color", "color_rgb", &[float("red"), float("green"), float("blue")], "sets the colour, each from 0 to 1"),
    op(
        "color",
        "color_rgba",
        &[float("red"), float("green"), float("blue"), float("opacity")],
        "sets colour and opacity, each from 0 to 1",
    ),
    op("extrude", "extrude", &[length("distance")], "extrudes each face along its normal"),
    op(
        "extrude",
        "extrude_along",
        &[param("along", EXTRUDE_ALONG), length("distance")],
        "extrudes each face along its normal or upwards",
    ),
    op("primitiveCube", "cube", &[], "replaces the geometry by a box that fills the scope"),
    op(
        "primitiveCube",
        "cube_sized",
        &[float("width"), float("height"), float("depth")],
        "replaces the geometry by a box of that size",
    ),
    op("primitiveCylinder", "cylinder", &[], "replaces the geometry by a cylinder that fills the scope"),
    op("primitiveCylinder", "cylinder_sides", &[float("sides")], "as many sides instead of 16"),
    op(
        "primitiveCylinder",
        "cylinder_sized",
        &[float("sides"), float("radius"), float("height")],
        "replaces the geometry by a cylinder of that size",
    ),
    op("primitiveQuad", "quad", &[], "replaces the geometry by a rectangle that fills the scope"),
    op("primitiveQuad", "quad_sized", &[float("width"), float("length")], "replaces the geometry by a rectangle"),
    op("i", "insert", &[text("file")], "replaces the geometry by an asset that fills the scope"),
    op("texture", "texture", &[text("file")], "sets the colour map"),
];
