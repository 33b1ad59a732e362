//! Geometry subdivision. `split`, `splitArea` and `comp` have a syntax of their own.

use super::super::{
    BS, Block, Bounds, Default, FS, Operation, Param, ParamKind, Places, Values, bounds, float, length, of, or, param,
    uv_set, within, words,
};
use super::{block, later, old};

pub(super) const COMPONENT: Param = words("component", &["f", "e", "fe", "v", "fv", "g", "m", "h"]);

const SCOPE_ALIGNMENT: Param = or(words("scopeAlignment", &["zUp", "noAlign"]), Default::Word("zUp"));

const ALIGNMENT: Param = words("alignment", &["scope", "edge"]);

const DOMAIN: Param = words("domain", &["surface", "volume", "scope"]);

const DISTRIBUTION: Param = words("distributionType", &["uniform", "gaussian"]);

const GAUSSIAN: Param = words("distributionType", &["gaussian"]);

const MEAN: Param = words("scatterMean", &["center", "front", "back", "left", "right", "top", "bottom"]);

/// *setbackToArea operation*.
static AREAS: Bounds = bounds(Values::Above(0.0), "an area is above 0");

/// *CGA changelog 2017.0*.
static COUNTS: Bounds =
    Bounds { result: Some("no points are made"), ..bounds(Values::Above(0.0), "the number of points is above 0") };

const AREA: Param = within(float("area"), &AREAS);
const N_POINTS: Param = within(float("nPoints"), &COUNTS);
const UV_SET: Param = or(uv_set("uvSet"), Default::Float(0.0));

const TO_AREA: &str = "sets edges back until the remainder has that area";

pub(super) static ROWS: &[Operation] = &[
    block(
        "splitAndSetbackPerimeter",
        Block::Sections,
        &[length("splitOffset")],
        "divides the outline into sections and sets each back",
    ),
    block(
        "splitAndSetbackPerimeter",
        Block::Sections,
        &[length("splitOffset"), float("firstEdgeIndex"), of("selectedEdgesMask", BS)],
        "divides some edges of the outline into sections and sets each back",
    ),
    block("setback", Block::Arms(Places::SETBACK), &[float("distance"), UV_SET], "sets edges back by a distance"),
    block(
        "setback",
        Block::Arms(Places::SETBACK),
        &[of("distances", FS), UV_SET],
        "sets edges back, each face edge by a distance of its own",
    ),
    block(
        "setbackPerEdge",
        Block::Arms(Places::SETBACK),
        &[param("distance", ParamKind::PerEdge), UV_SET],
        "sets edges back by a distance that is computed on each",
    ),
    block("setbackToArea", Block::Arms(Places::SETBACK), &[AREA, UV_SET], TO_AREA),
    block("setbackToArea", Block::Arms(Places::SETBACK), &[AREA, of("minDistances", FS), UV_SET], TO_AREA),
    block(
        "setbackToArea",
        Block::Arms(Places::SETBACK),
        &[AREA, of("minDistances", FS), of("maxDistances", FS), UV_SET],
        TO_AREA,
    ),
    block(
        "shapeL",
        Block::Arms(Places::SHAPE),
        &[float("frontWidth"), float("leftWidth")],
        "sets the front and left edges back and keeps the strip",
    ),
    block(
        "shapeU",
        Block::Arms(Places::SHAPE),
        &[float("frontWidth"), float("rightWidth"), float("leftWidth")],
        "sets all but the back edges back and keeps the strip",
    ),
    block(
        "shapeO",
        Block::Arms(Places::SHAPE),
        &[float("frontWidth"), float("rightWidth"), float("backWidth"), float("leftWidth")],
        "sets all edges back and keeps the strip",
    ),
    block("innerRectangle", Block::Arms(Places::SHAPE), &[ALIGNMENT], "cuts the largest rectangle out of each face"),
    old(
        later("innerRect", &[], "replaces each face by its largest rectangle along the scope"),
        "write `innerRectangle(scope) { shape : … }`",
    ),
    block(
        "scatter",
        Block::Ops,
        &[DOMAIN, N_POINTS, DISTRIBUTION],
        "strews points over the surface, the volume or the scope",
    ),
    block(
        "scatter",
        Block::Ops,
        &[DOMAIN, N_POINTS, GAUSSIAN, MEAN, length("scatterStddev")],
        "strews points around a place",
    ),
    block(
        "modify",
        Block::Components,
        &[COMPONENT, SCOPE_ALIGNMENT],
        "changes components where they are and joins them up again",
    ),
];
