//! Loops with their bounding boxes and areas.

use std::ops::Range;

use super::extent::Extent;

/// A loop, and for a hole its outline.
pub(super) struct Loop {
    pub(super) range: Range<usize>,
    /// Twice the area, negative for a hole.
    pub(super) area: f64,
    pub(super) extent: Extent,
    pub(super) outline: Option<usize>,
}

impl Loop {
    pub(super) fn is_outline(&self) -> bool {
        0.0 <= self.area
    }

    /// Returns true if the loop can contain a hole by its bounding box and area, except for rounding. The areas
    /// belong to the section scaled by `scale`.
    pub(super) fn may_hold(&self, hole: &Loop, scale: f64) -> bool {
        let Extent { low, high } = self.extent;
        let spare = self.extent.slack() * scale * (high * scale - low * scale).element_sum();
        hole.extent.is_in(&self.extent) && -hole.area <= self.area + spare
    }
}
