//! The least and the largest coordinates of points.

use glam::Vec3;

/// The least and the largest coordinates so far.
pub(super) struct Extremes {
    low: Vec3,
    high: Vec3,
    /// Coordinates that are not finite make the sum NaN.
    zero: Vec3,
}

impl Default for Extremes {
    fn default() -> Self {
        Extremes { low: Vec3::INFINITY, high: Vec3::NEG_INFINITY, zero: Vec3::ZERO }
    }
}

impl Extremes {
    /// Adds a point.
    #[inline]
    pub(super) fn add(&mut self, point: &[f32; 3]) {
        let point = Vec3::from_array(*point);
        (self.low, self.high) = (self.low.min(point), self.high.max(point));
        self.zero += point * 0.0;
    }

    /// The result, if all coordinates are finite.
    pub(super) fn found(self) -> Option<(Vec3, Vec3)> {
        (self.zero == Vec3::ZERO).then_some((self.low, self.high))
    }
}
