//! Boxes in a plane.

use glam::DVec2;

use crate::geometry::tol::AROUND_EPSILON;

/// The smallest box around some points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Extent {
    pub(super) low: DVec2,
    pub(super) high: DVec2,
}

impl Extent {
    const EMPTY: Extent = Extent { low: DVec2::INFINITY, high: DVec2::NEG_INFINITY };

    pub(super) fn union(all: impl Iterator<Item = Extent>) -> Self {
        all.fold(Extent::EMPTY, |sum, next| Extent { low: sum.low.min(next.low), high: sum.high.max(next.high) })
    }

    /// By how much it may be too small for what is in it, with rounded coordinates.
    pub(super) fn slack(&self) -> f64 {
        AROUND_EPSILON * self.low.abs().max(self.high.abs()).max_element()
    }

    /// Whether it is in another one, except for rounding. Then it is also in every box around that.
    pub(super) fn is_in(&self, other: &Extent) -> bool {
        let slack = other.slack();
        other.low.cmple(self.low + slack).all() && self.high.cmple(other.high + slack).all()
    }

    /// Whether a point is in it or on its rim.
    #[inline]
    pub(super) fn holds(&self, point: DVec2) -> bool {
        self.low.x <= point.x && self.low.y <= point.y && point.x <= self.high.x && point.y <= self.high.y
    }
}
