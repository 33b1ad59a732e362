//! Rotations in degrees.

use glam::{DMat3, DVec3};

/// The rotation by degrees about x, then y, then z (*CGA Euler angles*).
pub(crate) fn turn(x: f64, y: f64, z: f64) -> DMat3 {
    let ((sx, cx), (sy, cy), (sz, cz)) = (sin_cos(x), sin_cos(y), sin_cos(z));
    let about_x = DMat3::from_cols(DVec3::X, DVec3::new(0.0, cx, sx), DVec3::new(0.0, -sx, cx));
    let about_y = DMat3::from_cols(DVec3::new(cy, 0.0, -sy), DVec3::Y, DVec3::new(sy, 0.0, cy));
    let about_z = DMat3::from_cols(DVec3::new(cz, sz, 0.0), DVec3::new(-sz, cz, 0.0), DVec3::Z);
    about_z * about_y * about_x
}

/// The angles from which [`turn`] makes a rotation, in degrees.
pub(crate) fn angles(turn: &DMat3) -> DVec3 {
    let (x, y, z) = (turn.x_axis, turn.y_axis, turn.z_axis);
    let about_y = libm::asin((-x.z).clamp(-1.0, 1.0));
    // At a quarter turn about y the other two angles are not unique; z is set to 0.
    let (about_x, about_z) = if x.z.abs() < 1.0 - 1e-12 {
        (libm::atan2(y.z, z.z), libm::atan2(x.y, x.x))
    } else {
        (libm::atan2(-z.y, y.y), 0.0)
    };
    DVec3::new(about_x.to_degrees(), about_y.to_degrees(), about_z.to_degrees())
}

/// The sine and cosine of an angle in degrees, exact at quarter turns.
pub(crate) fn sin_cos(degrees: f64) -> (f64, f64) {
    match degrees.rem_euclid(360.0) {
        0.0 => (0.0, 1.0),
        90.0 => (1.0, 0.0),
        180.0 => (0.0, -1.0),
        270.0 => (-1.0, 0.0),
        _ => libm::sincos(degrees.to_radians()),
    }
}
