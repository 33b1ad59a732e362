//! `t`, `s`, `r` and `center`: the scope moves, and the geometry with it.

use glam::DVec3;

use crate::geometry::rotation::turn;

use crate::fault::FaultKind;
use crate::op::{Length, finite, lengths, settle};
use crate::run::env::Env;
use crate::shape::Shape;
use crate::shape::scope::Scope;

/// `t(x, y, z)`: moves along the scope's own axes (*t operation*).
pub fn translate(env: &mut Env, shape: &mut Shape, x: Length, y: Length, z: Length) {
    let size = shape.scope.size;
    let by = lengths(env, "`t`", [x, y, z], size);
    let before = shape.scope;
    shape.scope.origin += shape.scope.axes * by;
    settle(env, shape, &before, "`t`");
    shape.carry(&before);
}

/// `s(x, y, z)`: sets the size; the origin corner stays (*s operation*). A size beyond 1e149 m keeps the old size
/// along that axis.
pub fn size(env: &mut Env, shape: &mut Shape, x: Length, y: Length, z: Length) {
    let old = shape.scope.size;
    let mut new = lengths(env, "`s`", [x, y, z], old);
    let too_large = new.abs().cmpgt(DVec3::splat(Scope::MOST_SIZE));
    if too_large.any() {
        new = DVec3::select(too_large, old, new);
        env.fault(FaultKind::Value, "a size of `s` exceeds 1e149 metres; it stays as it is");
    }
    shape.resize(new);
}

/// `r(x, y, z)`: turns about the pivot's axes, x then y then z, around the scope's origin (*r operation*).
pub fn rotate(env: &mut Env, shape: &mut Shape, x: f64, y: f64, z: f64) {
    rotate_about(env, shape, RotateAbout::ScopeOrigin, x, y, z);
}

/// The point that `r` turns around.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RotateAbout {
    /// The scope's origin corner.
    ScopeOrigin,
    /// The scope's centre.
    ScopeCenter,
}

/// `r(scopeOrigin | scopeCenter, x, y, z)` (*r operation*).
pub fn rotate_about(env: &mut Env, shape: &mut Shape, about: RotateAbout, x: f64, y: f64, z: f64) {
    let angles = finite(env, "`r` about", [x, y, z]);
    let turn = turn(angles.x, angles.y, angles.z);
    let (before, centre) = (shape.scope, shape.scope.centre());
    shape.scope.axes = shape.pivot.axes * turn * shape.pivot.axes.transpose() * shape.scope.axes;
    if about == RotateAbout::ScopeCenter {
        shape.scope.origin += centre - shape.scope.centre();
    }
    settle(env, shape, &before, "`r`");
    shape.carry(&before);
}

/// The scope axes along which `center` moves: 1 for each of them, otherwise 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CenterAxes(DVec3);

#[allow(missing_docs, non_upper_case_globals, reason = "the language defines the names")]
impl CenterAxes {
    pub const X: CenterAxes = CenterAxes(DVec3::new(1.0, 0.0, 0.0));
    pub const Y: CenterAxes = CenterAxes(DVec3::new(0.0, 1.0, 0.0));
    pub const Z: CenterAxes = CenterAxes(DVec3::new(0.0, 0.0, 1.0));
    pub const Xy: CenterAxes = CenterAxes(DVec3::new(1.0, 1.0, 0.0));
    pub const Xz: CenterAxes = CenterAxes(DVec3::new(1.0, 0.0, 1.0));
    pub const Yz: CenterAxes = CenterAxes(DVec3::new(0.0, 1.0, 1.0));
    pub const Xyz: CenterAxes = CenterAxes(DVec3::new(1.0, 1.0, 1.0));
}

/// `center(axes)`: moves the scope along the named axes so that its centre is the centre of `base` (*center
/// operation*). `base` is the scope at the start of the rule, bracket or part.
pub fn center(env: &mut Env, shape: &mut Shape, base: &Scope, axes: CenterAxes) {
    let before = shape.scope;
    let way = shape.scope.axes.transpose() * (base.centre() - shape.scope.centre());
    shape.scope.origin += shape.scope.axes * (way * axes.0);
    settle(env, shape, &before, "`center`");
    shape.carry(&before);
}
