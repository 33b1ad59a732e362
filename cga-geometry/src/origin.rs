//! Where the points of a new mesh come from.

use crate::trace::UNTRACED;

/// The origin of a new point in an old mesh.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PointOrigin {
    /// A point of the old mesh, at its place.
    Old(u32),
    /// A point between two points of the old mesh, at a share of the way, from 0 at the first to 1 at the second.
    Between {
        /// The two points of the old mesh.
        ends: [u32; 2],
        /// The share of the way, from 0 to 1.
        share: f64,
    },
    /// A point that was moved away from a point of the old mesh. Its values are the values there.
    Moved(u32),
    /// A point that grew out of a face, such as the ridge of a roof: an edge to it from a vertex of the face has the tags of the
    /// vertex. Its values continue the values of the face over its plane.
    Grown,
    /// Any other point. Its values continue the values of the face that it is used in.
    New,
}

impl PointOrigin {
    /// The points of the old mesh between which the point is, twice the same for an old point. [`UNTRACED`] for new ones.
    pub(crate) fn ends(self) -> [u32; 2] {
        match self {
            PointOrigin::Old(point) => [point; 2],
            PointOrigin::Between { ends, .. } => ends,
            PointOrigin::Moved(_) | PointOrigin::Grown | PointOrigin::New => [UNTRACED; 2],
        }
    }

    /// The old point, at its place.
    pub fn old(self) -> Option<u32> {
        if let PointOrigin::Old(point) = self { Some(point) } else { None }
    }
}
