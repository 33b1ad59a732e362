//! Segments in a plane.

use glam::DVec2;

/// The relative position on a segment of the point that is nearest to another point; 0.5 for a segment without length.
pub fn nearest_share(p: DVec2, [a, b]: [DVec2; 2]) -> f64 {
    let along = b - a;
    let share = (p - a).dot(along) / along.length_squared();
    if share.is_nan() { 0.5 } else { share.clamp(0.0, 1.0) }
}
