//! Texture coordinates as an affine function of the point.

use glam::{DAffine2, DAffine3, DVec2, DVec3, DVec4};

/// An affine function from points of the world, in metres, to texture coordinates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct UvMap {
    /// The first coordinate: the factors of x, y and z, and the value at the origin.
    pub u: DVec4,
    /// The second coordinate, in the same way.
    pub v: DVec4,
}

impl UvMap {
    /// The coordinates of a point.
    #[inline]
    pub fn at(&self, point: DVec3) -> DVec2 {
        let point = point.extend(1.0);
        DVec2::new(self.u.dot(point), self.v.dot(point))
    }

    /// The function that first moves the point.
    pub(crate) fn after(&self, move_point: &DAffine3) -> Self {
        let row = |row: DVec4| {
            let factors = row.truncate();
            let constant = row.w + factors.dot(move_point.translation);
            (move_point.matrix3.transpose() * factors).extend(constant)
        };
        UvMap { u: row(self.u), v: row(self.v) }
    }

    /// The function whose result is changed.
    pub(crate) fn then(&self, change: &DAffine2) -> Self {
        let row = |factors: DVec2, constant: f64| {
            self.u * factors.x + self.v * factors.y + DVec4::new(0.0, 0.0, 0.0, constant)
        };
        let (matrix, by) = (change.matrix2.transpose(), change.translation);
        UvMap { u: row(matrix.x_axis, by.x), v: row(matrix.y_axis, by.y) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::{DMat2, DMat3};

    #[test]
    fn maps_are_composed_as_functions_are() {
        let map = UvMap { u: DVec4::new(1.0, 2.0, 3.0, 4.0), v: DVec4::new(-1.0, 0.5, 0.0, 2.0) };
        let point = DVec3::new(0.5, -2.0, 7.0);
        let moved = DAffine3 {
            matrix3: DMat3::from_cols_array(&[1.0, 2.0, 3.0, 0.0, 1.0, 4.0, 5.0, 6.0, 0.0]),
            translation: DVec3::new(1.0, -1.0, 2.0),
        };
        assert_eq!(map.after(&moved).at(point), map.at(moved.transform_point3(point)));
        let change =
            DAffine2 { matrix2: DMat2::from_cols_array(&[2.0, 1.0, -3.0, 0.5]), translation: DVec2::new(0.25, -8.0) };
        assert_eq!(map.then(&change).at(point), change.transform_point2(map.at(point)));
    }
}
