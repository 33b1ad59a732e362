//! `t`, `s`, `r` and `center`: the scope moves, and the geometry with it.

use glam::DVec3;

use crate::geometry::rotation::turn;

use super::{Length, settle};
use crate::fault::FaultKind;
use crate::run::env::Env;
use crate::shape::Shape;
use crate::shape::scope::Scope;

/// `t(x, y, z)`: moves along the scope's own axes (*t operation*).
pub fn translate(env: &mut Env, shape: &mut Shape, x: Length, y: Length, z: Length) {
    let size = shape.scope.size;
    let by = DVec3::new(
        x.of(size.x, env, "`t` along x"),
        y.of(size.y, env, "`t` along y"),
        z.of(size.z, env, "`t` along z"),
    );
    let before = shape.scope;
    shape.scope.origin += shape.scope.axes * by;
    settle(env, shape, &before, "`t`");
    shape.carry(&before);
}

/// `s(x, y, z)`: sets the size; the origin corner stays (*s operation*). A size beyond 1e149 m keeps the old size
/// along that axis.
pub fn size(env: &mut Env, shape: &mut Shape, x: Length, y: Length, z: Length) {
    let old = shape.scope.size;
    let mut new =
        DVec3::new(x.of(old.x, env, "`s` along x"), y.of(old.y, env, "`s` along y"), z.of(old.z, env, "`s` along z"));
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
    let turn = turn(env.finite(x, "`r` about x"), env.finite(y, "`r` about y"), env.finite(z, "`r` about z"));
    let (before, centre) = (shape.scope, shape.scope.centre());
    shape.scope.axes = shape.pivot.axes * turn * shape.pivot.axes.transpose() * shape.scope.axes;
    if about == RotateAbout::ScopeCenter {
        shape.scope.origin += centre - shape.scope.centre();
    }
    settle(env, shape, &before, "`r`");
    shape.carry(&before);
}

/// The scope axes along which `center` moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs, reason = "the names are those of the language")]
pub enum CenterAxes {
    X,
    Y,
    Z,
    Xy,
    Xz,
    Yz,
    Xyz,
}

/// `center(axes)`: moves the scope along the named axes so that its centre is the centre of `base` (*center
/// operation*). `base` is the scope at the start of the rule, bracket or part.
pub fn center(env: &mut Env, shape: &mut Shape, base: &Scope, axes: CenterAxes) {
    use CenterAxes::{X, Xy, Xyz, Xz, Y, Yz, Z};
    let along = DVec3::new(
        if matches!(axes, X | Xy | Xz | Xyz) { 1.0 } else { 0.0 },
        if matches!(axes, Y | Xy | Yz | Xyz) { 1.0 } else { 0.0 },
        if matches!(axes, Z | Xz | Yz | Xyz) { 1.0 } else { 0.0 },
    );
    let before = shape.scope;
    let way = shape.scope.axes.transpose() * (base.centre() - shape.scope.centre());
    shape.scope.origin += shape.scope.axes * (way * along);
    settle(env, shape, &before, "`center`");
    shape.carry(&before);
}
