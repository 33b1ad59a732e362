//! Extends the values at the corners of a face over its plane, by the best-fitting affine map. The map is exact for
//! projected and other affine texture coordinates.

use glam::{DMat2, DVec2};

/// Positions of corners, and their moments about their mean.
pub(crate) struct Spread {
    corners: Vec<DVec2>,
    middle: DVec2,
    inverse: DMat2,
}

impl Spread {
    /// Corners in a plane that are not all on one line.
    pub(crate) fn of(corners: Vec<DVec2>) -> Self {
        let middle = corners.iter().sum::<DVec2>() / corners.len() as f64;
        let outer = |d: DVec2| DMat2::from_cols(d * d.x, d * d.y);
        let moments = corners.iter().fold(DMat2::ZERO, |sum, &p| sum + outer(p - middle));
        let inverse = if moments.determinant() == 0.0 { DMat2::ZERO } else { moments.inverse() };
        Spread { corners, middle, inverse }
    }

    /// The weight of each corner at a point. The weights add up to 1.
    pub(crate) fn weights(&self, at: DVec2) -> Vec<f64> {
        let to = self.inverse * (at - self.middle);
        let share = 1.0 / self.corners.len() as f64;
        self.corners.iter().map(|&corner| share + to.dot(corner - self.middle)).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_linear_map_is_continued() {
        let corners = [(0.0, 0.0), (4.0, 1.0), (3.0, 5.0), (1.0, 2.0), (-2.0, 6.0)].map(|(x, y)| DVec2::new(x, y));
        let map = |p: DVec2| 3.0 * p.x - 0.5 * p.y + 7.0;
        let spread = Spread::of(corners.to_vec());
        for at in [DVec2::new(10.0, -3.0), DVec2::new(1.0, 1.0)] {
            let value: f64 = spread.weights(at).iter().zip(corners).map(|(weight, corner)| weight * map(corner)).sum();
            assert!((value - map(at)).abs() < 1e-12);
        }
    }
}
