//! The number domain of the checks: which values a number may have.
//!
//! Runs compute in `f64`, rounding to the nearest, and so do these: rounding never turns two results around, so the ends of
//! an interval bound what a run computes with the same operation, bit for bit. What may be no number, or infinite, is
//! *odd*; nothing is said about comparisons with it.

/// Numbers from `lo` to `hi`, and whether there may be others that are none.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Interval {
    pub(super) lo: f64,
    pub(super) hi: f64,
    /// Whether it may be infinite or no number.
    pub(super) odd: bool,
}

impl Interval {
    /// Anything a float can be.
    pub(super) const ALL: Interval = Interval { lo: f64::NEG_INFINITY, hi: f64::INFINITY, odd: true };
    /// What is always there and never negative, like an extent.
    pub(super) const EXTENT: Interval = Interval { lo: 0.0, hi: f64::INFINITY, odd: false };
    pub(super) const ZERO: Interval = Interval { lo: 0.0, hi: 0.0, odd: false };
    const UNIT: Interval = Interval { lo: -1.0, hi: 1.0, odd: false };

    pub(super) fn point(value: f64) -> Interval {
        if value.is_finite() { Interval { lo: value, hi: value, odd: false } } else { Interval::ALL }
    }

    /// From one number to another, in either order.
    pub(super) fn between(a: f64, b: f64) -> Interval {
        if a.is_nan() || b.is_nan() { Interval::ALL } else { Interval { lo: a.min(b), hi: a.max(b), odd: false } }
    }

    /// The number, if there is only one.
    pub(super) fn known(self) -> Option<f64> {
        (self.lo == self.hi && !self.odd).then_some(self.lo)
    }

    /// What is in one of two.
    pub(super) fn or(self, other: Interval) -> Interval {
        Interval { lo: self.lo.min(other.lo), hi: self.hi.max(other.hi), odd: self.odd || other.odd }
    }

    /// Ends that have moved since `before` move on to zero or as far as there is.
    pub(super) fn widen(self, before: Interval) -> Interval {
        let lo = if before.lo <= self.lo {
            self.lo
        } else if 0.0 <= self.lo {
            0.0
        } else {
            f64::NEG_INFINITY
        };
        let hi = if self.hi <= before.hi {
            self.hi
        } else if self.hi <= 0.0 {
            0.0
        } else {
            f64::INFINITY
        };
        Interval { lo, hi, odd: self.odd }
    }

    /// As operations take it: what is no number counts as zero (*CGA changelog 2013.1*).
    pub(super) fn taken(self) -> Interval {
        if self.odd { Interval { odd: false, ..self }.or(Interval::ZERO) } else { self }
    }

    /// The result of an operation of which only the ends are known: where they run out of numbers, so may the result.
    fn result(lo: f64, hi: f64, odd: bool) -> Interval {
        if lo.is_nan() || hi.is_nan() {
            return Interval::ALL;
        }
        Interval { lo, hi, odd: odd || !lo.is_finite() || !hi.is_finite() }
    }

    pub(super) fn neg(self) -> Interval {
        Interval { lo: -self.hi, hi: -self.lo, odd: self.odd }
    }

    pub(super) fn add(self, other: Interval) -> Interval {
        Interval::result(self.lo + other.lo, self.hi + other.hi, self.odd || other.odd)
    }

    pub(super) fn sub(self, other: Interval) -> Interval {
        self.add(other.neg())
    }

    pub(super) fn mul(self, other: Interval) -> Interval {
        // Nothing times whatever there is, is nothing; what is no number is odd already.
        let times = |a: f64, b: f64| if a == 0.0 || b == 0.0 { 0.0 } else { a * b };
        let all =
            [times(self.lo, other.lo), times(self.lo, other.hi), times(self.hi, other.lo), times(self.hi, other.hi)];
        let (lo, hi) = ends(all);
        Interval::result(lo, hi, self.odd || other.odd)
    }

    pub(super) fn div(self, other: Interval) -> Interval {
        if other.lo <= 0.0 && 0.0 <= other.hi {
            return Interval::ALL;
        }
        // An unbounded number by an unbounded one comes near everything of its sign, zero included.
        let by = |a: f64, b: f64| if a == 0.0 || b.is_infinite() { 0.0 } else { a / b };
        let all = [by(self.lo, other.lo), by(self.lo, other.hi), by(self.hi, other.lo), by(self.hi, other.hi)];
        let (lo, hi) = ends(all);
        Interval::result(lo, hi, self.odd || other.odd)
    }

    /// The remainder, with the sign of the dividend.
    pub(super) fn rem(self, other: Interval) -> Interval {
        if other.lo <= 0.0 && 0.0 <= other.hi || self.odd || other.odd {
            return Interval::ALL;
        }
        if let (Some(a), Some(b)) = (self.known(), other.known()) {
            return Interval::point(a % b);
        }
        let most = other.lo.abs().max(other.hi.abs());
        let lo = if self.lo < 0.0 { self.lo.max(-most) } else { 0.0 };
        let hi = if 0.0 < self.hi { self.hi.min(most) } else { 0.0 };
        Interval { lo, hi, odd: false }
    }

    pub(super) fn abs(self) -> Interval {
        if 0.0 <= self.lo {
            self
        } else if self.hi <= 0.0 {
            self.neg()
        } else {
            Interval { lo: 0.0, hi: self.hi.max(-self.lo), odd: self.odd }
        }
    }

    pub(super) fn min(self, other: Interval) -> Interval {
        Interval { lo: self.lo.min(other.lo), hi: self.hi.min(other.hi), odd: false }.unless(self.odd || other.odd)
    }

    pub(super) fn max(self, other: Interval) -> Interval {
        Interval { lo: self.lo.max(other.lo), hi: self.hi.max(other.hi), odd: false }.unless(self.odd || other.odd)
    }

    /// What a function of the language makes of its arguments, as far as it is known.
    pub(super) fn function(name: &str, args: &[Interval]) -> Interval {
        let rising = |of: fn(f64) -> f64, arg: Interval| Interval::result(of(arg.lo), of(arg.hi), arg.odd);
        match (name, args) {
            ("floor", [a]) => rising(f64::floor, *a),
            ("ceil", [a]) => rising(f64::ceil, *a),
            ("rint", [a]) => rising(f64::round_ties_even, *a),
            ("sqrt", [a]) if 0.0 <= a.lo => rising(f64::sqrt, *a),
            ("abs", [a]) => a.abs(),
            ("min", [a, b]) => a.min(*b),
            ("max", [a, b]) => a.max(*b),
            ("sin" | "cos", [a]) if !a.odd => Interval::UNIT,
            ("float", [a]) => *a,
            ("rand", []) => Interval::between(0.0, 1.0),
            ("rand", [max]) if !max.odd => max.or(Interval::ZERO),
            ("rand", [min, max]) if !min.odd && !max.odd => min.or(*max).about(),
            _ => Interval::ALL,
        }
    }

    /// With room for what is computed in several steps and off by last bits.
    fn about(self) -> Interval {
        let room = (self.lo.abs() + self.hi.abs()) * 1e-15;
        Interval::result(self.lo - room, self.hi + room, self.odd)
    }

    /// Itself, or anything.
    fn unless(self, odd: bool) -> Interval {
        if odd { Interval::ALL } else { self }
    }

    /// Whether it is less than the other: `None` when that depends.
    pub(super) fn less(self, other: Interval) -> Option<bool> {
        match () {
            () if self.odd || other.odd => None,
            () if self.hi < other.lo => Some(true),
            () if other.hi <= self.lo => Some(false),
            () => None,
        }
    }

    /// Whether both are the same number.
    pub(super) fn same(self, other: Interval) -> Option<bool> {
        match (self.known(), other.known()) {
            (Some(a), Some(b)) => Some(a == b),
            _ if self.odd || other.odd => None,
            _ => (self.hi < other.lo || other.hi < self.lo).then_some(false),
        }
    }
}

fn ends(all: [f64; 4]) -> (f64, f64) {
    let lo = all.into_iter().fold(f64::INFINITY, f64::min);
    (lo, all.into_iter().fold(f64::NEG_INFINITY, f64::max))
}

#[cfg(test)]
mod tests {
    use super::*;

    const SOME: &[f64] = &[-1e300, -7.5, -1.0, -0.1, 0.0, 0.1, 0.3, 1.0, 2.0, 3.2, 60.0, 1e300];

    fn intervals() -> impl Iterator<Item = Interval> {
        SOME.iter().flat_map(|a| SOME.iter().map(|b| Interval::between(*a, *b)))
    }

    /// Numbers of an interval: its ends and what of the list is between.
    fn members(of: Interval) -> impl Iterator<Item = f64> {
        SOME.iter().copied().filter(move |value| of.lo <= *value && *value <= of.hi)
    }

    fn has(interval: Interval, value: f64) -> bool {
        if value.is_finite() { interval.lo <= value && value <= interval.hi } else { interval.odd }
    }

    #[test]
    fn whatever_a_run_computes_is_in_the_interval() {
        type Op = (fn(Interval, Interval) -> Interval, fn(f64, f64) -> f64);
        let ops: [Op; 7] = [
            (Interval::add, |a, b| a + b),
            (Interval::sub, |a, b| a - b),
            (Interval::mul, |a, b| a * b),
            (Interval::div, |a, b| a / b),
            (Interval::rem, |a, b| a % b),
            (Interval::min, f64::min),
            (Interval::max, f64::max),
        ];
        for (number, (rough, exact)) in ops.into_iter().enumerate() {
            for (a, b) in intervals().flat_map(|a| intervals().map(move |b| (a, b))) {
                let result = rough(a, b);
                for (x, y) in members(a).flat_map(|x| members(b).map(move |y| (x, y))) {
                    assert!(has(result, exact(x, y)), "{number}: {x} and {y} in {a:?} and {b:?} give {result:?}");
                }
            }
        }
    }

    #[test]
    fn functions_and_comparisons_hold_for_every_number() {
        for a in intervals() {
            for x in members(a) {
                for (name, exact) in [("floor", x.floor()), ("ceil", x.ceil()), ("abs", x.abs())] {
                    assert!(has(Interval::function(name, &[a]), exact), "{name} of {x} in {a:?}");
                }
            }
            for b in intervals() {
                for (x, y) in members(a).flat_map(|x| members(b).map(move |y| (x, y))) {
                    assert!(a.less(b).is_none_or(|less| less == (x < y)), "{x} < {y}");
                    assert!(a.same(b).is_none_or(|same| same == (x == y)), "{x} == {y}");
                    let joined = a.or(b);
                    assert!(has(joined, x) && has(joined, y) && has(joined.widen(a), y));
                }
            }
        }
    }

    #[test]
    fn what_may_be_no_number_is_compared_with_nothing_and_taken_as_zero() {
        let odd = Interval::point(1.0).div(Interval::ZERO);
        assert_eq!(odd, Interval::ALL);
        assert_eq!(odd.less(Interval::ZERO), None);
        let large = Interval::point(f64::MAX).add(Interval::point(f64::MAX));
        assert!(large.odd && large.taken().lo == 0.0);
    }

    #[test]
    fn widening_comes_to_an_end() {
        let mut last = Interval::point(5.0);
        let mut steps = 0;
        loop {
            let next = last.or(last.sub(Interval::point(1.0))).widen(last);
            if next == last {
                break;
            }
            (last, steps) = (next, steps + 1);
        }
        assert!(steps <= 3 && last.hi == 5.0 && last.lo == f64::NEG_INFINITY);
    }
}
