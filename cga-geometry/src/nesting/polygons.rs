//! Polygons of separate rings.

use glam::DVec2;

use super::Nest;
use super::contour::FlatLoops;

/// Rings grouped to polygons, each an outline with its holes.
///
/// ```
/// use cga_geometry::glam::DVec2;
/// use cga_geometry::nesting::NestedRings;
///
/// let square = |at: f64, side: f64| [[at, at], [at + side, at], [at + side, at + side], [at, at + side]];
/// let points: Vec<DVec2> =
///     [square(0.0, 9.0), square(1.0, 2.0), square(5.0, 1.0)].into_iter().flatten().map(DVec2::from).collect();
/// // The outline is anticlockwise, both holes are clockwise.
/// let nested = NestedRings::of(&points, [[0, 1, 2, 3], [7, 6, 5, 4], [11, 10, 9, 8]].into_iter());
/// let rings: Vec<usize> = nested.polygons().map(|rings| rings.len()).collect();
/// assert_eq!(rings, [3]);
/// ```
pub struct NestedRings {
    corners: Vec<u32>,
    nest: Nest,
}

impl NestedRings {
    /// Groups rings, which are numbers of points. Outlines are anticlockwise, unless all rings together are inside out. Rings
    /// without corners are left out.
    ///
    /// # Panics
    /// Panics if a ring has the number of a point that does not exist.
    pub fn of(flat: &[DVec2], rings: impl Iterator<Item: IntoIterator<Item = u32>>) -> Self {
        Self::sorted(flat, rings, Nest::sort)
    }

    /// Groups rings whose outlines are known to be anticlockwise.
    pub fn of_anticlockwise(flat: &[DVec2], rings: impl Iterator<Item: IntoIterator<Item = u32>>) -> Self {
        Self::sorted(flat, rings, |nest, section| nest.sort_as(section, false))
    }

    fn sorted(
        flat: &[DVec2],
        rings: impl Iterator<Item: IntoIterator<Item = u32>>,
        sort: impl FnOnce(&mut Nest, &FlatLoops<'_>),
    ) -> Self {
        let (mut corners, mut ends) = (Vec::new(), Vec::new());
        for ring in rings {
            corners.extend(ring);
            // Rings without corners are left out.
            if ends.last().copied().unwrap_or(0) < corners.len() {
                ends.push(corners.len());
            }
        }
        let mut nest = Nest::default();
        sort(&mut nest, &FlatLoops { flat, corners: &corners, ends: &ends });
        NestedRings { corners, nest }
    }

    /// The polygons: the outline of each, followed by its holes.
    pub fn polygons(&self) -> impl ExactSizeIterator<Item: ExactSizeIterator<Item = &[u32]>> {
        self.nest.groups().map(|rings| rings.iter().map(|ring| &self.corners[ring.clone()]))
    }
}
