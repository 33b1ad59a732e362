//! Roofs. Each has rows for an angle in degrees, and for an angle or height selected by a word.

use super::super::{
    Allowed, Default, Operation, Param, ParamBounds, Params, Str, UvEffect, boolean, bounds, float, or, within, word,
};
use super::{op, rigid, tagging, uvs};

const VALUE_TYPE: Param = word("valueType", "RoofValue", &["byAngle", "byHeight"]);

const ANGLE: Param = within(float("angle"), &ANGLES);
const VALUE: Param = within(float("value"), &VALUES);
/// A shed may fall.
const SHED_ANGLE: Param = within(float("angle"), &SHED_ANGLES);
const SHED_VALUE: Param = within(float("value"), &SHED_VALUES);
const OVERHANG: Param = or(float("overhang"), Default::Float(0.0));
const OVERHANG_X: Param = or(float("overhangX"), Default::Float(0.0));
const OVERHANG_Y: Param = or(float("overhangY"), Default::Float(0.0));
const EVEN: Param = or(boolean("even"), Default::Bool(false));
const INDEX: Param = or(float("index"), Default::Float(0.0));

/// The bounds of the form of a roof.
const fn form_bounds(values: Allowed, about: Str) -> ParamBounds {
    ParamBounds { result: Some("the shape stays as it is"), ..bounds(values, about) }
}

static ANGLES: ParamBounds = form_bounds(Allowed::Inside(0.0, 90.0), "an angle is between 0 and 90 degrees");
static HEIGHTS: ParamBounds = form_bounds(Allowed::Above(0.0), "a height is above 0");
static VALUES: ParamBounds = ParamBounds {
    with_word: &[("byAngle", &ANGLES), ("byHeight", &HEIGHTS)],
    ..form_bounds(Allowed::Above(0.0), "a height is above 0, an angle between 0 and 90 degrees")
};
static SHED_ANGLES: ParamBounds =
    form_bounds(Allowed::Sloped(90.0), "an angle is between -90 and 90 degrees, but not 0");
static SHED_HEIGHTS: ParamBounds = form_bounds(Allowed::Sloped(f64::INFINITY), "a height is not 0");
static SHED_VALUES: ParamBounds = ParamBounds {
    with_word: &[("byAngle", &SHED_ANGLES), ("byHeight", &SHED_HEIGHTS)],
    ..form_bounds(Allowed::Sloped(f64::INFINITY), "a height is not 0, an angle between -90 and 90 degrees, but not 0")
};

/// The tags of all roofs; pediments of gables are neither outer nor inner sides.
const TAGS: &[&str] = &["roof.bottom", "roof.top", "roof.side", "roof.side.outer", "roof.side.inner"];

/// A roof.
const fn roof(name: Str, call: Str, params: Params, about: Str) -> Operation {
    rigid(tagging(TAGS, uvs(UvEffect::Drops, op(name, call, params, about))))
}

pub(super) static ROWS: &[Operation] = &[
    roof("roofGable", "roof_gable", &[ANGLE, OVERHANG_X, OVERHANG_Y, EVEN], "builds a gable roof over each face"),
    roof(
        "roofGable",
        "roof_gable_along",
        &[ANGLE, float("overhangX"), float("overhangY"), boolean("even"), float("index")],
        "builds a gable roof with its ridge along an edge",
    ),
    roof(
        "roofGable",
        "roof_gable_by",
        &[VALUE_TYPE, VALUE, OVERHANG_X, OVERHANG_Y, EVEN],
        "builds a gable roof over each face",
    ),
    roof("roofHip", "roof_hip", &[ANGLE, OVERHANG, EVEN], "builds a hip roof over each face"),
    roof("roofHip", "roof_hip_by", &[VALUE_TYPE, VALUE, OVERHANG, EVEN], "builds a hip roof over each face"),
    roof("roofPyramid", "roof_pyramid", &[ANGLE], "builds a pyramid over each face"),
    roof("roofPyramid", "roof_pyramid_by", &[VALUE_TYPE, VALUE], "builds a pyramid over each face"),
    roof("roofRidge", "roof_ridge_by", &[VALUE_TYPE, VALUE], "builds a roof with one ridge along the scope's x axis"),
    roof("roofShed", "roof_shed", &[SHED_ANGLE, INDEX], "builds a shed roof that rises from an edge"),
    roof("roofShed", "roof_shed_by", &[VALUE_TYPE, SHED_VALUE, INDEX], "builds a shed roof that rises from an edge"),
];
