//! Operations on the scope and the pivot. The geometry keeps its position.

use super::super::{
    Allowed, Default, Effect, Operation, Param, ParamBounds, Params, Str, boolean, bounds, float, or, renamed, within,
    word,
};
use super::{old, op, rigid, upright, with};

const ALIGN_AXES: Param = or(
    renamed(
        &[("x", "WorldX"), ("y", "WorldY"), ("z", "WorldZ")],
        word(
            "alignAxes",
            "AlignAxes",
            &[
                "x",
                "y",
                "z",
                "world.x",
                "world.y",
                "world.z",
                "world.xyz",
                "object.x",
                "object.y",
                "object.z",
                "object.xyz",
            ],
        ),
    ),
    Default::Word("world.xyz"),
);

const UP_AXIS: Param = word("upAxis", "UpAxis", &["yUp", "zUp"]);

const FACE: Param = word("faceSelector", "AlignFace", &["world.lowest", "largest"]);

/// `any` means the face of the selected edge, so a word must select the edge.
const FACE_BY_EDGE: Param = word("faceSelector", "AlignFace", &["world.lowest", "largest", "any"]);

const EDGE: Param = word("edgeSelector", "AlignEdge", &["world.lowest", "longest"]);

const AUTO: Param = word("mode", "AlignAuto", &["auto"]);

const BOX_AXES: Param = word("alignAxes", "BoxAxes", &["xy", "yx", "xz", "zx", "yz", "zy"]);

/// *setPivot operation*.
static CORNERS: ParamBounds = bounds(Allowed::Whole(0.0, 7.0), "corners are numbered from 0 to 7");

const AXIS_MAP: Param = word("axisMap", "AxisMap", &["xyz", "yzx", "zxy"]);

const TO_GEOMETRY: &str = "turns the scope to an edge and the normal of a face";

/// A row that the runtime function `call` implements.
const fn scope(name: Str, call: Str, params: Params, about: Str) -> Operation {
    with(Effect::MovesScope, op(name, call, params, about))
}

pub(super) static ROWS: &[Operation] = &[
    upright(scope(
        "alignScopeToAxes",
        "align_to_axes",
        &[ALIGN_AXES],
        "turns the scope to the axes of the world or the object",
    )),
    scope("alignScopeToGeometry", "align_to_indices", &[UP_AXIS, float("faceIndex"), float("edgeIndex")], TO_GEOMETRY),
    scope("alignScopeToGeometry", "align_to_face", &[UP_AXIS, FACE, float("edgeIndex")], TO_GEOMETRY),
    scope("alignScopeToGeometry", "align_to_edge", &[UP_AXIS, float("faceIndex"), EDGE], TO_GEOMETRY),
    scope("alignScopeToGeometry", "align_to_selected", &[UP_AXIS, FACE_BY_EDGE, EDGE], TO_GEOMETRY),
    // Both are deprecated since 2010.1 (*CGA changelog*).
    old(
        scope("alignScopeToGeometry", "align_to_first_edge", &[UP_AXIS, float("faceIndex")], TO_GEOMETRY),
        "name the edge too: `alignScopeToGeometry(yUp, 0, 0)`",
    ),
    old(
        scope("alignScopeToGeometry", "align_to_auto", &[UP_AXIS, AUTO], TO_GEOMETRY),
        "write `alignScopeToGeometry(yUp, any, world.lowest)`",
    ),
    scope(
        "alignScopeToGeometryBBox",
        "align_to_box",
        &[BOX_AXES],
        "turns the scope about an axis until its box is as small as can be",
    ),
    rigid(scope(
        "rotateScope",
        "rotate_scope",
        &[float("xAngle"), float("yAngle"), float("zAngle")],
        "turns the scope about the axes of the pivot, in degrees",
    )),
    scope(
        "setPivot",
        "set_pivot",
        &[AXIS_MAP, within(float("cornerIndex"), &CORNERS)],
        "puts the pivot to a corner of the scope",
    ),
    rigid(scope(
        "mirrorScope",
        "mirror_scope",
        &[boolean("xFlip"), boolean("yFlip"), boolean("zFlip")],
        "mirrors the scope around the geometry",
    )),
];
