//! Laws and examples of boolean operations on meshes.

mod boxes;
mod hostile;
mod large;
mod solids;
mod surfaces;
mod tags;

use std::slice::from_ref;

use glam::{DAffine3, DMat3, DVec3};

use super::{BooleanError, BooleanOp, combine};
use crate::mesh::Mesh;
use crate::primitive::cube;

/// The operation on two meshes whose coordinates have rounding errors of their size.
pub(super) fn combined(op: BooleanOp, a: &Mesh, b: &Mesh) -> Result<Mesh, BooleanError> {
    let far = |mesh: &Mesh| mesh.points().iter().fold(0.0f64, |far, point| far.max(point.abs().max_element()));
    let rounding = far(a).max(far(b)) * f64::EPSILON;
    combine(op, [from_ref(a), from_ref(b)], rounding)
}

/// A box between two corners.
pub(super) fn block(low: [f64; 3], high: [f64; 3]) -> Mesh {
    let [low, high] = [low, high].map(DVec3::from);
    cube().map(&DAffine3 { matrix3: DMat3::from_diagonal(high - low), translation: low })
}
