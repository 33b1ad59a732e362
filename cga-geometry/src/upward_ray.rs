//! Rays upwards, which count how often a closed surface winds around a point.

use glam::{DVec2, DVec3};

use crate::each::Each;
use crate::exact::{orient, orient_in_space};

/// The part of a triangle in the winding number around a point: 1 or -1 if the ray upwards from the point meets the triangle, else 0.
/// The sum over a closed surface is the winding number, without rounding.
///
/// A point above or below an edge is on the side of it that [`side`] returns, for both triangles at the edge, so it meets one of them.
#[inline]
pub(crate) fn winding_part(point: DVec3, triangle: [DVec3; 3]) -> i32 {
    let (at, [a, b, c]) = (flat(point), triangle.each(flat));
    let sides = [side(a, b, at), side(b, c, at), side(c, a, at)];
    // A triangle that is upright is never met.
    let is_met = sides[0] != 0 && sides[0] == sides[1] && sides[1] == sides[2] && is_below(point, triangle, sides[0]);
    if is_met { sides[0] } else { 0 }
}

/// The place of a point seen from above.
#[inline]
pub(crate) fn flat(point: DVec3) -> DVec2 {
    DVec2::new(point.x, point.z)
}

/// The side of a line on which a point is after an infinitely small move to the right, and a far smaller one upwards: 1 on the left, -1 on
/// the right, 0 if the line has no direction.
fn side(a: DVec2, b: DVec2, at: DVec2) -> i32 {
    let sign = |number: f64| i32::from(0.0 < number) - i32::from(number < 0.0);
    match orient(a, b, at) {
        0 if a.y != b.y => sign(a.y - b.y),
        0 => sign(b.x - a.x),
        known => known,
    }
}

/// Returns true if a point is below a triangle that is counter-clockwise in x and z, with `turn` 1, or clockwise, with -1: the normal of
/// the first one points down.
fn is_below(point: DVec3, [a, b, c]: [DVec3; 3], turn: i32) -> bool {
    orient_in_space(a, b, c, point) == turn
}
