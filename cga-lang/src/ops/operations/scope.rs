//! The scope and the pivot: the geometry stays where it is.

use super::super::{Bounds, Default, Operation, Param, Values, boolean, bounds, float, or, within, word};
use super::{old, op};

const ALIGN_AXES: Param = or(
    word(
        "alignAxes",
        "AlignAxes",
        &[
            ("x", "WorldX"),
            ("y", "WorldY"),
            ("z", "WorldZ"),
            ("world.x", "WorldX"),
            ("world.y", "WorldY"),
            ("world.z", "WorldZ"),
            ("world.xyz", "WorldXyz"),
            ("object.x", "ObjectX"),
            ("object.y", "ObjectY"),
            ("object.z", "ObjectZ"),
            ("object.xyz", "ObjectXyz"),
        ],
    ),
    Default::Word("world.xyz"),
);

const UP_AXIS: Param = word("upAxis", "UpAxis", &[("yUp", "YUp"), ("zUp", "ZUp")]);

const FACE: Param = word("faceSelector", "AlignFace", &[("world.lowest", "WorldLowest"), ("largest", "Largest")]);

/// `any` means the face whose edge is picked, so an edge must be picked by a word.
const FACE_BY_EDGE: Param =
    word("faceSelector", "AlignFace", &[("world.lowest", "WorldLowest"), ("largest", "Largest"), ("any", "Any")]);

const EDGE: Param = word("edgeSelector", "AlignEdge", &[("world.lowest", "WorldLowest"), ("longest", "Longest")]);

const AUTO: Param = word("mode", "AlignAuto", &[("auto", "Auto")]);

const BOX_AXES: Param =
    word("alignAxes", "BoxAxes", &[("xy", "Xy"), ("yx", "Yx"), ("xz", "Xz"), ("zx", "Zx"), ("yz", "Yz"), ("zy", "Zy")]);

/// *setPivot operation*.
static CORNERS: Bounds = bounds(Values::Whole(0.0, 7.0), "corners are numbered from 0 to 7");

const AXIS_MAP: Param = word("axisMap", "AxisMap", &[("xyz", "Xyz"), ("yzx", "Yzx"), ("zxy", "Zxy")]);

const TO_GEOMETRY: &str = "turns the scope to an edge and the normal of a face";

pub(super) static ROWS: &[Operation] = &[
    op("alignScopeToAxes", "align_to_axes", &[ALIGN_AXES], "turns the scope to the axes of the world or the object"),
    op("alignScopeToGeometry", "align_to_indices", &[UP_AXIS, float("faceIndex"), float("edgeIndex")], TO_GEOMETRY),
    op("alignScopeToGeometry", "align_to_face", &[UP_AXIS, FACE, float("edgeIndex")], TO_GEOMETRY),
    op("alignScopeToGeometry", "align_to_edge", &[UP_AXIS, float("faceIndex"), EDGE], TO_GEOMETRY),
    op("alignScopeToGeometry", "align_to_selected", &[UP_AXIS, FACE_BY_EDGE, EDGE], TO_GEOMETRY),
    // Both deprecated in 2010.1 (*CGA changelog*).
    old(
        op("alignScopeToGeometry", "align_to_first_edge", &[UP_AXIS, float("faceIndex")], TO_GEOMETRY),
        "name the edge too: `alignScopeToGeometry(yUp, 0, 0)`",
    ),
    old(
        op("alignScopeToGeometry", "align_to_auto", &[UP_AXIS, AUTO], TO_GEOMETRY),
        "write `alignScopeToGeometry(yUp, any, world.lowest)`",
    ),
    op(
        "alignScopeToGeometryBBox",
        "align_to_box",
        &[BOX_AXES],
        "turns the scope about an axis until its box is as small as can be",
    ),
    op(
        "rotateScope",
        "rotate_scope",
        &[float("xAngle"), float("yAngle"), float("zAngle")],
        "turns the scope about the axes of the pivot, in degrees",
    ),
    op(
        "setPivot",
        "set_pivot",
        &[AXIS_MAP, within(float("cornerIndex"), &CORNERS)],
        "puts the pivot to a corner of the scope",
    ),
    op(
        "mirrorScope",
        "mirror_scope",
        &[boolean("xFlip"), boolean("yFlip"), boolean("zFlip")],
        "mirrors the scope around the geometry",
    ),
];
