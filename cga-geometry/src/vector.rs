//! Vectors of length 1, and the area vectors of polygons in space.

use glam::DVec3;

/// The vector scaled to length 1, or zero. Safe for very small and very large vectors.
pub fn unit(v: DVec3) -> DVec3 {
    let scale = v.abs().max_element();
    if 0.0 < scale && scale < f64::INFINITY { (v / scale).normalize() } else { DVec3::ZERO }
}

/// The normal of a planar polygon with twice the area as its length. Newell's sum, relative to the first corner, so that
/// distance from the origin costs no accuracy.
#[inline(always)]
pub(crate) fn area_vector<R>(rings: impl Iterator<Item = R>) -> DVec3
where
    R: DoubleEndedIterator<Item = DVec3> + Clone,
{
    let (mut first, mut sum) = (None, DVec3::ZERO);
    for ring in rings {
        let (Some(start), Some(end)) = (ring.clone().next(), ring.clone().next_back()) else { continue };
        let from = *first.get_or_insert(start);
        let mut last = end - from;
        for point in ring {
            let here = point - from;
            sum += last.cross(here);
            last = here;
        }
    }
    sum
}

/// An area vector, or the one of the polygon scaled to a size of about 1 if its products overflow or underflow.
#[inline]
pub(crate) fn well_scaled(sum: DVec3, at_one: impl FnOnce() -> DVec3) -> DVec3 {
    /// Far above the size at which products underflow.
    const SMALL: f64 = 1e-250;
    let size = sum.abs().max_element();
    if SMALL < size && size < f64::INFINITY { sum } else { at_one() }
}
