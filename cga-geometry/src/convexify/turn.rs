//! Turns at corners, with collinear corners up to rounding.

use glam::DVec2;

use crate::exact::orient;
use crate::tol::{ROUNDING_EPSILON, STRAIGHT_EPSILON};

/// Returns true if the corner `b` between `a` and `c` turns to the right by more than rounding errors of coordinates that are
/// about 1, or back.
pub(super) fn is_reflex([a, b, c]: [DVec2; 3]) -> bool {
    let (to, on) = (b - a, c - b);
    match orient(a, b, c) {
        1 => false,
        0 => to.dot(on) < 0.0,
        _ => {
            let (long, cross) = (to.length() * on.length(), -to.perp_dot(on));
            let noise = STRAIGHT_EPSILON * long + ROUNDING_EPSILON * (to.length() + on.length());
            noise < cross || to.dot(on) < 0.0
        }
    }
}

/// Returns true if a loop runs around a convex area once, anticlockwise. Corners may be straight. An edge without a length, as
/// between an outline and a hole that touches it along an edge, has no direction; a loop with one is not convex.
pub(super) fn is_convex(ring: &[DVec2]) -> bool {
    let at = |k: usize| ring[k % ring.len()];
    let count = ring.len();
    (0..count).all(|k| at(k) != at(k + 1) && !is_reflex([at(k), at(k + 1), at(k + 2)])) && turns(ring) == 1
}

/// The number of turns that the direction of a loop makes, anticlockwise.
fn turns(ring: &[DVec2]) -> i32 {
    let count = ring.len();
    let direction = |k: usize| ring[(k + 1) % count] - ring[k % count];
    // The number of times that the direction passes the first axis. No turn is by half a circle here.
    let is_up = |way: DVec2| 0.0 < way.y || (way.y == 0.0 && 0.0 < way.x);
    let pass = |k: usize| {
        let (from, to) = (direction(k), direction(k + 1));
        match (is_up(from), is_up(to)) {
            (false, true) if 0.0 <= from.perp_dot(to) => 1,
            (true, false) if from.perp_dot(to) < 0.0 => -1,
            _ => 0,
        }
    };
    (0..count).map(pass).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ring(corners: &[(f64, f64)]) -> Vec<DVec2> {
        corners.iter().map(|&(x, y)| DVec2::new(x, y)).collect()
    }

    #[test]
    fn a_convex_loop_turns_once() {
        let square = ring(&[(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)]);
        assert_eq!((turns(&square), is_convex(&square)), (1, true));
        let with_straight =
            ring(&[(0.0, 0.0), (0.3, 1e-17), (0.6, 0.0), (1.0, 0.0), (1.0, 0.5), (1.0, 1.0), (0.0, 1.0)]);
        assert_eq!((turns(&with_straight), is_convex(&with_straight)), (1, true));
        let clockwise: Vec<DVec2> = square.iter().rev().copied().collect();
        assert_eq!((turns(&clockwise), is_convex(&clockwise)), (-1, false));
        let star: Vec<DVec2> = (0..5)
            .map(|k| libm::sincos(f64::from(k) * 0.8 * std::f64::consts::PI))
            .map(|(sin, cos)| DVec2::new(cos, sin))
            .collect();
        assert_eq!((turns(&star), is_convex(&star)), (2, false));
        assert!(!is_convex(&[square[0], square[0], square[1], square[2]]));
        assert!(!is_convex(&[square[0], square[1], square[1], square[0]]));
    }

    #[test]
    fn rounding_is_no_concave_corner() {
        // Neighbours so near to each other that their coordinates have few digits.
        let close = |down: f64| [(0.0, 0.0), (1e-9, down), (2e-9, 0.0)].map(|(x, y)| DVec2::new(1.0 + x, 1.0 + y));
        assert!(!is_reflex(close(f64::EPSILON)) && is_reflex(close(1e-13)));
        let near = |down: f64| [DVec2::ZERO, DVec2::new(1.0, -down), DVec2::new(2.0, 0.0)];
        assert!(!is_reflex(near(-1e-9)) && is_reflex(near(-1e-6)) && !is_reflex(near(1.0)));
        // A corner that turns back is none of a convex loop.
        assert!(is_reflex([DVec2::ZERO, DVec2::X, DVec2::ZERO]));
    }
}
