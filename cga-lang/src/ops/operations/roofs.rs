//! Roofs. Each is by angle in degrees, or by angle or height as a word says.

use super::super::{Default, Operation, Param, boolean, float, or, word};
use super::later;

const VALUE_TYPE: Param = word("valueType", "RoofValue", &[("byAngle", "ByAngle"), ("byHeight", "ByHeight")]);

const ANGLE: Param = float("angle");
const VALUE: Param = float("value");
const OVERHANG: Param = or(float("overhang"), Default::Float(0.0));
const OVERHANG_X: Param = or(float("overhangX"), Default::Float(0.0));
const OVERHANG_Y: Param = or(float("overhangY"), Default::Float(0.0));
const EVEN: Param = or(boolean("even"), Default::Bool(false));
const INDEX: Param = or(float("index"), Default::Float(0.0));

pub(super) static ROWS: &[Operation] = &[
    later("roofGable", &[ANGLE, OVERHANG_X, OVERHANG_Y, EVEN], "builds a gable roof over each face"),
    later(
        "roofGable",
        &[ANGLE, float("overhangX"), float("overhangY"), boolean("even"), float("index")],
        "builds a gable roof with its ridge along an edge",
    ),
    later("roofGable", &[VALUE_TYPE, VALUE, OVERHANG_X, OVERHANG_Y, EVEN], "builds a gable roof over each face"),
    later("roofHip", &[ANGLE, OVERHANG, EVEN], "builds a hip roof over each face"),
    later("roofHip", &[VALUE_TYPE, VALUE, OVERHANG, EVEN], "builds a hip roof over each face"),
    later("roofPyramid", &[ANGLE], "builds a pyramid over each face"),
    later("roofPyramid", &[VALUE_TYPE, VALUE], "builds a pyramid over each face"),
    later("roofRidge", &[VALUE_TYPE, VALUE], "builds a roof with one ridge along the scope's x axis"),
    later("roofShed", &[ANGLE, INDEX], "builds a shed roof that rises from an edge"),
    later("roofShed", &[VALUE_TYPE, VALUE, INDEX], "builds a shed roof that rises from an edge"),
];
