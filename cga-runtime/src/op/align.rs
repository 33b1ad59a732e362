//! `alignScopeToAxes` and `rotateScope`: the scope turns, and the geometry stays.

use glam::{DMat3, DVec3};

use super::finite;
use super::refit::refit;
use crate::geometry::mesh::unit;
use crate::geometry::rotation::turn;
use crate::run::env::Env;
use crate::shape::Shape;

/// The axes that a scope is aligned to: one or all three, of the world or of the object.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct AlignAxes {
    of_object: bool,
    /// The number of the axis, or none for all.
    axis: Option<usize>,
}

#[allow(missing_docs, non_upper_case_globals, reason = "the names are those of the language")]
impl AlignAxes {
    pub const WorldX: AlignAxes = AlignAxes { of_object: false, axis: Some(0) };
    pub const WorldY: AlignAxes = AlignAxes { of_object: false, axis: Some(1) };
    pub const WorldZ: AlignAxes = AlignAxes { of_object: false, axis: Some(2) };
    pub const WorldXyz: AlignAxes = AlignAxes { of_object: false, axis: None };
    pub const ObjectX: AlignAxes = AlignAxes { of_object: true, axis: Some(0) };
    pub const ObjectY: AlignAxes = AlignAxes { of_object: true, axis: Some(1) };
    pub const ObjectZ: AlignAxes = AlignAxes { of_object: true, axis: Some(2) };
    pub const ObjectXyz: AlignAxes = AlignAxes { of_object: true, axis: None };
}

/// `alignScopeToAxes(axes)`: the scope becomes the box of the geometry along those axes, and the pivot moves to its
/// origin corner (*alignScopeToAxes operation*).
pub fn align_to_axes(env: &mut Env, shape: &mut Shape, to: AlignAxes) {
    let system = if to.of_object { env.initial.object.axes } else { DMat3::IDENTITY };
    let axes = to.axis.map_or(system, |axis| upright(&shape.scope.axes, system.col(axis), axis));
    if refit(env, shape, axes, "`alignScopeToAxes`") {
        shape.set_pivot(shape.scope.frame());
    }
}

/// Axes of which `axis` has the direction `to`. A second one is the old axis projected across it: x, or z if `axis`
/// is x. If that projection has no direction, the third axis is projected instead.
pub(super) fn upright(old: &DMat3, to: DVec3, axis: usize) -> DMat3 {
    let across = |other: usize| unit(old.col(other) - to * to.dot(old.col(other)));
    // The projection is too short to have a direction.
    let short = |other: usize| 1.0 - old.col(other).dot(to).abs() < crate::geometry::tol::ANGLE_EPSILON;
    match axis {
        0 if short(2) => from_xy(to, across(1)),
        0 => from_zx(across(2), to),
        1 if short(0) => from_yz(to, across(2)),
        1 => from_xy(across(0), to),
        _ if short(0) => from_yz(across(1), to),
        _ => from_zx(to, across(0)),
    }
}

fn from_xy(x: DVec3, y: DVec3) -> DMat3 {
    DMat3::from_cols(x, y, x.cross(y))
}

fn from_yz(y: DVec3, z: DVec3) -> DMat3 {
    DMat3::from_cols(y.cross(z), y, z)
}

fn from_zx(z: DVec3, x: DVec3) -> DMat3 {
    DMat3::from_cols(x, z.cross(x), z)
}

/// `rotateScope(x, y, z)`: turns the scope about the pivot's axes, x then y then z, in degrees. It becomes the box of
/// the geometry, and the pivot stays (*rotateScope operation*).
pub fn rotate_scope(env: &mut Env, shape: &mut Shape, x: f64, y: f64, z: f64) {
    let angles = finite(env, "`rotateScope` about", [x, y, z]);
    let pivot = shape.pivot.axes;
    let axes = pivot * turn(angles.x, angles.y, angles.z) * (pivot.transpose() * shape.scope.axes);
    refit(env, shape, axes, "`rotateScope`");
}
