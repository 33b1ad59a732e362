//! Geometry with another form in the same scope.

use crate::geometry::mesh::Mesh;
use crate::geometry::tol::ROUNDING_EPSILON;
use crate::shape::{Geometry, Shape};

/// Replaces the geometry by a mesh in scope coordinates. If the scope was the box of the geometry, it is the box of the mesh
/// afterwards; otherwise it stays, as after a split with `noAdjust`, and so does a mirrored scope. A mesh without faces is no
/// geometry.
pub(in crate::op) fn put_reshaped(shape: &mut Shape, mesh: Mesh) {
    if mesh.is_empty() {
        shape.geometry = Geometry::Empty;
        return;
    }
    let (size, bounds) = (shape.scope.size, mesh.bounds());
    let near = ROUNDING_EPSILON * size.abs().max_element();
    let fills =
        |low: glam::DVec3, high: glam::DVec3| low.abs_diff_eq(glam::DVec3::ZERO, near) && high.abs_diff_eq(size, near);
    let before = shape.to_mesh().bounds();
    if fills(before.low, before.high) && !fills(bounds.low, bounds.high) {
        shape.set_mesh(mesh);
    } else {
        shape.put_mesh(mesh);
    }
}
