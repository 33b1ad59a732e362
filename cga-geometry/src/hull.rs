//! The convex hull of points in a plane.

use glam::DVec2;

use crate::exact::orient;
use crate::small_sort::SmallSort;

/// Reduces a list of items with positions in a plane to the corners of their convex hull, counter-clockwise. Of items at one
/// position, one is kept. Two or fewer positions are their own hull. Positions should be finite.
///
/// The time is proportional to `n log n` for `n` items.
///
/// ```
/// use cga_geometry::glam::DVec2;
/// use cga_geometry::hull::hull;
///
/// // Of a square, its middle and a point on a side, four corners are the hull.
/// let mut points = [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0], [1.0, 1.0], [1.0, 0.0]].map(DVec2::from).to_vec();
/// hull(&mut points, |point| *point);
/// assert_eq!(points, [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]].map(DVec2::from));
/// ```
pub fn hull<T: Copy>(points: &mut Vec<T>, at: impl Fn(&T) -> DVec2) {
    points.small_sort_by(|a, b| at(a).x.total_cmp(&at(b).x).then(at(a).y.total_cmp(&at(b).y)));
    points.dedup_by(|a, b| at(a) == at(b));
    if points.len() < 3 {
        return;
    }
    let mut corners: Vec<T> = Vec::new();
    for pass in 0..2 {
        let start = corners.len();
        let mut add = |p: &T| {
            while start + 2 <= corners.len()
                && orient(at(&corners[corners.len() - 2]), at(&corners[corners.len() - 1]), at(p)) <= 0
            {
                corners.pop();
            }
            corners.push(*p);
        };
        match pass {
            0 => points.iter().for_each(&mut add),
            _ => points.iter().rev().for_each(&mut add),
        }
        // The last corner is the first one of the other half.
        corners.pop();
    }
    *points = corners;
}
