//! Edges, directed from the lexicographically first end.

use glam::DVec3;

/// An edge, directed from the lexicographically first end, with a height at each end.
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

    /// The point at the height of a plane, and its relative position on the edge.
    #[inline(always)]
    pub(super) fn meet(&self, at: f64) -> (DVec3, f64) {
        let ((p, from), (q, to)) = (self.from, self.to);
        let mut share = (at - from) / (to - from);
        let mut x = p + self.along * share;
        if !x.is_finite() {
            // The difference of the ends overflows.
            share = (at * 0.5 - from * 0.5) / (to * 0.5 - from * 0.5);
            x = p * (1.0 - share) + q * share;
        }
        // Rounding must not lead out of the bounding box of the edge.
        (x.max(self.low).min(self.high), share)
    }
}

/// The lexicographic order of coordinates, which does not depend on the numbers of points.
pub(super) fn comes_first(a: DVec3, b: DVec3) -> bool {
    a.x < b.x || (a.x == b.x && (a.y < b.y || (a.y == b.y && a.z < b.z)))
}
