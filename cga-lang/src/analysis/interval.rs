//! The abstract domain of numbers: intervals, with flags for infinity and NaN.
//!
//! Intervals compute in `f64` and round to the nearest, as runs do. Rounding is monotone, so the ends of an interval bound the
//! result of a run bit for bit. Two flags tell whether the value may be infinite or NaN. Comparisons follow the language: with NaN
//! on one side, `<` and `<=` are true, and `>`, `>=` and `==` are false.

use crate::ops::Meaning;
use crate::syntax::ast::Binary;

/// Numbers from `lo` to `hi`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Interval {
    pub(crate) lo: f64,
    pub(crate) hi: f64,
    /// True if the value may be infinite. Otherwise an infinite end means that finite values are unbounded.
    infinite: bool,
    /// True if the value may be NaN.
    nan: bool,
}

impl Interval {
    /// Any float.
    pub(crate) const ALL: Interval = Interval { lo: f64::NEG_INFINITY, hi: f64::INFINITY, infinite: true, nan: true };
    /// Any finite number.
    pub(crate) const FINITE: Interval =
        Interval { lo: f64::NEG_INFINITY, hi: f64::INFINITY, infinite: false, nan: false };
    /// A finite number of 0 or more, like an extent.
    pub(crate) const EXTENT: Interval = Interval { lo: 0.0, ..Interval::FINITE };
    pub(crate) const ZERO: Interval = Interval::finite(0.0, 0.0);
    const UNIT: Interval = Interval::finite(-1.0, 1.0);

    /// Finite numbers between two ends; an infinite end means unbounded.
    pub(crate) const fn finite(lo: f64, hi: f64) -> Interval {
        Interval { lo, hi, infinite: false, nan: false }
    }

    pub(crate) fn point(value: f64) -> Interval {
        if value.is_finite() { Interval::finite(value, value) } else { Interval::ALL }
    }

    /// The closed interval between two numbers, in either order.
    pub(crate) fn between(a: f64, b: f64) -> Interval {
        if a.is_nan() || b.is_nan() { Interval::ALL } else { Interval::result(a.min(b), a.max(b), false) }
    }

    /// The only number, if the interval has one.
    pub(crate) fn known(self) -> Option<f64> {
        (self.lo == self.hi && self.lo.is_finite() && !self.nan).then_some(self.lo)
    }

    /// Returns true if the value may be infinite or NaN.
    pub(crate) fn is_odd(self) -> bool {
        self.infinite || self.nan
    }

    /// The finite part.
    pub(crate) fn tame(self) -> Interval {
        Interval { infinite: false, nan: false, ..self }
    }

    /// The part without NaN.
    pub(crate) fn ordered(self) -> Interval {
        Interval { nan: false, ..self }
    }

    /// Returns true if the value may be NaN.
    pub(crate) fn may_be_nan(self) -> bool {
        self.nan
    }

    /// The join of two intervals.
    pub(crate) fn or(self, other: Interval) -> Interval {
        Interval {
            lo: self.lo.min(other.lo),
            hi: self.hi.max(other.hi),
            infinite: self.infinite || other.infinite,
            nan: self.nan || other.nan,
        }
    }

    /// Widens: ends that have moved since `before` jump to zero or to infinity.
    pub(crate) fn widen(self, before: Interval) -> Interval {
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
        Interval { lo, hi, ..self }
    }

    /// The value that operations take: zero for infinity and NaN (*CGA changelog 2013.1*).
    pub(crate) fn taken(self) -> Interval {
        if self.is_odd() { self.tame().or(Interval::ZERO) } else { self }
    }

    /// The result of an operation, from its ends: if an end overflows, the result may be infinite.
    fn result(lo: f64, hi: f64, nan: bool) -> Interval {
        if lo.is_nan() || hi.is_nan() {
            return Interval::ALL;
        }
        Interval { lo, hi, infinite: !lo.is_finite() || !hi.is_finite(), nan }
    }

    pub(crate) fn neg(self) -> Interval {
        Interval { lo: -self.hi, hi: -self.lo, ..self }
    }

    pub(crate) fn add(self, other: Interval) -> Interval {
        let (up, down) =
            (|of: Interval| of.infinite && of.hi.is_infinite(), |of: Interval| of.infinite && of.lo.is_infinite());
        let cancel = up(self) && down(other) || down(self) && up(other);
        Interval::result(self.lo + other.lo, self.hi + other.hi, cancel || self.nan || other.nan)
    }

    pub(crate) fn sub(self, other: Interval) -> Interval {
        self.add(other.neg())
    }

    fn has_zero(self) -> bool {
        self.lo <= 0.0 && 0.0 <= self.hi
    }

    pub(crate) fn mul(self, other: Interval) -> Interval {
        // Zero times any finite number is zero.
        let times = |a: f64, b: f64| if a == 0.0 || b == 0.0 { 0.0 } else { a * b };
        let all =
            [times(self.lo, other.lo), times(self.lo, other.hi), times(self.hi, other.lo), times(self.hi, other.hi)];
        let (lo, hi) = ends(all);
        let none = self.infinite && other.has_zero() || other.infinite && self.has_zero();
        Interval::result(lo, hi, none || self.nan || other.nan)
    }

    pub(crate) fn div(self, other: Interval) -> Interval {
        if other.has_zero() {
            return Interval::ALL;
        }
        // The quotient of two unbounded numbers may be any number of its sign, zero included.
        let by = |a: f64, b: f64| if a == 0.0 || b.is_infinite() { 0.0 } else { a / b };
        let all = [by(self.lo, other.lo), by(self.lo, other.hi), by(self.hi, other.lo), by(self.hi, other.hi)];
        let (lo, hi) = ends(all);
        Interval::result(lo, hi, self.infinite && other.infinite || self.nan || other.nan)
    }

    /// The remainder, with the sign of the dividend.
    pub(crate) fn rem(self, other: Interval) -> Interval {
        if other.has_zero() {
            return Interval::ALL;
        }
        if let (Some(a), Some(b)) = (self.known(), other.known()) {
            return Interval::point(a % b);
        }
        let most = other.lo.abs().max(other.hi.abs());
        let lo = if self.lo < 0.0 { self.lo.max(-most) } else { 0.0 };
        let hi = if 0.0 < self.hi { self.hi.min(most) } else { 0.0 };
        Interval { nan: self.is_odd() || other.nan, ..Interval::finite(lo, hi) }
    }

    pub(crate) fn abs(self) -> Interval {
        if 0.0 <= self.lo {
            self
        } else if self.hi <= 0.0 {
            self.neg()
        } else {
            Interval { lo: 0.0, hi: self.hi.max(-self.lo), ..self }
        }
    }

    pub(crate) fn min(self, other: Interval) -> Interval {
        self.of_both(other, self.lo.min(other.lo), self.hi.min(other.hi))
    }

    pub(crate) fn max(self, other: Interval) -> Interval {
        self.of_both(other, self.lo.max(other.lo), self.hi.max(other.hi))
    }

    /// One of two numbers.
    fn of_both(self, other: Interval, lo: f64, hi: f64) -> Interval {
        if self.nan || other.nan {
            return Interval::ALL;
        }
        let infinite = (self.infinite || other.infinite) && (lo.is_infinite() || hi.is_infinite());
        Interval { lo, hi, infinite, nan: false }
    }

    /// The result of a function of the language, where its transfer function is known.
    pub(crate) fn function(meaning: Meaning, args: &[Interval]) -> Interval {
        // Runs take infinity and NaN as zero.
        let rising = |of: fn(f64) -> f64, arg: Interval| {
            let arg = arg.taken();
            Interval { lo: of(arg.lo), hi: of(arg.hi), ..arg }
        };
        match (meaning, args) {
            (Meaning::Floor, [a]) => rising(f64::floor, *a),
            (Meaning::Ceil, [a]) => rising(f64::ceil, *a),
            (Meaning::Round, [a]) => rising(f64::round_ties_even, *a),
            (Meaning::Sqrt, [a]) if 0.0 <= a.lo => rising(f64::sqrt, *a),
            (Meaning::Abs, [a]) => a.taken().abs(),
            (Meaning::Min, [a, b]) => a.min(*b),
            (Meaning::Max, [a, b]) => a.max(*b),
            (Meaning::Wave, [a]) => Interval { nan: a.is_odd(), ..Interval::UNIT },
            (Meaning::Random, []) => Interval::between(0.0, 1.0),
            (Meaning::Random, [max]) if !max.is_odd() => max.or(Interval::ZERO),
            (Meaning::Random, [min, max]) if !min.is_odd() && !max.is_odd() => min.or(*max).about(),
            _ => Interval::ALL,
        }
    }

    /// Widens the ends by the rounding of a computation in several steps.
    fn about(self) -> Interval {
        let room = (self.lo.abs() + self.hi.abs()) * 1e-15;
        Interval::result(self.lo - room, self.hi + room, self.nan)
    }

    /// The result of `<`, if it is certain. `>=` has the opposite result.
    pub(crate) fn less(self, other: Interval) -> Option<bool> {
        match () {
            () if self.hi < other.lo => Some(true),
            () if other.hi <= self.lo && !self.nan && !other.nan => Some(false),
            () => None,
        }
    }

    /// The result of `<=`, if it is certain. `>` has the opposite result.
    pub(crate) fn at_most(self, other: Interval) -> Option<bool> {
        match () {
            () if self.hi <= other.lo => Some(true),
            () if other.hi < self.lo && !self.nan && !other.nan => Some(false),
            () => None,
        }
    }

    /// The part that compares so with some number of another interval. Ends stay included, for strict comparisons too.
    pub(crate) fn compared(mut self, op: Binary, with: Interval) -> Option<Interval> {
        match op {
            Binary::Lt | Binary::Le => self.hi = self.hi.min(with.hi),
            Binary::Gt | Binary::Ge => self.lo = self.lo.max(with.lo),
            _ => (self.lo, self.hi) = (self.lo.max(with.lo), self.hi.min(with.hi)),
        }
        self.infinite &= self.lo.is_infinite() || self.hi.is_infinite();
        (self.lo <= self.hi).then_some(self)
    }

    /// The result of `==`, if it is certain.
    pub(crate) fn same(self, other: Interval) -> Option<bool> {
        match (self.known(), other.known()) {
            (Some(a), Some(b)) => Some(a == b),
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

    /// Intervals between any two numbers of the list: closed, unbounded, with infinity and with NaN.
    fn intervals() -> impl Iterator<Item = Interval> {
        let between = SOME.iter().flat_map(|a| SOME.iter().map(|b| Interval::between(*a, *b)));
        let open = SOME.iter().flat_map(|a| {
            let (up, down) = (Interval { lo: *a, ..Interval::FINITE }, Interval { hi: *a, ..Interval::FINITE });
            [up, down, Interval { infinite: true, ..up }, Interval { infinite: true, nan: true, ..down }]
        });
        between.chain(open).chain([Interval::FINITE, Interval::ALL, Interval { nan: true, ..Interval::UNIT }])
    }

    /// Some numbers of an interval.
    fn members(of: Interval) -> impl Iterator<Item = f64> {
        let odd = [f64::INFINITY, f64::NEG_INFINITY, f64::NAN, f64::MAX, f64::MIN];
        SOME.iter().copied().chain(odd).filter(move |value| has(of, *value))
    }

    fn has(interval: Interval, value: f64) -> bool {
        match value {
            value if value.is_nan() => interval.nan,
            value if value.is_infinite() => interval.infinite && (interval.lo == value || interval.hi == value),
            value => interval.lo <= value && value <= interval.hi,
        }
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
                // The value that operations take.
                let x_taken = if x.is_finite() { x } else { 0.0 };
                for (meaning, exact) in [
                    (Meaning::Floor, x_taken.floor()),
                    (Meaning::Ceil, x_taken.ceil()),
                    (Meaning::Round, x_taken.round_ties_even()),
                    (Meaning::Sqrt, x_taken.sqrt()),
                    (Meaning::Abs, x_taken.abs()),
                ] {
                    assert!(has(Interval::function(meaning, &[a]), exact), "{meaning:?} of {x} in {a:?}");
                }
                assert!(a.known().is_none_or(|known| known == x));
                assert!(has(a.taken(), x_taken));
            }
            for b in intervals() {
                let joined = a.or(b);
                let (less, at_most, same) = (a.less(b), a.at_most(b), a.same(b));
                for (x, y) in members(a).flat_map(|x| members(b).map(move |y| (x, y))) {
                    assert!(less.is_none_or(|less| less != (x >= y)), "{x} < {y}");
                    assert!(at_most.is_none_or(|at_most| at_most != (x > y)), "{x} <= {y}");
                    assert!(same.is_none_or(|same| same == (x == y)), "{x} == {y}");
                    assert!(has(joined, x) && has(joined, y) && has(joined.widen(a), y));
                }
            }
        }
    }

    #[test]
    fn what_is_no_number_is_less_than_anything_and_is_taken_as_zero() {
        let odd = Interval::point(1.0).div(Interval::ZERO);
        assert_eq!(odd, Interval::ALL);
        assert_eq!(odd.less(Interval::ZERO), None);
        let large = Interval::point(f64::MAX).add(Interval::point(f64::MAX));
        assert!(large.is_odd() && large.taken().lo == 0.0);
        let beyond = Interval { nan: true, ..Interval::finite(5.0, 7.0) };
        let (two, nine) = (Interval::point(2.0), Interval::point(9.0));
        assert_eq!((beyond.less(two), beyond.same(two), beyond.less(nine)), (None, Some(false), Some(true)));
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
