//! Convex polygons in space, cut by planes.

use glam::DVec3;

/// Appends the part of a polygon on the side of a plane where `height` is not negative.
pub(super) fn clip(polygon: &[DVec3], height: impl Fn(DVec3) -> f64, out: &mut Vec<DVec3>) {
    let Some(&last) = polygon.last() else { return };
    let (mut a, mut from) = (last, height(last));
    for &b in polygon {
        let to = height(b);
        if (from < 0.0) != (to < 0.0) {
            out.push(crossing([a, b], [from, to]));
        }
        if 0.0 <= to {
            out.push(b);
        }
        (a, from) = (b, to);
    }
}

/// The point of an edge at height 0, from the ends and their heights.
pub(super) fn crossing([a, b]: [DVec3; 2], [from, to]: [f64; 2]) -> DVec3 {
    a + (b - a) * (from / (from - to)).clamp(0.0, 1.0)
}

/// The part of a convex polygon above the edges of another one, which has the normal: `slack` is added to all heights.
pub(super) fn clip_to_prism(polygon: &[DVec3], prism: &[DVec3], normal: DVec3, slack: f64) -> Vec<DVec3> {
    let mut inner = polygon.to_vec();
    let mut next = Vec::with_capacity(polygon.len() + 4);
    for [a, inwards] in edge_planes(prism, normal) {
        next.clear();
        clip(&inner, |point| (point - a).dot(inwards) + slack, &mut next);
        std::mem::swap(&mut inner, &mut next);
        if inner.len() < 3 {
            inner.clear();
            break;
        }
    }
    inner
}

/// The planes through the edges of a convex polygon and along its normal, as a point and the unit vector to the polygon's side.
pub(super) fn edge_planes(polygon: &[DVec3], normal: DVec3) -> impl Iterator<Item = [DVec3; 2]> + '_ {
    let next = polygon.iter().cycle().skip(1);
    polygon.iter().zip(next).map(move |(a, b)| [*a, normal.cross(*b - *a).normalize_or_zero()])
}

/// Returns true if a convex polygon is wider than `width`.
pub(super) fn is_wider(polygon: &[DVec3], width: f64) -> bool {
    let Some(&last) = polygon.last() else { return false };
    let (mut double_area, mut around) = (DVec3::ZERO, 0.0);
    let (first, mut a) = (polygon[0], last);
    for &b in polygon {
        double_area += (a - first).cross(b - first);
        around += a.distance(b);
        a = b;
    }
    // A long rectangle has its width, and a disk has half of it.
    width * around < double_area.length()
}

/// The centre of the corners of a convex polygon, weighted by the lengths of the edges at them.
pub(super) fn middle(polygon: &[DVec3]) -> DVec3 {
    let Some(&last) = polygon.last() else { return DVec3::ZERO };
    let (mut sum, mut around, mut a) = (DVec3::ZERO, 0.0, last);
    for &b in polygon {
        let length = a.distance(b);
        // Relative to one corner, so that a place far from the origin costs no accuracy.
        sum += ((a - last) + (b - last)) * (0.5 * length);
        around += length;
        a = b;
    }
    if 0.0 < around { last + sum / around } else { last }
}
