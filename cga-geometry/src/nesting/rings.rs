//! Polygons of separate rings.

use glam::DVec2;

use super::Nest;
use super::contour::FlatLoops;

/// Rings grouped to polygons, each an outline with its holes.
pub(crate) struct NestedRings {
    corners: Vec<u32>,
    nest: Nest,
}

impl NestedRings {
    /// Groups rings, which are numbers of points. Outlines are anticlockwise, unless all rings together are inside out.
    pub(crate) fn of(flat: &[DVec2], rings: impl Iterator<Item: IntoIterator<Item = u32>>) -> Self {
        Self::sorted(flat, rings, Nest::sort)
    }

    /// Groups rings whose outlines are known to be anticlockwise.
    pub(crate) fn of_anticlockwise(flat: &[DVec2], rings: impl Iterator<Item: IntoIterator<Item = u32>>) -> Self {
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
            ends.push(corners.len());
        }
        let mut nest = Nest::default();
        sort(&mut nest, &FlatLoops { flat, corners: &corners, ends: &ends });
        NestedRings { corners, nest }
    }

    /// The polygons: the outline of each, followed by its holes.
    pub(crate) fn polygons(&self) -> impl ExactSizeIterator<Item: ExactSizeIterator<Item = &[u32]>> {
        self.nest.groups().map(|rings| rings.iter().map(|ring| &self.corners[ring.clone()]))
    }
}
