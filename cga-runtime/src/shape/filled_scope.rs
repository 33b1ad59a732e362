//! The rectangles and boxes that fill a scope, in the form for sinks.

use std::sync::Arc;

use glam::{DAffine3, DMat3, DVec3};

use crate::geometry::Axis;
use crate::geometry::mesh::Mesh;
use crate::shape::scope::Scope;
use crate::shape::unit::UnitMesh;

/// A flat rectangle with the corners `origin`, `origin + u`, `origin + u + v` and `origin + v`. Its normal is `u ×
/// v`. A side may have length zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quad {
    /// The first corner, in the world.
    pub origin: DVec3,
    /// The first side.
    pub u: DVec3,
    /// The last side, from the origin.
    pub v: DVec3,
    pub(crate) unit: UnitMesh,
}

impl Quad {
    /// A rectangle with the corner `origin` and the sides `u` and `v`.
    pub fn new(origin: DVec3, u: DVec3, v: DVec3) -> Self {
        Quad { origin, u, v, unit: UnitMesh::rectangle(Axis::Z) }
    }

    /// The four corners, counter-clockwise.
    pub fn corners(&self) -> [DVec3; 4] {
        [self.origin, self.origin + self.u, self.origin + self.u + self.v, self.origin + self.v]
    }

    /// The vertices, in the order of `comp(v)`.
    pub(crate) fn points(&self) -> [DVec3; 4] {
        let mut points = self.corners();
        for (corner, &point) in self.corners().into_iter().zip(self.unit.mesh().corners()) {
            points[point as usize] = corner;
        }
        points
    }

    /// The rectangle as a mesh of one face.
    pub fn to_mesh(&self) -> Mesh {
        self.unit.mesh().with_points(self.points().to_vec())
    }
}

/// A closed box: `origin` and three edges. If `sides` is left-handed (a negative scope size), its faces look inwards.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cuboid {
    /// The corner at (0, 0, 0), in the world.
    pub origin: DVec3,
    /// The three edges from that corner, as columns; orthogonal, not of unit length.
    pub sides: DMat3,
    pub(crate) unit: UnitMesh,
}

impl Cuboid {
    /// A box with that corner and those edges. The faces have the order front, right, back, left, top, bottom.
    pub fn new(origin: DVec3, sides: DMat3) -> Self {
        Cuboid { origin, sides, unit: UnitMesh::cuboid() }
    }

    /// The six faces in the order of `comp(f)`, each from its first edge on.
    pub fn faces(&self) -> [Quad; 6] {
        self.unit.sides().map(|face| {
            let axes = face.axes(&self.sides);
            Quad::new(self.origin + self.sides * face.origin, axes.x_axis, axes.y_axis)
        })
    }

    /// The corners of all faces, in the order in which sinks write them.
    pub(crate) fn face_corners(&self) -> impl Iterator<Item = DVec3> + Clone + use<> {
        let corners = self.corners();
        self.unit.sides().iter().flat_map(|face| face.corners).map(move |at| corners[usize::from(at & 7)])
    }

    /// The eight corners; the corner (x, y, z) has the index x + 2y + 4z.
    pub(crate) fn corners(&self) -> [DVec3; 8] {
        let [x, y, z] = [self.sides.x_axis, self.sides.y_axis, self.sides.z_axis];
        let low = [self.origin, self.origin + x, self.origin + y, self.origin + x + y];
        let [a, b, c, d] = low;
        [a, b, c, d, a + z, b + z, c + z, d + z]
    }

    /// The vertices, in the order of `comp(v)`, as sinks write them.
    pub(crate) fn points(&self) -> [DVec3; 8] {
        let (corners, mut points) = (self.corners(), [self.origin; 8]);
        points.iter_mut().zip(self.unit.numbers()).for_each(|(point, at)| *point = corners[usize::from(at & 7)]);
        points
    }

    /// The box as a closed mesh of eight vertices and six faces, in the order of `comp`.
    pub fn to_mesh(&self) -> Mesh {
        self.unit.mesh().map(&DAffine3 { matrix3: self.sides, translation: self.origin })
    }
}

/// The rectangle in the low plane across `axis`, with its normal along that axis. Its first side is the front or
/// bottom edge of the face.
#[inline]
pub(crate) fn rectangle(scope: &Scope, axis: Axis, unit: UnitMesh) -> Quad {
    let (x, y, z) =
        (scope.axes.x_axis * scope.size.x, scope.axes.y_axis * scope.size.y, scope.axes.z_axis * scope.size.z);
    low_side(scope.origin, [x, y, z], axis, unit)
}

/// The rectangle in the low plane across `axis` of a box with that corner and those sides.
#[inline]
pub(crate) fn low_side(origin: DVec3, [x, y, z]: [DVec3; 3], axis: Axis, unit: UnitMesh) -> Quad {
    let (origin, u, v) = match axis {
        Axis::X => (origin + z, -z, y),
        Axis::Y => (origin + z, x, -z),
        Axis::Z => (origin, x, y),
    };
    Quad { origin, u, v, unit }
}

/// The box that fills the scope.
#[inline]
pub(crate) fn cuboid(scope: &Scope, unit: UnitMesh) -> Cuboid {
    Cuboid {
        origin: scope.origin,
        sides: DMat3::from_cols(
            scope.axes.x_axis * scope.size.x,
            scope.axes.y_axis * scope.size.y,
            scope.axes.z_axis * scope.size.z,
        ),
        unit,
    }
}

/// A unit mesh stretched to a size.
pub(crate) fn mesh(unit: UnitMesh, size: DVec3) -> Arc<Mesh> {
    Arc::new(unit.mesh().map(&DAffine3 { matrix3: DMat3::from_diagonal(size), translation: DVec3::ZERO }))
}
