//! The origin of coordinates in 32 bits.

use glam::DVec3;

use crate::geometry::mesh::Bounds;

/// The origin of the world. If 32-bit floats relative to it would be off by more than a millimetre, a point in whole
/// metres near geometry with those bounds.
pub(super) fn near_origin(bounds: Bounds) -> DVec3 {
    const FINE: f64 = 8192.0;
    let reach = bounds.low.abs().max(bounds.high.abs()).max_element();
    if !bounds.low.is_finite() || !bounds.high.is_finite() || reach <= FINE {
        return DVec3::ZERO;
    }
    let middle = (bounds.low + bounds.high) * 0.5;
    DVec3::new(middle.x, bounds.low.y, middle.z).round()
}
