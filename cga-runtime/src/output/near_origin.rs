//! The origin of coordinates in 32 bits.

use glam::DVec3;

use crate::geometry::mesh::Bounds;

/// The farthest coordinate in metres that is finer than a millimetre in 32 bits.
const FINE: f64 = 8192.0;

/// A number that no coordinate of a point exceeds; infinite if a coordinate is not a number.
#[inline]
pub(super) fn reach(point: DVec3) -> f64 {
    let sum = point.abs().element_sum();
    if sum.is_nan() { f64::INFINITY } else { sum }
}

/// As [`near_origin`]. No coordinate exceeds `reach` metres, so near the origin of the world the bounds are not computed.
pub(super) fn near_origin_within(reach: f64, bounds: impl FnOnce() -> Bounds) -> DVec3 {
    if reach <= FINE { DVec3::ZERO } else { near_origin(bounds()) }
}

/// The origin of the world. If 32-bit floats relative to it would be off by more than a millimetre, a point in whole
/// metres near geometry with those bounds.
pub(super) fn near_origin(bounds: Bounds) -> DVec3 {
    let reach = bounds.low.abs().max(bounds.high.abs()).max_element();
    if !bounds.low.is_finite() || !bounds.high.is_finite() || reach <= FINE {
        return DVec3::ZERO;
    }
    let middle = (bounds.low + bounds.high) * 0.5;
    DVec3::new(middle.x, bounds.low.y, middle.z).round()
}
