//! The geometry of a shape for functions that go through all of it.

use std::sync::Arc;

use crate::geometry::mesh::Mesh;
use crate::geometry::work;
use crate::run::env::READING;
use crate::shape::{Geometry, Placed, Shape};

/// Counts a pass over the geometry as work, so that rules that only read can be stopped. Returns false if the work is to end.
pub(super) fn may_read(shape: &Shape) -> bool {
    let corners = match &shape.geometry {
        Geometry::Mesh(placed) => placed.mesh.corners().len(),
        Geometry::Wire(wire) => wire.wire.points.len(),
        _ => 0,
    };
    work::spend(READING * corners)
}

/// The mesh and its place, also of boxes and rectangles; `None` if the work is to end.
pub(super) fn placed(shape: &Shape) -> Option<Placed> {
    if may_read(shape) { shape.geometry.placed() } else { None }
}

/// The mesh with its texture coordinates; `None` if the work is to end.
pub(super) fn mesh(shape: &Shape) -> Option<Arc<Mesh>> {
    may_read(shape).then(|| shape.to_mesh())
}
