//! Rotations in degrees.

use glam::{DMat3, DVec3};

use crate::tol::ANGLE_EPSILON;

/// The rotation by degrees about x, then y, then z.
pub fn turn(x: f64, y: f64, z: f64) -> DMat3 {
    let ((sx, cx), (sy, cy), (sz, cz)) = (sin_cos(x), sin_cos(y), sin_cos(z));
    let about_x = DMat3::from_cols(DVec3::X, DVec3::new(0.0, cx, sx), DVec3::new(0.0, -sx, cx));
    let about_y = DMat3::from_cols(DVec3::new(cy, 0.0, -sy), DVec3::Y, DVec3::new(sy, 0.0, cy));
    let about_z = DMat3::from_cols(DVec3::new(cz, sz, 0.0), DVec3::new(-sz, cz, 0.0), DVec3::Z);
    about_z * about_y * about_x
}

/// The angles from which [`turn`] makes a rotation, in degrees, above -180 and up to 180: a half turn is 180, whichever way rounding
/// makes it.
pub fn angles(turn: &DMat3) -> DVec3 {
    let (x, y, z) = (turn.x_axis, turn.y_axis, turn.z_axis);
    let about_y = libm::asin((-x.z).clamp(-1.0, 1.0));
    // At a quarter turn about y the other two angles are not unique; z is set to 0.
    let (about_x, about_z) = if x.z.abs() < 1.0 - 1e-12 {
        (libm::atan2(y.z, z.z), libm::atan2(x.y, x.x))
    } else {
        (libm::atan2(-z.y, y.y), 0.0)
    };
    let normal = |angle: f64| {
        let is_half = angle <= ANGLE_EPSILON - std::f64::consts::PI;
        if is_half { 180.0 } else { angle.to_degrees() + 0.0 }
    };
    DVec3::new(normal(about_x), normal(about_y), normal(about_z))
}

/// The sine and cosine of an angle in degrees, exact at quarter turns.
pub fn sin_cos(degrees: f64) -> (f64, f64) {
    match degrees.rem_euclid(360.0) {
        0.0 => (0.0, 1.0),
        90.0 => (1.0, 0.0),
        180.0 => (0.0, -1.0),
        270.0 => (-1.0, 0.0),
        _ => libm::sincos(degrees.to_radians()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_half_turn_has_one_angle() {
        for by in [180.0, -180.0, 540.0, 180.0 + 1e-14, -180.0 - 1e-13, 180.0 - 1e-14, -180.0 + 1e-13] {
            assert!((angles(&turn(by, 0.0, 0.0)) - DVec3::new(180.0, 0.0, 0.0)).length() < 1e-9, "{by}");
            assert!((angles(&turn(0.0, 0.0, by)) - DVec3::new(0.0, 0.0, 180.0)).length() < 1e-9, "{by}");
            assert!((angles(&turn(0.0, by, 0.0)) - DVec3::new(180.0, 0.0, 180.0)).length() < 1e-9, "{by}");
        }
        // Other angles keep their sign.
        assert!((angles(&turn(-179.9, 0.0, 20.0)) - DVec3::new(-179.9, 0.0, 20.0)).length() < 1e-9);
        assert!(angles(&turn(0.0, -0.0, 0.0)).to_array().iter().all(|angle| angle.is_sign_positive()));
    }
}
