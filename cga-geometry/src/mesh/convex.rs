//! Convex faces.

use super::FaceRef;
use crate::triangulate::{PlaneProjection, apex};

impl FaceRef<'_> {
    /// Returns true if the face is convex, as seen along its normal. Straight corners are allowed. Holes are ignored.
    pub(crate) fn is_convex(&self) -> bool {
        let projection = PlaneProjection::along(self.normal());
        let outer = self.outer();
        apex(outer.len(), |i| projection.apply(self.mesh.points[outer[i] as usize])).is_some()
    }
}
