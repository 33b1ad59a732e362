//! The exact orientation tests in the plane and in space, and the lexicographic order of points.
//!
//! A floating-point filter decides nearly all cases; the others are summed without rounding.

use crate::each::Each;
use glam::{DVec2, DVec3};

/// 1 if `c` is left of the line from `a` to `b`, -1 if right, 0 if the three points are collinear. Exact unless a
/// product of coordinates underflows.
#[inline]
pub fn orient(a: DVec2, b: DVec2, c: DVec2) -> i32 {
    let left = (a.x - c.x) * (b.y - c.y);
    let right = (a.y - c.y) * (b.x - c.x);
    let det = left - right;
    // Shewchuk's bound for this expression: (3 + 16 u) u. Products below the smallest normal number have a further
    // error, hence the addend.
    let bound = 3.330_669_073_875_471_6e-16 * (left.abs() + right.abs()) + f64::MIN_POSITIVE;
    if det > bound {
        1
    } else if -det > bound {
        -1
    } else {
        orient_exact(a, b, c)
    }
}

/// 1 if `d` is on the side of the plane through `a`, `b` and `c` to which its normal `(b - a) × (c - a)` points, -1 if it is on
/// the other side, 0 if the four points are coplanar. Exact unless a product of coordinates underflows.
#[inline]
pub fn orient_in_space(a: DVec3, b: DVec3, c: DVec3, d: DVec3) -> i32 {
    let [p, q, r] = [a, b, c].each(|point| point - d);
    let minors = [(q.x * r.y, r.x * q.y, p.z), (r.x * p.y, p.x * r.y, q.z), (p.x * q.y, q.x * p.y, r.z)];
    let (mut det, mut size) = (0.0, 0.0);
    for (left, right, factor) in minors {
        det += (left - right) * factor;
        size += (left.abs() + right.abs()) * factor.abs();
    }
    // Shewchuk's bound for this expression, (7 + 56 u) u, and an addend as above.
    let bound = 7.771_561_172_376_103e-16 * size + f64::MIN_POSITIVE;
    // Seen from `d`, the corners are clockwise if the normal points towards it.
    if det > bound {
        -1
    } else if -det > bound {
        1
    } else {
        orient_in_space_exact([a, b, c, d])
    }
}

/// The lexicographic order of coordinates: to the right, then upwards.
#[inline]
pub fn comes_first(a: DVec2, b: DVec2) -> bool {
    a.x < b.x || (a.x == b.x && a.y < b.y)
}

#[cold]
fn orient_exact(a: DVec2, b: DVec2, c: DVec2) -> i32 {
    // Neighbouring edges of a polygon share points.
    if a == b || b == c || c == a {
        return 0;
    }
    /// 2^-550 and 2^550. They make products of large coordinates finite, and products of small ones normal.
    const SMALLER: f64 = f64::from_bits((1023 - 550) << 52);
    const LARGER: f64 = f64::from_bits((1023 + 550) << 52);
    let size = [a, b, c].iter().fold(0.0, |size: f64, p| size.max(p.x.abs()).max(p.y.abs()));
    let scale = match size {
        _ if 1e150 < size => SMALLER,
        _ if size < 1e-150 => LARGER,
        _ => 1.0,
    };
    let [a, b, c] = [a, b, c].each(|p| p * scale);
    let mut sum = Expansion::<12>::ZERO;
    for (x, y) in [(a.x, b.y), (b.x, c.y), (c.x, a.y)] {
        sum.add_product(x, y);
    }
    for (x, y) in [(a.x, c.y), (b.x, a.y), (c.x, b.y)] {
        sum.add_product(-x, y);
    }
    sum.sign()
}

#[cold]
fn orient_in_space_exact(points: [DVec3; 4]) -> i32 {
    let size = points.iter().fold(0.0, |size: f64, point| size.max(point.abs().max_element()));
    if size == 0.0 {
        return 0;
    }
    // The largest coordinate becomes 1 to 2, so products of three are finite and normal.
    let by = -libm::ilogb(size);
    let [a, b, c, d] = points.each(|point| DVec3::from_array(point.to_array().each(|at| libm::scalbn(at, by))));
    // The determinant of the points with a fourth coordinate of 1, by the minors of three points.
    let mut sum = Expansion::<96>::ZERO;
    for ([p, q, r], sign) in [([a, b, c], -1.0), ([a, b, d], 1.0), ([a, c, d], -1.0), ([b, c, d], 1.0)] {
        for (p, q, r) in [(p, q, r), (q, r, p), (r, p, q)] {
            for (x, y, z) in [(p.x, q.y, sign * r.z), (q.x, p.y, -sign * r.z)] {
                product(x, y).each(|part| sum.add_product(part, z));
            }
        }
    }
    sum.sign()
}

/// A sum of at most `N` floating-point numbers that do not overlap, smallest first.
struct Expansion<const N: usize> {
    parts: [f64; N],
    len: usize,
}

impl<const N: usize> Expansion<N> {
    const ZERO: Self = Expansion { parts: [0.0; N], len: 0 };

    fn add_product(&mut self, x: f64, y: f64) {
        product(x, y).each(|part| self.add(part));
    }

    /// Adds a number without rounding, by Knuth's two-sum over the parts.
    fn add(&mut self, value: f64) {
        let mut carry = value;
        let mut kept = 0;
        for i in 0..self.len {
            let part = self.parts[i];
            let sum = carry + part;
            let virt = sum - carry;
            let error = (carry - (sum - virt)) + (part - virt);
            carry = sum;
            if error != 0.0 {
                self.parts[kept] = error;
                kept += 1;
            }
        }
        if carry != 0.0 && kept < self.parts.len() {
            self.parts[kept] = carry;
            kept += 1;
        }
        self.len = kept;
    }

    fn sign(&self) -> i32 {
        match self.len.checked_sub(1).map(|last| self.parts[last]) {
            Some(top) if top > 0.0 => 1,
            Some(top) if top < 0.0 => -1,
            _ => 0,
        }
    }
}

/// The product of two numbers as a sum, with the rounding error first.
fn product(x: f64, y: f64) -> [f64; 2] {
    let high = x * y;
    let (xh, xl) = split(x);
    let (yh, yl) = split(y);
    [((xh * yh - high) + xh * yl + xl * yh) + xl * yl, high]
}

/// The upper and the lower half of the digits.
fn split(x: f64) -> (f64, f64) {
    let c = 134_217_729.0 * x; // 2^27 + 1
    let high = c - (c - x);
    (high, x - high)
}

/// The winding number of a loop around a point, counter-clockwise. `None` for a point on the loop.
pub fn winding(ring: &[DVec2], p: DVec2) -> Option<i32> {
    let mut turns = 0;
    let mut a = *ring.last()?;
    for &b in ring {
        let side = orient(a, b, p);
        if side == 0 && p.cmpge(a.min(b)).all() && p.cmple(a.max(b)).all() {
            return None;
        }
        if a.y <= p.y && p.y < b.y && side > 0 {
            turns += 1;
        } else if b.y <= p.y && p.y < a.y && side < 0 {
            turns -= 1;
        }
        a = b;
    }
    Some(turns)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_ulp_off_the_line_is_seen() {
        let a = DVec2::new(0.1, 0.1);
        let b = DVec2::new(0.7, 0.7);
        let c = DVec2::new(0.3, 0.3);
        assert_eq!(orient(a, b, c), 0);
        assert_eq!(orient(a, b, DVec2::new(0.3, 0.3f64.next_up())), 1);
        assert_eq!(orient(a, b, DVec2::new(0.3, 0.3f64.next_down())), -1);
        let far = DVec2::splat(500_000.0);
        assert_eq!(orient(a + far, b + far, DVec2::new((a + far).x, (a + far).y.next_up())), 1);
    }

    /// The side of a plane on which a point is, for whole coordinates.
    fn sign_of(points: [[i64; 3]; 4]) -> i32 {
        let [a, b, c, d] = points.map(|point| point.map(i128::from));
        let off = |p: [i128; 3]| [p[0] - a[0], p[1] - a[1], p[2] - a[2]];
        let [p, q, r] = [b, c, d].map(off);
        let cross = [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]];
        (cross[0] * r[0] + cross[1] * r[1] + cross[2] * r[2]).signum() as i32
    }

    #[test]
    fn the_side_of_a_plane_is_that_of_whole_numbers() {
        let mut rng = crate::random::Rng(3);
        let mut seen = [0; 3];
        for round in 0..20_000 {
            // Few values give many coplanar points, large ones need all digits.
            let range = [4, 1000, 1 << 26][round % 3];
            let whole = [(); 4].map(|()| [(); 3].map(|()| (rng.next() % range) as i64 - range as i64 / 2));
            let points = whole.map(|point| DVec3::from_array(point.map(|number| number as f64)));
            let expected = sign_of(whole);
            for scale in [1.0, 2f64.powi(-340), 2f64.powi(340)] {
                let [a, b, c, d] = points.map(|point| point * scale);
                assert_eq!(orient_in_space(a, b, c, d), expected, "{whole:?} {scale}");
                assert_eq!(orient_in_space(b, a, c, d), -expected, "{whole:?} {scale}");
            }
            seen[(expected + 1) as usize] += 1;
            // One ulp away from the plane.
            let [a, b, c, d] = points;
            let normal = (b - a).cross(c - a);
            if expected == 0 && normal.y != 0.0 && d.y != 0.0 {
                let [up, down] = [d.y.next_up(), d.y.next_down()].map(|y| orient_in_space(a, b, c, d.with_y(y)));
                assert_eq!([up, down], [1, -1].map(|side| side * normal.y.signum() as i32), "{whole:?}");
            }
        }
        assert!(seen.iter().all(|count| 200 < *count), "{seen:?}");
    }
}
