//! Unions and differences of polygons in a plane: the region around which directed edges wind.
//!
//! Edges have the region on their left. Each place has a *winding number*: the number of polygons around it, where those
//! that run clockwise count negative. The result is the region where it is positive. So polygons that run anticlockwise
//! unite, and those that run clockwise are taken away.
//!
//! Points are rounded to a grid of whole numbers (`grid`), where the side of a line is exact. Edges are divided where
//! they cross or pass a point closely, until none does (`noding`). Then a sweep finds the winding number on both sides
//! of each edge (`winding`). Edges with the region on one side only are its outline. They are joined by point identity,
//! so outlines close. Loops narrower than the grid can tell from a rounding error are dropped.

mod grid;
mod noding;
mod places;
mod winding;

use glam::DVec2;

use crate::nesting::contour::Contour;
use crate::nesting::polygons::NestedRings;
use crate::small_sort::sort_owned_by;
use crate::tol::TOUCH_EPSILON;
pub(crate) use grid::Grid;
use grid::{GridPoint, double_area};
use places::Places;

/// The reason why an overlay fails.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OverlayError {
    /// Too many edges cross.
    TooMany,
    /// Edges that are nearly at one place cannot be told apart.
    Tangled,
}

/// A region of the plane.
#[derive(Clone, Debug, Default)]
pub struct Region {
    /// The given points, followed by new ones.
    pub points: Vec<DVec2>,
    /// The polygons, each an outline anticlockwise and its holes clockwise, as numbers of points.
    pub polygons: Vec<Vec<Vec<u32>>>,
}

/// The region with a positive winding number, in time n log n for n edges and crossings. Rings are numbers of points. Corners where the outline runs straight on are
/// dropped, except for points with a number below `kept`. The outline has the lowest number of all given points at one
/// place.
///
/// ```
/// use cga_geometry::glam::DVec2;
/// use cga_geometry::overlay::wound;
///
/// // Two squares that overlap, and a clockwise one that is taken away.
/// let square = |x: f64, y: f64, side: f64| [[x, y], [x + side, y], [x + side, y + side], [x, y + side]];
/// let corners = [square(0.0, 0.0, 4.0), square(2.0, 2.0, 4.0), square(1.0, 1.0, 0.5)];
/// let points: Vec<DVec2> = corners.iter().flatten().map(|corner| DVec2::from(*corner)).collect();
/// let region = wound(&points, [&[0, 1, 2, 3][..], &[4, 5, 6, 7], &[11, 10, 9, 8]], 0)?;
/// assert_eq!(region.polygons.len(), 1);
/// assert_eq!([region.polygons[0][0].len(), region.polygons[0][1].len()], [8, 4], "an outline and its hole");
/// # Ok::<(), cga_geometry::overlay::OverlayError>(())
/// ```
///
/// # Errors
/// An error if too many edges cross, or if edges that are nearly at one place cannot be told apart.
///
/// # Panics
/// Panics if a ring has the number of a point that does not exist.
pub fn wound<'r>(
    points: &[DVec2],
    rings: impl IntoIterator<Item = &'r [u32]>,
    kept: usize,
) -> Result<Region, OverlayError> {
    let Some(grid) = Grid::of(points) else { return Ok(Region { points: points.to_vec(), polygons: Vec::new() }) };
    let mut places = Places::of(points.iter().map(|point| grid.place(*point)).collect());
    let first: Vec<u32> = (0..points.len()).map(|point| places.number(places.list[point])).collect();
    let mut edges = Vec::new();
    for ring in rings {
        let next = ring.iter().cycle().skip(1);
        edges.extend(ring.iter().zip(next).map(|(a, b)| [first[*a as usize], first[*b as usize]]));
    }
    let noded = noding::divide(&mut places, edges)?;
    let places = places.list;
    let sides = winding::outline(&places, &noded);
    let mut all = points.to_vec();
    all.extend(places[points.len()..].iter().map(|place| grid.point(*place)));
    let flat: Vec<DVec2> = places.iter().map(|place| place.flat()).collect();
    let mut contour = Contour::default();
    let mut open = false;
    contour.follow(&sides, &flat, |_| open = true);
    if open {
        return Err(OverlayError::Tangled);
    }
    let mut loops: Vec<Vec<u32>> = Vec::new();
    let mut from = 0;
    for &end in &contour.ends {
        let mut ring = contour.corners[from..end].to_vec();
        from = end;
        grid::drop_straight(&mut ring, &places, kept);
        if 3 <= ring.len() && !is_sliver(&ring, &places) {
            loops.push(ring);
        }
    }
    Ok(Region { polygons: nested(loops, &flat, &places), points: all })
}

/// Returns true if a loop is so narrow that it is a rounding error.
fn is_sliver(ring: &[u32], places: &[GridPoint]) -> bool {
    let at = |i: usize| places[ring[i % ring.len()] as usize].flat();
    let around: f64 = (0..ring.len()).map(|i| at(i).distance(at(i + 1))).sum();
    (double_area(ring, places) as f64).abs() < TOUCH_EPSILON * Grid::EXTENT * around
}

/// Loops grouped to outlines and holes. Each loop begins with its lowest point, and polygons are in the order of these.
fn nested(mut loops: Vec<Vec<u32>>, flat: &[DVec2], places: &[GridPoint]) -> Vec<Vec<Vec<u32>>> {
    for ring in &mut loops {
        let first = (0..ring.len()).min_by_key(|&i| ring[i]).unwrap_or(0);
        ring.rotate_left(first);
    }
    sort_owned_by(&mut loops, Ord::cmp);
    let nested = NestedRings::of_anticlockwise(flat, loops.into_iter());
    let polygons = nested.polygons().map(|rings| -> Vec<Vec<u32>> { rings.map(<[u32]>::to_vec).collect() });
    // A hole whose outline was a sliver has no region around it.
    polygons.filter(|rings| 0 < double_area(&rings[0], places)).collect()
}

#[cfg(test)]
pub(crate) mod tests;
