//! Convex polygons divided where they meet a surface.

use glam::DVec3;

use super::budget::Budget;
use super::convex_polygon::ConvexPolygon;
use super::surface::Surface;
use crate::bounds::Bounds;
use crate::bounds_tree::overlap;

/// The most parts of a polygon. Further cuts are not made.
const MOST_PARTS: usize = 1 << 13;

/// Divides a convex polygon along some pieces of a surface, so that each part is inside, outside, or on it, up to the tolerance. Calls
/// `visit` with each part until it returns false. Returns false if the budget is spent before the end.
pub(super) fn subdivide(
    polygon: &ConvexPolygon<'_>,
    surface: &Surface,
    pieces: Vec<u32>,
    tolerance: f64,
    budget: &mut Budget,
    mut visit: impl FnMut(&[DVec3]) -> bool,
) -> bool {
    // Parts, with the pieces that may divide them.
    let mut open = vec![(polygon.corners.to_vec(), pieces)];
    let mut made = Vec::new();
    let mut count = 1;
    while let Some((part, pieces)) = open.pop() {
        let box_of = Bounds::of(part.iter().copied());
        let is_near = |piece: u32, bounds: &Bounds| {
            let Bounds { low, high } = *bounds;
            overlap(surface.bounds_of(piece), &Bounds { low: low - tolerance, high: high + tolerance })
        };
        let mut divider = None;
        for (number, &piece) in pieces.iter().enumerate() {
            let divider_polygon = surface.polygon(piece);
            if !budget.spend(part.len() + divider_polygon.corners.len()) {
                return false;
            }
            let may_divide = count < MOST_PARTS && is_near(piece, &box_of);
            if may_divide && divider_polygon.divide(&part, polygon.normal, tolerance, &mut made) {
                divider = Some(number);
                break;
            }
        }
        let Some(divider) = divider else {
            if !visit(&part) {
                return true;
            }
            continue;
        };
        count += made.len();
        for part in made.drain(..) {
            let bounds = Bounds::of(part.iter().copied());
            let rest = pieces[divider + 1..].iter().copied().filter(|piece| is_near(*piece, &bounds));
            open.push((part, rest.collect()));
        }
    }
    true
}
