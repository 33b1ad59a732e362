//! A normal distribution without correlation.

use glam::DVec3;

/// The density `exp(−d²/2)`, where `d` is the distance from the mean in units of the deviation along each axis. It is
/// not scaled to a total of 1. An infinite deviation makes it even along its axis.
#[derive(Clone, Copy, Debug)]
pub struct Bell {
    /// The place of the highest density.
    pub mean: DVec3,
    /// The standard deviation along each axis.
    pub deviation: DVec3,
}

impl Bell {
    /// The density 1 everywhere.
    pub const EVEN: Bell = Bell { mean: DVec3::ZERO, deviation: DVec3::INFINITY };

    /// Returns true if the density is the same everywhere.
    pub(super) fn is_even(&self) -> bool {
        self.deviation == DVec3::INFINITY
    }

    /// The logarithm of the density at a point.
    pub(super) fn log_density(&self, point: DVec3) -> f64 {
        -0.5 * ((point - self.mean) / self.deviation).length_squared()
    }

    /// The logarithms of the lowest and the highest density in a box.
    pub(super) fn log_range(&self, low: DVec3, high: DVec3) -> [f64; 2] {
        let nearest = self.mean.clamp(low, high);
        let farthest = DVec3::select((self.mean - low).abs().cmpgt((self.mean - high).abs()), low, high);
        [self.log_density(farthest), self.log_density(nearest)]
    }
}
