//! Drops points that a result does not need.

use crate::each::Each;

use super::edge_table::NO_CORNER;
use super::operation::BooleanError;
use super::point_set::PointSet;
use super::polygon::{PolygonCorner, ResultPolygons};
use super::progress::goes_on;
use crate::mesh::in_order;

/// Drops the corners at which edges were divided but nothing meets any more. Corners of faces stay, and so do corners between
/// edges with different tags.
pub(super) fn drop_straight(points: &PointSet, polygons: &mut ResultPolygons<'_>) -> Result<(), BooleanError> {
    // The neighbours of each point that all loops with the point agree about. Equal neighbours for a point that stays.
    let mut neighbours: Vec<Option<[u32; 2]>> = vec![None; points.at.len()];
    for ring in polygons.iter().flat_map(|polygon| polygon.rings.iter()) {
        goes_on(ring.len())?;
        for (place, corner) in ring.iter().enumerate() {
            let last = &ring[if place == 0 { ring.len() - 1 } else { place - 1 }];
            let next = ring[(place + 1) % ring.len()].point;
            let pair = in_order([last.point, next]);
            let known = &mut neighbours[corner.point as usize];
            let goes = may_go(points, last, corner, next) && known.is_none_or(|known| known == pair);
            *known = Some(if goes { pair } else { [0; 2] });
        }
    }
    // The two edges that remain of a thin loop cancel with those beside it.
    polygons.retain(|corner| neighbours[corner.point as usize] == Some([0; 2]))
}

/// Returns true if a corner is inside an edge of the face, or inside a straight line in the face.
fn may_go(points: &PointSet, last: &PolygonCorner, corner: &PolygonCorner, next: u32) -> bool {
    let is_inside = last.along == corner.along && last.tags == corner.tags;
    let is_same_edge = corner.along[0] != NO_CORNER;
    let [a, b, c] = [last.point, corner.point, next].each(|point| points.at[point as usize]);
    let whole = c - a;
    let share = (b - a).dot(whole) / whole.length_squared();
    let is_straight = || 0.0 < share && share < 1.0 && (b - a - whole * share).length() <= 2.0 * points.epsilon;
    is_inside && (is_same_edge || is_straight()) && a != c
}
