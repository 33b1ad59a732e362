//! Convex loops and their fans.

use glam::{DVec2, DVec3};

use super::PlaneProjection;
use crate::each::Each;
use crate::exact::{comes_first, orient};

/// Appends a fan if the loop is convex and a fan has no triangle without area. Returns whether it did.
pub(super) fn fan(points: &[DVec2], out: &mut Vec<[u32; 3]>) -> bool {
    let count = points.len() as u32;
    if count == 3 {
        out.push([0, 1, 2]);
        return true;
    }
    let Some(Some(apex)) = apex(points.len(), |i| points[i]) else { return false };
    let apex = apex as u32;
    let at = |k: u32| if apex + k >= count { apex + k - count } else { apex + k };
    out.extend((1..count - 1).map(|k| [apex, at(k), at(k + 1)]));
    true
}

/// Corners of a quadrilateral that turn by less, relative to the square of its longest side, are left to exact arithmetic.
const SURE_TURN: f64 = 1e-12;

/// Returns true if a quadrilateral in space is convex beyond all rounding errors, without straight corners. Then its fan starts at its
/// first corner.
pub(crate) fn is_surely_convex([a, b, c, d]: [DVec3; 4]) -> bool {
    let projection = PlaneProjection::along((c - a).cross(d - b));
    let sides = [b - a, c - b, d - c, a - d].each(|side| projection.apply(side));
    let longest = sides.iter().fold(0.0, |most: f64, side| most.max(side.abs().max_element()));
    let least = SURE_TURN * longest * longest;
    // Four turns to the left are one full turn. A number that is not finite is never sure.
    (0..4).all(|i| least < sides[i].perp_dot(sides[(i + 1) % 4])) && longest < f64::INFINITY
}

/// Where the fan of a convex loop may start, if anywhere. `None` for a loop that is not convex. Straight corners are
/// allowed.
#[inline]
pub(crate) fn apex(count: usize, at: impl Fn(usize) -> DVec2) -> Option<Option<usize>> {
    // A convex loop never turns right, and it changes from right to left and back only once.
    let mut apex = None;
    let mut turns = 0;
    let (mut previous, mut here) = (at(count - 2), at(count - 1));
    let mut heading = comes_first(previous, here);
    let (mut has_corner, mut is_straight) = (false, false);
    let mut run = 0;
    for i in 0..count {
        let next = at(i);
        let side = orient(previous, here, next);
        if side < 0 || here == next || (side == 0 && (here - previous).dot(next - here) < 0.0) {
            return None;
        }
        let now = comes_first(here, next);
        turns += usize::from(now != heading);
        heading = now;
        // A fan may start at a corner if both its neighbours are proper corners.
        run = if side > 0 { run + 1 } else { 0 };
        if run >= 3 && apex.is_none() {
            apex = Some((i + count - 2) % count);
        }
        has_corner |= side > 0;
        is_straight |= side == 0;
        (previous, here) = (here, next);
    }
    (turns <= 2 && has_corner).then_some(if is_straight { apex } else { Some(0) })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::Rng;
    use crate::vector::unit;

    #[test]
    fn a_quadrilateral_that_is_surely_convex_has_the_fan_of_exact_arithmetic() {
        let mut rng = Rng(3);
        let mut sure = 0;
        for _ in 0..20_000 {
            // Corners of a grid, and others; in a plane that is turned.
            let fine = if rng.unit() < 0.5 { 3.0 } else { 1e9 };
            let mut corner = || DVec2::new((rng.unit() * fine).floor(), (rng.unit() * fine).floor()) / fine;
            let flat = [corner(), corner(), corner(), corner()];
            let (x, y) = unit(DVec3::new(rng.unit() - 0.5, rng.unit() - 0.5, rng.unit() - 0.5)).any_orthonormal_pair();
            let corners = flat.map(|p| x * p.x + y * p.y + 7.0);
            if is_surely_convex(corners) {
                // From the side from which the corners turn left.
                let [a, b, c, d] = corners;
                let seen = PlaneProjection::along((b - a).cross(c - a) + (c - a).cross(d - a));
                let mut found = Vec::new();
                assert!(fan(&corners.map(|p| seen.apply(p)), &mut found), "{corners:?}");
                assert_eq!(found, [[0, 1, 2], [0, 2, 3]], "{corners:?}");
                sure += 1;
            }
        }
        assert!(1000 < sure, "{sure}");
        for odd in [f64::NAN, f64::INFINITY, 1e300] {
            let corners = [DVec3::ZERO, DVec3::X * odd, DVec3::new(odd, 1.0, 0.0), DVec3::Y];
            assert!(!is_surely_convex(corners), "{odd}");
        }
    }
}
