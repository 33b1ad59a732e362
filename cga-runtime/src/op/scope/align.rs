//! `alignScopeToAxes` and `rotateScope`: the scope turns, and the geometry stays.

use glam::{DMat3, DVec3};

use crate::geometry::mesh::unit;
use crate::geometry::rotation::turn;
use crate::op::finite;
use crate::op::scope::new_axes::refit;
use crate::run::env::Env;
use crate::shape::Shape;

/// The axes that a scope is aligned to: one or all three, of the world or of the object.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct AlignAxes {
    of_object: bool,
    /// The number of the axis, or none for all.
    axis: Option<usize>,
}

#[allow(missing_docs, non_upper_case_globals, reason = "the language defines the names")]
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
pub(in crate::op) fn upright(old: &DMat3, to: DVec3, axis: usize) -> DMat3 {
    let across = |other: usize| unit(old.col(other) - to * to.dot(old.col(other)));
    // The projection is too short to have a direction.
    let short = |other: usize| 1.0 - old.col(other).dot(to).abs() < crate::geometry::tol::ANGLE_EPSILON;
    match axis {
        0 if short(2) => axes_of(0, to, across(1)),
        0 => axes_of(2, across(2), to),
        1 if short(0) => axes_of(1, to, across(2)),
        1 => axes_of(0, across(0), to),
        _ if short(0) => axes_of(1, across(1), to),
        _ => axes_of(2, to, across(0)),
    }
}

/// Right-handed axes: `at` is the number of `a`, the next one is `b`, in the order x y z x.
pub(in crate::op) fn axes_of(at: usize, a: DVec3, b: DVec3) -> DMat3 {
    let c = a.cross(b);
    match at {
        0 => DMat3::from_cols(a, b, c),
        1 => DMat3::from_cols(c, a, b),
        _ => DMat3::from_cols(b, c, a),
    }
}

/// `rotateScope(x, y, z)`: turns the scope about the pivot's axes, x then y then z, in degrees. It becomes the box of
/// the geometry, and the pivot stays (*rotateScope operation*).
pub fn rotate_scope(env: &mut Env, shape: &mut Shape, x: f64, y: f64, z: f64) {
    let angles = finite(env, "`rotateScope` about", [x, y, z]);
    let pivot = shape.pivot.axes;
    let axes = pivot * turn(angles.x, angles.y, angles.z) * (pivot.transpose() * shape.scope.axes);
    refit(env, shape, axes, "`rotateScope`");
}
