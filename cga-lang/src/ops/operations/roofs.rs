//! Roofs. Each has rows for an angle in degrees, and for an angle or height selected by a word.

use super::super::{Default, Operation, Param, Params, Str, UvEffect, boolean, float, or, words};
use super::{later, uvs};

const VALUE_TYPE: Param = words("valueType", &["byAngle", "byHeight"]);

const ANGLE: Param = float("angle");
const VALUE: Param = float("value");
const OVERHANG: Param = or(float("overhang"), Default::Float(0.0));
const OVERHANG_X: Param = or(float("overhangX"), Default::Float(0.0));
const OVERHANG_Y: Param = or(float("overhangY"), Default::Float(0.0));
const EVEN: Param = or(boolean("even"), Default::Bool(false));
const INDEX: Param = or(float("index"), Default::Float(0.0));

/// A roof, which is not implemented yet. Its faces have no texture coordinates.
const fn roof(name: Str, params: Params, about: Str) -> Operation {
    uvs(UvEffect::Keeps, later(name, params, about))
}

pub(super) static ROWS: &[Operation] = &[
    roof("roofGable", &[ANGLE, OVERHANG_X, OVERHANG_Y, EVEN], "builds a gable roof over each face"),
    roof(
        "roofGable",
        &[ANGLE, float("overhangX"), float("overhangY"), boolean("even"), float("index")],
        "builds a gable roof with its ridge along an edge",
    ),
    roof("roofGable", &[VALUE_TYPE, VALUE, OVERHANG_X, OVERHANG_Y, EVEN], "builds a gable roof over each face"),
    roof("roofHip", &[ANGLE, OVERHANG, EVEN], "builds a hip roof over each face"),
    roof("roofHip", &[VALUE_TYPE, VALUE, OVERHANG, EVEN], "builds a hip roof over each face"),
    roof("roofPyramid", &[ANGLE], "builds a pyramid over each face"),
    roof("roofPyramid", &[VALUE_TYPE, VALUE], "builds a pyramid over each face"),
    roof("roofRidge", &[VALUE_TYPE, VALUE], "builds a roof with one ridge along the scope's x axis"),
    roof("roofShed", &[ANGLE, INDEX], "builds a shed roof that rises from an edge"),
    roof("roofShed", &[VALUE_TYPE, VALUE, INDEX], "builds a shed roof that rises from an edge"),
];
