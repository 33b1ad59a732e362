//! Bounding boxes in a plane.

use glam::DVec2;

use crate::tol::AROUND_EPSILON;

/// The smallest box around some points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Extent {
    pub(crate) low: DVec2,
    pub(crate) high: DVec2,
}

impl Extent {
    /// The box around nothing.
    pub(crate) const EMPTY: Extent = Extent { low: DVec2::INFINITY, high: DVec2::NEG_INFINITY };

    /// The box around some points.
    pub(crate) fn of(points: impl Iterator<Item = DVec2>) -> Self {
        Extent::union(points.map(|point| Extent { low: point, high: point }))
    }

    /// The box around some boxes.
    pub(crate) fn union(all: impl Iterator<Item = Extent>) -> Self {
        all.fold(Extent::EMPTY, |sum, next| Extent { low: sum.low.min(next.low), high: sum.high.max(next.high) })
    }

    /// The amount by which the box may be too small for its contents because of rounded coordinates.
    pub(crate) fn slack(&self) -> f64 {
        AROUND_EPSILON * self.low.abs().max(self.high.abs()).max_element()
    }

    /// Returns true if the box is inside another one, except for rounding. Then it is also inside every box around that
    /// one.
    pub(crate) fn is_in(&self, other: &Extent) -> bool {
        let slack = other.slack();
        other.low.cmple(self.low + slack).all() && self.high.cmple(other.high + slack).all()
    }

    /// Returns true if two boxes have a point in common.
    #[inline]
    pub(crate) fn meets(&self, other: &Extent) -> bool {
        self.low.x <= other.high.x
            && other.low.x <= self.high.x
            && self.low.y <= other.high.y
            && other.low.y <= self.high.y
    }

    /// Returns true if a point is inside the box or on its rim.
    #[inline]
    pub(crate) fn holds(&self, point: DVec2) -> bool {
        self.low.x <= point.x && self.low.y <= point.y && point.x <= self.high.x && point.y <= self.high.y
    }
}

/// The factor that scales a section to about 1 if its areas would overflow or underflow; otherwise 1.
pub(crate) fn about_one(mut corners: impl Iterator<Item = DVec2>) -> f64 {
    const RANGE: std::ops::Range<f64> = 1e-100..1e100;
    let Some(from) = corners.next() else { return 1.0 };
    let half = corners.fold(0.0, |half: f64, corner| half.max((corner * 0.5 - from * 0.5).abs().max_element()));
    if half == 0.0 || RANGE.contains(&half) { 1.0 } else { libm::scalbn(1.0, -libm::ilogb(half)) }
}
