//! Sums of squared distances from planes.

use std::ops::AddAssign;

use glam::{DMat3, DVec3};

/// The sum of squared distances from planes, each with a weight, as a function of a point.
#[derive(Clone, Copy, Debug)]
pub(super) struct Quadric {
    square: DMat3,
    linear: DVec3,
    constant: f64,
    /// The sum of all weights.
    pub(super) weight: f64,
}

impl Quadric {
    /// The sum without planes.
    pub(super) const ZERO: Self = Quadric { square: DMat3::ZERO, linear: DVec3::ZERO, constant: 0.0, weight: 0.0 };

    /// The squared distance from the plane through a point, with a unit normal.
    pub(super) fn of_plane(normal: DVec3, point: DVec3, weight: f64) -> Self {
        let distance = normal.dot(point);
        let square = DMat3::from_cols(normal * normal.x, normal * normal.y, normal * normal.z) * weight;
        Quadric { square, linear: normal * (distance * weight), constant: distance * distance * weight, weight }
    }

    /// The value at a point; negative values are rounding errors.
    pub(super) fn at(&self, point: DVec3) -> f64 {
        (point.dot(self.square * point) - 2.0 * self.linear.dot(point) + self.constant).max(0.0)
    }
}

impl AddAssign for Quadric {
    fn add_assign(&mut self, other: Quadric) {
        self.square += other.square;
        self.linear += other.linear;
        self.constant += other.constant;
        self.weight += other.weight;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quadrics_are_sums_of_squared_distances() {
        let mut sum = Quadric::ZERO;
        sum += Quadric::of_plane(DVec3::X, DVec3::new(2.0, 7.0, 1.0), 3.0);
        sum += Quadric::of_plane(DVec3::Y, DVec3::new(5.0, 1.0, 1.0), 0.5);
        assert_eq!(sum.at(DVec3::new(4.0, 3.0, 9.0)), 3.0 * 4.0 + 0.5 * 4.0);
        assert_eq!((sum.at(DVec3::new(2.0, 1.0, -5.0)), sum.weight), (0.0, 3.5));
    }
}
