//! Convex faces.

use glam::DVec2;

use super::FaceRef;
use crate::geometry::exact::orient;
use crate::geometry::triangulate::Projection;

impl FaceRef<'_> {
    /// Returns true if the face is convex, as seen along its normal. Straight corners are allowed. Holes are ignored.
    pub(crate) fn is_convex(&self) -> bool {
        let projection = Projection::along(self.normal());
        let mut points = self.outline().map(|point| projection.apply(point));
        let (Some(first), Some(second)) = (points.next(), points.next()) else { return false };
        let goes_right = |a: DVec2, b: DVec2| a.x < b.x || (a.x == b.x && a.y < b.y);
        let (mut previous, mut here) = (first, second);
        let mut heading = goes_right(first, second);
        // It never turns right, and it changes from right to left and back only once.
        let (mut turns, mut has_corner) = (0, false);
        for next in points.chain([first, second]) {
            let side = orient(previous, here, next);
            if side < 0 || here == next || (side == 0 && (here - previous).dot(next - here) < 0.0) {
                return false;
            }
            let now = goes_right(here, next);
            turns += usize::from(now != heading);
            (heading, has_corner) = (now, has_corner || side > 0);
            (previous, here) = (here, next);
        }
        turns <= 2 && has_corner
    }
}
