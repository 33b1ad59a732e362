//! Geometry manipulation, tags, inlined rules and boolean operations.

use super::super::{
    Allowed, Braces, Default, Effect, Operation, Param, ParamBounds, Str, TAG_QUERY, Uses, UvEffect, boolean, bounds,
    float, or, text, within, word,
};
use super::{block, joins, keeps, old, op, reads_tags, recomposes, rigid, tagging, using, uvs, with};

/// *cleanupGeometry* and *reduceGeometry operation*.
static TOLERANCES: ParamBounds = bounds(Allowed::Between(0.0, 1.0), "it is from 0 to 1");

/// *rectify operation*.
static DEVIATIONS: ParamBounds = bounds(Allowed::Between(0.0, 45.0), "it is from 0 to 45 degrees");

/// *convexify operation*.
static CUT_LENGTHS: ParamBounds =
    ParamBounds { result: Some("no face is cut"), ..bounds(Allowed::Above(0.0), "it is above 0") };

const TOLERANCE: Param = within(float("tolerance"), &TOLERANCES);

const CLEANUP: Param = word("components", "CleanupComponents", &["vertices", "edges", "faces", "all"]);

/// *softenNormals operation*.
static SMOOTH_ANGLES: ParamBounds = bounds(Allowed::Between(0.0, 180.0), "it is from 0 to 180 degrees");

const NORMALS: Param = word("normalsMode", "NormalsMode", &["hard", "conform", "soft", "auto"]);

const TAGGED: Param =
    or(word("components", "TagTarget", &["auto", "faces", "edges", "vertices"]), Default::Word("auto"));

const UNTAGGED: Param =
    or(word("components", "TaggedComponents", &["all", "faces", "edges", "vertices"]), Default::Word("all"));

const STRATEGY: Param =
    or(word("geometryMergeStrategy", "MergeStrategy", &["append", "unify"]), Default::Word("append"));

const RECOMPOSE: Param = word("geometryMergeStrategy", "MergeStrategy", &["recompose"]);

/// *Boolean 3D operations*, 2024.1.
const SWAP: Param = or(word("swapMode", "SwapMode", &["noSwap", "swap"]), Default::Word("noSwap"));

/// The initial shape and its place in the world.
const INITIAL: Uses = Uses::WHOLE.and(Uses::PLACE).and(Uses::SAYS);

const INLINE: &str = "derives a rule at once and continues with its result as one shape";
const UNION: &str = "joins the results of both sides";
const SUBTRACT: &str = "removes the result of the right side from the result of the left side";
const INTERSECT: &str = "keeps the common part of both results";

/// The tags of all boolean operations.
const BOOLEAN_TAGS: &[&str] = &["bool.A", "bool.B", "bool.cut"];

/// A boolean operation.
const fn operands(name: Str, about: Str) -> Operation {
    joins(name, tagging(BOOLEAN_TAGS, block(name, Braces::Operands, &[], about)))
}

/// The syntax up to 2024.1, where the left operand was the current shape (*CGA changelog 2025.0*).
const fn one_operand(name: Str, call: Str, about: Str) -> Operation {
    let row = joins(call, tagging(BOOLEAN_TAGS, block(name, Braces::Inline, &[SWAP], about)));
    old(row, "name both operands in braces: `{ A | B }`")
}

/// *tag operation*: wildcards are filtered out.
static TAG_NAMES: ParamBounds = ParamBounds {
    result: Some("nothing is tagged"),
    ..bounds(Allowed::TagName, "the wildcards `?` and `*` are left out of the names of tags")
};

const TAG_NAME: Param = within(text("name"), &TAG_NAMES);

/// The row of an operation that changes tags alone.
const fn tags(row: Operation) -> Operation {
    keeps(reads_tags(rigid(row)))
}

pub(super) static ROWS: &[Operation] = &[
    reads_tags(uvs(
        UvEffect::Keeps,
        op("cleanupGeometry", "cleanup_geometry", &[CLEANUP, TOLERANCE], "merges parts that are nearly the same"),
    )),
    with(Effect::KeepsSize, rigid(op("convexify", "convexify", &[], "cuts concave faces into convex ones"))),
    with(
        Effect::KeepsSize,
        rigid(op(
            "convexify",
            "convexify_within",
            &[within(float("maxLength"), &CUT_LENGTHS)],
            "cuts concave faces where the cut is short",
        )),
    ),
    with(Effect::KeepsSize, rigid(op("deleteHoles", "delete_holes", &[], "fills the holes of faces"))),
    with(Effect::KeepsSize, rigid(op("reverseNormals", "reverse_normals", &[], "turns every face over"))),
    with(Effect::KeepsSize, rigid(op("setNormals", "set_normals", &[NORMALS], "sets the normals of vertices"))),
    with(
        Effect::KeepsSize,
        rigid(op(
            "softenNormals",
            "soften_normals",
            &[within(float("angle"), &SMOOTH_ANGLES)],
            "smooths edges flatter than an angle",
        )),
    ),
    with(
        Effect::KeepsSize,
        rigid(op(
            "mirror",
            "mirror",
            &[boolean("xFlip"), boolean("yFlip"), boolean("zFlip")],
            "mirrors the geometry inside its scope",
        )),
    ),
    uvs(
        UvEffect::Keeps,
        rigid(op(
            "rectify",
            "rectify",
            &[within(float("angle"), &DEVIATIONS)],
            "turns edges that nearly follow the scope's axes to them",
        )),
    ),
    uvs(
        UvEffect::Keeps,
        op(
            "reduceGeometry",
            "reduce_geometry",
            &[TOLERANCE],
            "removes vertices and changes the form as little as it can",
        ),
    ),
    using(INITIAL, op("resetGeometry", "reset_geometry", &[], "takes the geometry of the initial shape again")),
    with(Effect::KeepsSize, op("trim", "trim", &[], "cuts the geometry at the trim planes")),
    tags(op("tag", "tag", &[TAG_NAME, TAGGED], "gives components a tag")),
    tags(op("deleteTags", "delete_tags", &[], "removes all tags")),
    tags(op("deleteTags", "delete_tags_of", &[TAG_QUERY, UNTAGGED], "removes the tags that match")),
    keeps(using(
        INITIAL.and(Uses::TAGS),
        op(
            "setTagsFromEdgeAttrs",
            "set_tags_from_edge_attrs",
            &[],
            "makes tags of the initial shape's edge attributes",
        ),
    )),
    joins("inline", block("inline", Braces::Inline, &[STRATEGY], INLINE)),
    recomposes(joins("inline", block("inline", Braces::Inline, &[RECOMPOSE], INLINE))),
    operands("union", UNION),
    operands("subtract", SUBTRACT),
    operands("intersect", INTERSECT),
    one_operand("union", "union_current", UNION),
    one_operand("subtract", "subtract_current", SUBTRACT),
    one_operand("intersect", "intersect_current", INTERSECT),
];
