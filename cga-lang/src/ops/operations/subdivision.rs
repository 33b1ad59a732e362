//! Geometry subdivision.

use super::super::queries::SPACE;
use super::super::{
    Allowed, BS, Braces, Default, FS, Measure, Operation, Param, ParamBounds, ParamKind, SelectorPlaces, Str, Uses,
    bounds, float, length, of, or, param, renamed, unknown, uv_set, within, word,
};
use super::{block, divides, joins, old, op, recomposes, rigid, tagging};
use crate::diag::code::Code;

pub(super) const COMPONENT: Param = renamed(
    &[
        ("f", "Faces"),
        ("e", "Edges"),
        ("fe", "FaceEdges"),
        ("v", "Vertices"),
        ("fv", "FaceVertices"),
        ("g", "Groups"),
        ("m", "Materials"),
        ("h", "Holes"),
    ],
    word("component", "Components", &["f", "e", "fe", "v", "fv", "g", "m", "h"]),
);

const AXIS: Param = unknown(Code::UnknownAxis, word("splitAxis", "Axis", &["x", "y", "z"]));

const UV_AXIS: Param = word("splitAxis", "UvAxis", &["u", "v"]);

const ADJUST: Param = or(word("adjustSelector", "Adjust", &["adjust", "noAdjust"]), Default::Word("adjust"));

const SCOPE_ALIGNMENT: Param =
    or(renamed(&[("noAlign", "Keep")], word("scopeAlignment", "Align", &["zUp", "noAlign"])), Default::Word("zUp"));

const ALIGNMENT: Param = word("alignment", "RectangleAlignment", &["scope", "edge"]);

const DOMAIN: Param = word("domain", "ScatterDomain", &["surface", "volume", "scope"]);

const DISTRIBUTION: Param = word("distributionType", "Distribution", &["uniform", "gaussian"]);

const GAUSSIAN: Param = word("distributionType", "Distribution", &["gaussian"]);

const MEAN: Param = word("scatterMean", "ScatterMean", &["center", "front", "back", "left", "right", "top", "bottom"]);

/// *setbackToArea operation*.
static AREAS: ParamBounds = bounds(Allowed::Above(0.0), "an area is above 0");

/// *CGA changelog 2017.0*.
static COUNTS: ParamBounds = ParamBounds {
    result: Some("no points are made"),
    ..bounds(Allowed::AtLeast(0.0), "the number of points is not negative; a fraction is rounded down")
};

/// *setback operation*.
static DISTANCES: ParamBounds =
    ParamBounds { result: Some("no edge is set back"), ..bounds(Allowed::Above(0.0), "a distance is above 0") };

/// *setback operation*: in an array, 0 is the distance of an edge that stays.
static EACH_DISTANCES: ParamBounds = ParamBounds { element: Some(&ELEMENTS), ..DISTANCES };
static ELEMENTS: ParamBounds = ParamBounds {
    result: Some("an edge with this distance is not set back"),
    ..bounds(Allowed::AtLeast(0.0), "a distance is at least 0")
};

/// *setbackToArea operation*.
static MIN_DISTANCES: ParamBounds = ParamBounds {
    result: Some("the distance begins at 0"),
    ..bounds(Allowed::AtLeast(0.0), "a minimum distance is at least 0")
};
static MAX_DISTANCES: ParamBounds = ParamBounds {
    element: Some(&ELEMENTS),
    result: Some("no edge is set back"),
    ..bounds(Allowed::Above(0.0), "a maximum distance is above 0")
};

/// *shapeL, shapeU, shapeO operations*.
static WIDTHS: ParamBounds = ParamBounds {
    result: Some("these edges are not set back"),
    ..bounds(Allowed::AtLeast(0.0), "a width is at least 0")
};

/// *scatter operation*.
static DEVIATIONS: ParamBounds = ParamBounds {
    result: Some("its sign has no meaning"),
    ..bounds(Allowed::AtLeast(0.0), "a deviation is at least 0")
};

const DISTANCE: Param = within(float("distance"), &DISTANCES);
const EDGE_DISTANCE: Param = within(param("distance", ParamKind::PerEdge), &DISTANCES);
const MIN_DISTANCE: Param = within(of("minDistances", FS), &MIN_DISTANCES);
const AREA: Param = within(float("area"), &AREAS);
const N_POINTS: Param = within(float("nPoints"), &COUNTS);
const UV_SET: Param = or(uv_set("uvSet"), Default::Float(0.0));

const TO_AREA: &str = "sets edges back until the remainder has that area";

/// The tags of all operations that set edges back.
const SETBACK_TAGS: &[&str] = &["setback.front", "setback.back", "setback.side", "setback.remainder"];

/// The width of a wing.
const fn width(name: Str) -> Param {
    within(float(name), &WIDTHS)
}

/// The row of an operation that sets edges back.
const fn sets_back(call: Str, uses: Uses, row: Operation) -> Operation {
    tagging(SETBACK_TAGS, divides(call, uses, row))
}

pub(super) static ROWS: &[Operation] = &[
    divides(
        "split",
        Uses::NONE,
        block("split", Braces::Slots(Measure::Length), &[AXIS, ADJUST], "divides the shape along an axis"),
    ),
    divides(
        "texture",
        Uses::WHOLE.and(Uses::PLACE),
        block(
            "split",
            Braces::Slots(Measure::Texture),
            &[UV_AXIS, SPACE, UV_SET],
            "divides the shape in texture space",
        ),
    ),
    divides(
        "areas",
        Uses::WHOLE,
        block(
            "splitArea",
            Braces::Slots(Measure::Area),
            &[AXIS, ADJUST],
            "divides the shape along an axis into parts of given areas",
        ),
    ),
    divides(
        "comp",
        Uses::WHOLE,
        block(
            "comp",
            Braces::Components,
            &[COMPONENT, SCOPE_ALIGNMENT],
            "divides the shape into faces, edges, vertices or other components",
        ),
    ),
    sets_back(
        "perimeter",
        Uses::WHOLE.and(Uses::DRAWS),
        block(
            "splitAndSetbackPerimeter",
            Braces::Sections,
            &[length("splitOffset")],
            "divides the outline into sections and sets each back",
        ),
    ),
    sets_back(
        "perimeter_of",
        Uses::WHOLE.and(Uses::DRAWS),
        block(
            "splitAndSetbackPerimeter",
            Braces::Sections,
            &[length("splitOffset"), float("firstEdgeIndex"), of("selectedEdgesMask", BS)],
            "divides some edges of the outline into sections and sets each back",
        ),
    ),
    sets_back(
        "setback",
        Uses::WHOLE,
        block("setback", Braces::Arms(SelectorPlaces::SETBACK), &[DISTANCE, UV_SET], "sets edges back by a distance"),
    ),
    sets_back(
        "setback_each",
        Uses::WHOLE,
        block(
            "setback",
            Braces::Arms(SelectorPlaces::SETBACK),
            &[within(of("distances", FS), &EACH_DISTANCES), UV_SET],
            "sets edges back, each face edge by a distance of its own",
        ),
    ),
    sets_back(
        "setback_per_edge",
        Uses::WHOLE,
        block(
            "setbackPerEdge",
            Braces::Arms(SelectorPlaces::SETBACK),
            &[EDGE_DISTANCE, UV_SET],
            "sets edges back by a distance that is computed on each",
        ),
    ),
    sets_back(
        "setback_to_area",
        Uses::WHOLE,
        block("setbackToArea", Braces::Arms(SelectorPlaces::SETBACK), &[AREA, UV_SET], TO_AREA),
    ),
    sets_back(
        "setback_to_area_from",
        Uses::WHOLE,
        block("setbackToArea", Braces::Arms(SelectorPlaces::SETBACK), &[AREA, MIN_DISTANCE, UV_SET], TO_AREA),
    ),
    sets_back(
        "setback_to_area_between",
        Uses::WHOLE,
        block(
            "setbackToArea",
            Braces::Arms(SelectorPlaces::SETBACK),
            &[AREA, MIN_DISTANCE, within(of("maxDistances", FS), &MAX_DISTANCES), UV_SET],
            TO_AREA,
        ),
    ),
    sets_back(
        "shape_l",
        Uses::WHOLE,
        block(
            "shapeL",
            Braces::Arms(SelectorPlaces::SHAPE),
            &[width("frontWidth"), width("leftWidth")],
            "sets the front and left edges back and keeps the strip",
        ),
    ),
    sets_back(
        "shape_u",
        Uses::WHOLE,
        block(
            "shapeU",
            Braces::Arms(SelectorPlaces::SHAPE),
            &[width("frontWidth"), width("rightWidth"), width("leftWidth")],
            "sets all but the back edges back and keeps the strip",
        ),
    ),
    sets_back(
        "shape_o",
        Uses::WHOLE,
        block(
            "shapeO",
            Braces::Arms(SelectorPlaces::SHAPE),
            &[width("frontWidth"), width("rightWidth"), width("backWidth"), width("leftWidth")],
            "sets all edges back and keeps the strip",
        ),
    ),
    divides(
        "inner_rectangle",
        Uses::WHOLE,
        block(
            "innerRectangle",
            Braces::Arms(SelectorPlaces::SHAPE),
            &[ALIGNMENT],
            "cuts the largest rectangle out of each face",
        ),
    ),
    old(
        rigid(op("innerRect", "inner_rect", &[], "replaces each face by its largest rectangle along the scope")),
        "write `innerRectangle(scope) { shape : … }`",
    ),
    divides(
        "scatter",
        Uses::WHOLE.and(Uses::DRAWS),
        block(
            "scatter",
            Braces::Ops,
            &[DOMAIN, N_POINTS, DISTRIBUTION],
            "places random points on the surface, in the volume or in the scope",
        ),
    ),
    divides(
        "scatter_around",
        Uses::WHOLE.and(Uses::DRAWS),
        block(
            "scatter",
            Braces::Ops,
            &[DOMAIN, N_POINTS, GAUSSIAN, MEAN, within(length("scatterStddev"), &DEVIATIONS)],
            "places random points around a position",
        ),
    ),
    recomposes(joins(
        "modify",
        block(
            "modify",
            Braces::Modified,
            &[COMPONENT, SCOPE_ALIGNMENT],
            "changes components where they are and joins them up again",
        ),
    )),
];
