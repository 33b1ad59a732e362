//! Affine maps from the world to texture coordinates.
//!
//! A projection maps every point of the world to coordinates. So a rectangle or a box can have coordinates without a
//! mesh: a sink computes them when it writes vertices.

use std::sync::Arc;

use glam::{DAffine2, DAffine3, DVec2, DVec3, DVec4};

use crate::tol::CONSTANT_EPSILON;

/// An affine map from points of the world to (u, v): two affine functions, each with its constant in `w`. v points up.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct UvMap {
    /// The factors of x, y and z, and the constant, of the first coordinate.
    pub u: DVec4,
    /// The factors of x, y and z, and the constant, of the second coordinate.
    pub v: DVec4,
}

/// The maps of one set of texture coordinates, on a rectangle or a box.
#[derive(Clone, Debug, PartialEq)]
pub struct SetMap {
    /// The number of the set, 0 to 9.
    pub set: usize,
    /// The maps from the world.
    pub maps: FaceMaps,
}

/// The maps of the faces of a rectangle or a box.
#[derive(Clone, Debug, PartialEq)]
pub enum FaceMaps {
    /// All faces have the same map.
    Same(UvMap),
    /// Each face of a box has its own map, in the order of the faces.
    Each(Arc<[UvMap; 6]>),
}

impl FaceMaps {
    /// The map of a face, by its number.
    #[inline]
    pub fn of_face(&self, face: usize) -> &UvMap {
        match self {
            FaceMaps::Same(map) => map,
            FaceMaps::Each(maps) => maps.get(face).unwrap_or(&UvMap::ZERO),
        }
    }
}

impl From<UvMap> for FaceMaps {
    fn from(map: UvMap) -> Self {
        FaceMaps::Same(map)
    }
}

impl UvMap {
    /// The coordinates (0, 0) everywhere.
    pub const ZERO: UvMap = UvMap { u: DVec4::ZERO, v: DVec4::ZERO };

    /// The largest factor of projections and of changes. It keeps their product finite at the most distant points.
    pub const MOST: f64 = 1e75;

    /// Returns true if no factor is larger than [`UvMap::MOST`].
    pub fn is_bounded(&self) -> bool {
        [self.u, self.v].iter().all(|row| row.abs().cmple(DVec4::splat(UvMap::MOST)).all())
    }

    /// The coordinates of a point of the world.
    #[inline]
    pub fn at(&self, point: DVec3) -> DVec2 {
        let along = |f: DVec4| f.x * point.x + f.y * point.y + f.z * point.z + f.w;
        DVec2::new(along(self.u), along(self.v))
    }

    /// Returns true if points along a direction have the same coordinates, except for rounding.
    pub fn is_constant_along(&self, direction: DVec3) -> bool {
        let row = |row: DVec4| {
            let factors = row.truncate();
            factors.dot(direction).abs() <= CONSTANT_EPSILON * factors.length()
        };
        row(self.u) && row(self.v)
    }

    /// The map composed with a map `move_point` that is applied before it.
    pub fn after(&self, move_point: &DAffine3) -> Self {
        let row = |row: DVec4| {
            let factors = row.truncate();
            let constant = row.w + factors.dot(move_point.translation);
            (move_point.matrix3.transpose() * factors).extend(constant)
        };
        UvMap { u: row(self.u), v: row(self.v) }
    }

    /// The map composed with a map `change` that is applied after it.
    pub fn then(&self, change: &DAffine2) -> Self {
        let (matrix, by) = (change.matrix2.transpose(), change.translation);
        let row = |factors: DVec2, sum: f64| self.u * factors.x + self.v * factors.y + DVec4::new(0.0, 0.0, 0.0, sum);
        UvMap { u: row(matrix.x_axis, by.x), v: row(matrix.y_axis, by.y) }
    }
}

/// The maps of a set in a list, if any.
pub fn find(maps: &[SetMap], set: usize) -> Option<&FaceMaps> {
    maps.iter().find(|known| known.set == set).map(|known| &known.maps)
}

#[cfg(test)]
mod tests {
    use glam::{DMat2, DMat3};

    use super::*;

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

    #[test]
    fn a_point_has_the_coordinates_of_two_affine_functions() {
        let map = UvMap { u: DVec4::new(0.5, 0.0, 0.0, 1.0), v: DVec4::new(0.0, 2.0, -1.0, 0.25) };
        assert_eq!(map.at(DVec3::new(4.0, 3.0, 2.0)), DVec2::new(3.0, 4.25));
        let maps = [SetMap { set: 2, maps: map.into() }];
        assert_eq!((find(&maps, 2), find(&maps, 0)), (Some(&FaceMaps::Same(map)), None));
        assert_eq!(maps[0].maps.of_face(5), &map);
        let each =
            FaceMaps::Each(Arc::new([1.0, 2.0, 3.0, 4.0, 5.0, 6.0].map(|u| UvMap { u: DVec4::splat(u), v: map.v })));
        assert_eq!((each.of_face(1).u.x, each.of_face(5).u.x, each.of_face(6)), (2.0, 6.0, &UvMap::ZERO));
    }
}
