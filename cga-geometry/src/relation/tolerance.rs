//! The length that decides whether surfaces are in contact.

use crate::tol::{CONTACT_DISTANCE, CONTACT_EPSILON, ROUNDING_EPSILON};

/// Coordinates are wrong by several times the rounding error of one operation.
const OPERATIONS: f64 = 64.0;

/// The tolerance between an occluder and a geometry, in metres, from the longest extents of both and the largest coordinate.
#[inline]
pub(super) fn tolerance(extents: [f64; 2], far: f64) -> f64 {
    let [a, b] = extents;
    let smaller = if a <= 0.0 || 0.0 < b && b < a { b } else { a };
    let smaller = if 0.0 < smaller { smaller } else { f64::INFINITY };
    CONTACT_DISTANCE.min(CONTACT_EPSILON * smaller).max(rounding(far))
}

/// The largest tolerance for geometries of any extent.
pub(super) fn largest_tolerance(far: f64) -> f64 {
    CONTACT_DISTANCE.max(rounding(far))
}

/// The rounding error of coordinates up to `far`.
pub(super) fn rounding(far: f64) -> f64 {
    OPERATIONS * ROUNDING_EPSILON * far
}
