//! Geometry subdivision. `split`, `splitArea` and `comp` have a syntax of their own.

use super::super::{BS, Block, Default, FS, Operation, Param, ParamKind, float, length, of, or, param, word};
use super::{block, later, old};

pub(super) const COMPONENT: Param = word(
    "component",
    "CompKind",
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
);

const SCOPE_ALIGNMENT: Param =
    or(word("scopeAlignment", "CompAlign", &[("zUp", "ZUp"), ("noAlign", "NoAlign")]), Default::Word("zUp"));

const ALIGNMENT: Param = word("alignment", "RectangleAlign", &[("scope", "Scope"), ("edge", "Edge")]);

const DOMAIN: Param =
    word("domain", "ScatterDomain", &[("surface", "Surface"), ("volume", "Volume"), ("scope", "Scope")]);

const DISTRIBUTION: Param =
    word("distributionType", "Distribution", &[("uniform", "Uniform"), ("gaussian", "Gaussian")]);

const GAUSSIAN: Param = word("distributionType", "Distribution", &[("gaussian", "Gaussian")]);

const MEAN: Param = word(
    "scatterMean",
    "ScatterMean",
    &[
        ("center", "Center"),
        ("front", "Front"),
        ("back", "Back"),
        ("left", "Left"),
        ("right", "Right"),
        ("top", "Top"),
        ("bottom", "Bottom"),
    ],
);

const UV_SET: Param = or(float("uvSet"), Default::Float(0.0));

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
    block("setback", Block::Arms, &[float("distance"), UV_SET], "sets edges back by a distance"),
    block(
        "setback",
        Block::Arms,
        &[of("distances", FS), UV_SET],
        "sets edges back, each face edge by a distance of its own",
    ),
    block(
        "setbackPerEdge",
        Block::Arms,
        &[param("distance", ParamKind::PerEdge), UV_SET],
        "sets edges back by a distance that is computed on each",
    ),
    block("setbackToArea", Block::Arms, &[float("area"), UV_SET], TO_AREA),
    block("setbackToArea", Block::Arms, &[float("area"), of("minDistances", FS), UV_SET], TO_AREA),
    block(
        "setbackToArea",
        Block::Arms,
        &[float("area"), of("minDistances", FS), of("maxDistances", FS), UV_SET],
        TO_AREA,
    ),
    block(
        "shapeL",
        Block::Arms,
        &[float("frontWidth"), float("leftWidth")],
        "sets the front and left edges back and keeps the strip",
    ),
    block(
        "shapeU",
        Block::Arms,
        &[float("frontWidth"), float("rightWidth"), float("leftWidth")],
        "sets all but the back edges back and keeps the strip",
    ),
    block(
        "shapeO",
        Block::Arms,
        &[float("frontWidth"), float("rightWidth"), float("backWidth"), float("leftWidth")],
        "sets all edges back and keeps the strip",
    ),
    block("innerRectangle", Block::Arms, &[ALIGNMENT], "cuts the largest rectangle out of each face"),
    old(
        later("innerRect", &[], "replaces each face by its largest rectangle along the scope"),
        "write `innerRectangle(scope) { shape : … }`",
    ),
    block(
        "scatter",
        Block::Ops,
        &[DOMAIN, float("nPoints"), DISTRIBUTION],
        "strews points over the surface, the volume or the scope",
    ),
    block(
        "scatter",
        Block::Ops,
        &[DOMAIN, float("nPoints"), GAUSSIAN, MEAN, length("scatterStddev")],
        "strews points around a place",
    ),
    block(
        "modify",
        Block::Arms,
        &[COMPONENT, SCOPE_ALIGNMENT],
        "changes components where they are and joins them up again",
    ),
];
