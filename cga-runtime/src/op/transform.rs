//! `t`, `s`, `r` and `center`: the scope moves, and the geometry with it.

use glam::{DMat3, DVec3};

use super::{Length, settle};
use crate::env::Env;
use crate::fault::FaultKind;
use crate::scope::Scope;
use crate::shape::Shape;

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

/// `s(x, y, z)`: sets the size; the origin corner stays (*s operation*). A size beyond 1e149 m leaves the scope's own along
/// that axis.
pub fn size(env: &mut Env, shape: &mut Shape, x: Length, y: Length, z: Length) {
    let old = shape.scope.size;
    let mut new =
        DVec3::new(x.of(old.x, env, "`s` along x"), y.of(old.y, env, "`s` along y"), z.of(old.z, env, "`s` along z"));
    let too_large = new.abs().cmpgt(DVec3::splat(Scope::MOST_SIZE));
    if too_large.any() {
        new = DVec3::select(too_large, old, new);
        env.fault(FaultKind::Value, "`s` leads beyond 1e149 metres; such a size stays as it is");
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

/// Rotation by degrees about x, then y, then z (*CGA Euler angles*).
pub(crate) fn turn(x: f64, y: f64, z: f64) -> DMat3 {
    let ((sx, cx), (sy, cy), (sz, cz)) = (sin_cos(x), sin_cos(y), sin_cos(z));
    let about_x = DMat3::from_cols(DVec3::X, DVec3::new(0.0, cx, sx), DVec3::new(0.0, -sx, cx));
    let about_y = DMat3::from_cols(DVec3::new(cy, 0.0, -sy), DVec3::Y, DVec3::new(sy, 0.0, cy));
    let about_z = DMat3::from_cols(DVec3::new(cz, sz, 0.0), DVec3::new(-sz, cz, 0.0), DVec3::Z);
    about_z * about_y * about_x
}

/// The angles that [`turn`] makes a rotation from, in degrees.
pub(crate) fn angles(turn: &DMat3) -> DVec3 {
    let (x, y, z) = (turn.x_axis, turn.y_axis, turn.z_axis);
    let about_y = libm::asin((-x.z).clamp(-1.0, 1.0));
    // At a quarter turn about y the other two are not separate: all goes to x.
    let (about_x, about_z) = if x.z.abs() < 1.0 - 1e-12 {
        (libm::atan2(y.z, z.z), libm::atan2(x.y, x.x))
    } else {
        (libm::atan2(-z.y, y.y), 0.0)
    };
    DVec3::new(about_x.to_degrees(), about_y.to_degrees(), about_z.to_degrees())
}

/// Sine and cosine of degrees, exact at quarter turns.
pub(crate) fn sin_cos(degrees: f64) -> (f64, f64) {
    match degrees.rem_euclid(360.0) {
        0.0 => (0.0, 1.0),
        90.0 => (1.0, 0.0),
        180.0 => (0.0, -1.0),
        270.0 => (-1.0, 0.0),
        _ => libm::sincos(degrees.to_radians()),
    }
}

/// The scope axes along which `center` moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs, reason = "the names say it")]
pub enum CenterAxes {
    X,
    Y,
    Z,
    Xy,
    Xz,
    Yz,
    Xyz,
}

/// `center(axes)`: moves the scope so that its centre is that of `base`, along the axes named (*center operation*).
/// `base` is the scope at the start of the rule, bracket or part.
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
