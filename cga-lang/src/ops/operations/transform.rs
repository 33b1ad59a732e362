//! Operations that move, turn and scale.

use super::super::queries::SYSTEMS;
use super::super::{Effect, Operation, Param, float, length, word};
use super::{alone, keeps, moves, op, rigid, slim, with};

const CENTER_AXES: Param = word("axes", "CenterAxes", &["x", "y", "z", "xy", "xz", "yz", "xyz"]);

const CENTER: Param = word("center", "RotateAbout", &["scopeOrigin", "scopeCenter"]);

const MODE: Param = word("mode", "TransformMode", &["abs", "rel"]);

const SYSTEM: Param = word("coordSystem", "System", SYSTEMS);

const X_ANGLE: Param = float("xAngle");
const Y_ANGLE: Param = float("yAngle");
const Z_ANGLE: Param = float("zAngle");

pub(super) static ROWS: &[Operation] = &[
    alone(with(
        Effect::Sizes,
        moves(op("s", "size", &[length("xSize"), length("ySize"), length("zSize")], "sets the size of the scope")),
    )),
    alone(keeps(moves(op(
        "t",
        "translate",
        &[length("tx"), length("ty"), length("tz")],
        "moves along the axes of the scope",
    )))),
    keeps(op(
        "translate",
        "translate_in",
        &[MODE, SYSTEM, float("x"), float("y"), float("z")],
        "moves to a place or by an amount in a coordinate system",
    )),
    // `r` turns about the axes of the pivot, which parts of a split inherit from their parent.
    keeps(rigid(op("r", "rotate", &[X_ANGLE, Y_ANGLE, Z_ANGLE], "rotates about the origin of the scope, in degrees"))),
    keeps(rigid(op(
        "r",
        "rotate_about",
        &[CENTER, X_ANGLE, Y_ANGLE, Z_ANGLE],
        "rotates about the origin or the centre of the scope, in degrees",
    ))),
    keeps(op(
        "rotate",
        "rotate_in",
        &[MODE, SYSTEM, X_ANGLE, Y_ANGLE, Z_ANGLE],
        "turns to angles or by angles in a coordinate system, in degrees",
    )),
    Operation {
        uses_base: true,
        ..keeps(slim(op(
            "center",
            "center",
            &[CENTER_AXES],
            "moves the centre of the scope to the centre it had before",
        )))
    },
];
