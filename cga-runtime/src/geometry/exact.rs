//! The exact orientation test, and the lexicographic order of points.
//!
//! A floating-point filter decides nearly all cases; the others are summed without rounding.

use crate::value::each::Each;
use glam::DVec2;

/// 1 if `c` is left of the line from `a` to `b`, -1 if right, 0 if the three points are collinear. Exact unless a
/// product of coordinates underflows.
#[inline]
pub(crate) fn orient(a: DVec2, b: DVec2, c: DVec2) -> i32 {
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

/// The lexicographic order of coordinates: to the right, then upwards.
#[inline]
pub(crate) fn comes_first(a: DVec2, b: DVec2) -> bool {
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
    let mut sum = Expansion { parts: [0.0; 12], len: 0 };
    for (x, y) in [(a.x, b.y), (b.x, c.y), (c.x, a.y)] {
        sum.add_product(x, y);
    }
    for (x, y) in [(a.x, c.y), (b.x, a.y), (c.x, b.y)] {
        sum.add_product(-x, y);
    }
    sum.sign()
}

/// A sum of floating-point numbers that do not overlap, smallest first.
struct Expansion {
    parts: [f64; 12],
    len: usize,
}

impl Expansion {
    fn add_product(&mut self, x: f64, y: f64) {
        let high = x * y;
        let (xh, xl) = split(x);
        let (yh, yl) = split(y);
        let low = ((xh * yh - high) + xh * yl + xl * yh) + xl * yl;
        self.add(low);
        self.add(high);
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

/// The upper and the lower half of the digits.
fn split(x: f64) -> (f64, f64) {
    let c = 134_217_729.0 * x; // 2^27 + 1
    let high = c - (c - x);
    (high, x - high)
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
}
