//! Edges from the end that comes first in lexicographic order.

use glam::DVec3;

/// An edge from the end that comes first; ends have heights.
pub(super) struct Segment {
    from: (DVec3, f64),
    to: (DVec3, f64),
    along: DVec3,
    low: DVec3,
    high: DVec3,
}

impl Segment {
    #[inline(always)]
    pub(super) fn between(a: (DVec3, f64), b: (DVec3, f64)) -> Self {
        let (from, to) = if comes_first(a.0, b.0) { (a, b) } else { (b, a) };
        Segment { from, to, along: to.0 - from.0, low: from.0.min(to.0), high: from.0.max(to.0) }
    }

    /// Where it is as high as a plane, and how far along it that is.
    #[inline(always)]
    pub(super) fn meet(&self, at: f64) -> (DVec3, f64) {
        let ((p, from), (q, to)) = (self.from, self.to);
        let mut share = (at - from) / (to - from);
        let mut x = p + self.along * share;
        if !x.is_finite() {
            // The ends are so far apart that their difference overflows.
            share = (at * 0.5 - from * 0.5) / (to * 0.5 - from * 0.5);
            x = p * (1.0 - share) + q * share;
        }
        // Rounding does not lead out of the box of the edge.
        (x.max(self.low).min(self.high), share)
    }
}

/// Lexicographic order of coordinates: it survives every renumbering.
pub(super) fn comes_first(a: DVec3, b: DVec3) -> bool {
    a.x < b.x || (a.x == b.x && (a.y < b.y || (a.y == b.y && a.z < b.z)))
}
