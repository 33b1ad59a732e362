//! Caps in an order that is the same on both sides of a cut.
//!
//! The cap on one side of a plane is the reversed cap of the other side: the same points, with each loop reversed and
//! its first edge first. One of the two orders is triangulated on both sides, so that both have the same triangles.

use std::ops::Range;

use glam::DVec3;

use crate::bounds::Bounds;
use crate::each::Each;
use crate::vector::{area_vector, well_scaled};

/// The corners of a cap, reversed on one of the two sides.
#[derive(Default)]
pub(super) struct Cap {
    is_turned: bool,
    corners: Vec<u32>,
    pub(super) points: Vec<DVec3>,
}

impl Cap {
    pub(super) fn read(&mut self, loops: impl Iterator<Item = Range<usize>> + Clone, place: impl Fn(usize) -> DVec3) {
        self.is_turned = is_turned(loops.clone().next().unwrap_or(0..0), &place);
        self.corners.clear();
        for corners in loops {
            if self.is_turned {
                // 1 0 n-1 … 2.
                let second = corners.len().min(2);
                let turned = (0..second).rev().chain((second..corners.len()).rev());
                self.corners.extend(turned.map(|i| (corners.start + i) as u32));
            } else {
                self.corners.extend(corners.map(|corner| corner as u32));
            }
        }
        self.points.clear();
        self.points.extend(self.corners.iter().map(|&corner| place(corner as usize)));
    }

    /// The normal in the order of the corners, not of unit length. It is the same on both sides, bit for bit.
    pub(super) fn normal(&self, loop_ends: &[u32]) -> DVec3 {
        let area = |scale: f64| {
            let mut start = 0;
            area_vector(loop_ends.iter().map(move |&end| {
                let ring = std::mem::replace(&mut start, end as usize)..end as usize;
                self.points[ring].iter().map(move |&point| point * scale)
            }))
        };
        well_scaled(area(1.0), || area(Bounds::of(self.points.iter().copied()).scale_to_one()))
    }

    /// Converts a triangle of these corners to corners of the mesh.
    pub(super) fn triangle(&self, [a, b, c]: [u32; 3]) -> [u32; 3] {
        if self.is_turned { [a, c, b] } else { [a, b, c] }.each(|at| self.corners[at as usize])
    }
}

/// Returns true if this cap is the reversed one of the two. The order of the first two points that reversal swaps
/// decides.
fn is_turned(outline: Range<usize>, place: &impl Fn(usize) -> DVec3) -> bool {
    let count = outline.len();
    let at = |i: usize| place(outline.start + i % count).to_array();
    let mut pairs = (1..count).map(|i| (at(i), at(count + 1 - i)));
    pairs.find(|(a, b)| a != b).is_some_and(|(a, b)| a < b)
}
