//! Areas and volumes of leaves.
//!
//! Volumes are signed: positive for a closed surface whose faces look outwards. The volume of an open surface has no
//! meaning.

use glam::DAffine3;

use crate::geometry::mesh::Mesh;
use crate::geometry::mesh::map::normal_map;
use crate::run::sink::{Cuboid, Quad};

/// The area in square metres.
pub(crate) fn quad_area(quad: &Quad) -> f64 {
    quad.u.cross(quad.v).length()
}

/// The surface of a box in square metres.
pub(crate) fn cuboid_area(cuboid: &Cuboid) -> f64 {
    let [x, y, z] = [cuboid.sides.x_axis, cuboid.sides.y_axis, cuboid.sides.z_axis];
    2.0 * (x.cross(y).length() + y.cross(z).length() + z.cross(x).length())
}

/// The volume of a box in cubic metres.
pub(crate) fn cuboid_volume(cuboid: &Cuboid) -> f64 {
    cuboid.sides.determinant()
}

/// The surface of a placed mesh in square metres, without holes.
pub(crate) fn mesh_area(mesh: &Mesh, placement: &DAffine3) -> f64 {
    let turn = normal_map(&placement.matrix3);
    mesh.faces().map(|face| face.sum_of_vectors(|vector| (turn * vector).length())).sum::<f64>() * 0.5
}

/// The volume of a placed mesh in cubic metres.
pub(crate) fn mesh_volume(mesh: &Mesh, placement: &DAffine3) -> f64 {
    mesh.volume() * placement.matrix3.determinant()
}
