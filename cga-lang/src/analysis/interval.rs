//! The abstract domain of numbers: intervals, with a flag for NaN.
//!
//! Intervals compute in `f64` and round to the nearest, as runs do. Rounding is monotone, so the ends of an interval bound the
//! result of a run bit for bit. Finite numbers without a bound end at `f64::MAX`: an infinite end is a possible value.
//! Comparisons follow the language: with NaN on one side, `<` and `<=` are true, and `>`, `>=` and `==` are false.

use crate::ops::Meaning;
use crate::syntax::ast::Binary;

/// Numbers from `lo` to `hi`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Interval {
    pub(crate) lo: f64,
    pub(crate) hi: f64,
    /// True if the value may be NaN.
    nan: bool,
}

impl Interval {
    /// Any float.
    pub(crate) const ALL: Interval = Interval { lo: f64::NEG_INFINITY, hi: f64::INFINITY, nan: true };
    /// Any finite number.
    pub(crate) const FINITE: Interval = Interval::finite(f64::MIN, f64::MAX);
    /// A finite number of 0 or more, like an extent.
    pub(crate) const EXTENT: Interval = Interval::finite(0.0, f64::MAX);
    pub(crate) const ZERO: Interval = Interval::finite(0.0, 0.0);

    /// The finite numbers between two ends.
    pub(crate) const fn finite(lo: f64, hi: f64) -> Interval {
        Interval { lo: lo.clamp(f64::MIN, f64::MAX), hi: hi.clamp(f64::MIN, f64::MAX), nan: false }
    }

    pub(crate) fn point(value: f64) -> Interval {
        if value.is_nan() { Interval::ALL } else { Interval { lo: value, hi: value, nan: false } }
    }

    /// The closed interval between two numbers, in either order.
    pub(crate) fn between(a: f64, b: f64) -> Interval {
        Interval::point(a).or(Interval::point(b))
    }

    /// The only number, if the interval has one.
    pub(crate) fn known(self) -> Option<f64> {
        (self.lo == self.hi && !self.is_odd()).then_some(self.lo)
    }

    /// Returns true if the value may be infinite or NaN.
    pub(crate) fn is_odd(self) -> bool {
        self != self.tame()
    }

    /// The finite part.
    pub(crate) fn tame(self) -> Interval {
        Interval::finite(self.lo, self.hi)
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
        Interval { lo: self.lo.min(other.lo), hi: self.hi.max(other.hi), nan: self.nan || other.nan }
    }

    /// Widens: ends that have moved since `before` jump to zero, to the largest number or to infinity.
    pub(crate) fn widen(self, before: Interval) -> Interval {
        let widened = |hi: f64, before: f64| match () {
            () if hi <= before => hi,
            () if hi <= 0.0 => 0.0,
            () => hi.max(f64::MAX),
        };
        Interval { lo: -widened(-self.lo, -before.lo), hi: widened(self.hi, before.hi), ..self }
    }

    /// The value that operations take: zero for infinity and NaN (*CGA changelog 2013.1*).
    pub(crate) fn taken(self) -> Interval {
        if self.is_odd() { self.tame().or(Interval::ZERO) } else { self }
    }

    /// The results of an operation that is monotone in each operand: they end at two of its corners. Corners that are NaN are left
    /// out, because numbers near them give results between the other corners.
    fn corners(self, other: Interval, of: impl Fn(f64, f64) -> f64) -> Interval {
        let all = [of(self.lo, other.lo), of(self.lo, other.hi), of(self.hi, other.lo), of(self.hi, other.hi)];
        let end = |better: fn(f64, f64) -> f64| all.into_iter().fold(f64::NAN, better);
        let (lo, hi, nan) = (end(f64::min), end(f64::max), all.into_iter().any(f64::is_nan));
        if lo.is_nan() { Interval::ALL } else { Interval { lo, hi, nan: nan || self.nan || other.nan } }
    }

    pub(crate) fn neg(self) -> Interval {
        Interval { lo: -self.hi, hi: -self.lo, ..self }
    }

    pub(crate) fn add(self, other: Interval) -> Interval {
        self.corners(other, |a, b| a + b)
    }

    pub(crate) fn sub(self, other: Interval) -> Interval {
        self.add(other.neg())
    }

    fn has_zero(self) -> bool {
        self.lo <= 0.0 && 0.0 <= self.hi
    }

    fn has_infinity(self) -> bool {
        self.lo.is_infinite() || self.hi.is_infinite()
    }

    pub(crate) fn mul(self, other: Interval) -> Interval {
        // Zero times any finite number is zero; zero times infinity is NaN.
        let product = self.corners(other, |a, b| if a == 0.0 || b == 0.0 { 0.0 } else { a * b });
        let nan = self.has_infinity() && other.has_zero() || other.has_infinity() && self.has_zero();
        Interval { nan: product.nan || nan, ..product }
    }

    pub(crate) fn div(self, other: Interval) -> Interval {
        // The sign of a zero decides between two infinities.
        if other.has_zero() { Interval::ALL } else { self.corners(other, |a, b| a / b) }
    }

    /// The remainder, with the sign of the dividend.
    pub(crate) fn rem(self, other: Interval) -> Interval {
        if let (Some(a), Some(b)) = (self.known(), other.known()) {
            return Interval::point(a % b);
        }
        // It is less than the divisor and at most the dividend, signs aside.
        let most = other.abs().hi.next_down().max(0.0);
        let (lo, hi) = (self.lo.clamp(-most, 0.0), self.hi.clamp(0.0, most));
        Interval { lo, hi, nan: self.is_odd() || other.nan || other.has_zero() }
    }

    pub(crate) fn abs(self) -> Interval {
        Interval { lo: self.lo.max(-self.hi).max(0.0), hi: self.hi.max(-self.lo), ..self }
    }

    pub(crate) fn min(self, other: Interval) -> Interval {
        self.of_both(other, Interval { lo: self.lo.min(other.lo), hi: self.hi.min(other.hi), nan: false })
    }

    pub(crate) fn max(self, other: Interval) -> Interval {
        self.of_both(other, Interval { lo: self.lo.max(other.lo), hi: self.hi.max(other.hi), nan: false })
    }

    /// The chosen one of two numbers. If one is NaN, the other one is chosen.
    fn of_both(self, other: Interval, chosen: Interval) -> Interval {
        let chosen = if self.nan { chosen.or(other) } else { chosen };
        if other.nan { chosen.or(self) } else { chosen }
    }

    /// The result of a function of the language, where its transfer function is known.
    pub(crate) fn function(meaning: Meaning, args: &[Interval]) -> Interval {
        // Runs take infinity and NaN as zero.
        let rising = |of: fn(f64) -> f64, arg: &Interval| {
            let arg = arg.taken();
            Interval { lo: of(arg.lo), hi: of(arg.hi), ..arg }
        };
        match (meaning, args) {
            (Meaning::Floor, [a]) => rising(f64::floor, a),
            (Meaning::Ceil, [a]) => rising(f64::ceil, a),
            (Meaning::Round, [a]) => rising(f64::round_ties_even, a),
            (Meaning::Sqrt, [a]) => Interval { nan: a.taken().lo < 0.0, ..rising(|a| a.max(0.0).sqrt(), a) },
            (Meaning::Abs, [a]) => a.taken().abs(),
            (Meaning::Min, [a, b]) => a.min(*b),
            (Meaning::Max, [a, b]) => a.max(*b),
            (Meaning::Wave, [_]) => Interval::finite(-1.0, 1.0),
            // Rounding leads beyond neither end, because runs multiply the difference by at most 1 - 2^-53.
            (Meaning::Random, []) => Interval::finite(0.0, 1.0),
            (Meaning::Random, [max]) => max.taken().or(Interval::ZERO),
            (Meaning::Random, [min, max]) => min.taken().or(max.taken()),
            _ => Interval::ALL,
        }
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

    /// The part that satisfies a comparison with some number of another interval. Ends stay included, for strict comparisons too.
    pub(crate) fn compared(mut self, op: Binary, with: Interval) -> Option<Interval> {
        match op {
            Binary::Lt | Binary::Le => self.hi = self.hi.min(with.hi),
            Binary::Gt | Binary::Ge => self.lo = self.lo.max(with.lo),
            _ => (self.lo, self.hi) = (self.lo.max(with.lo), self.hi.min(with.hi)),
        }
        (self.lo <= self.hi).then_some(self)
    }

    /// The result of `==`, if it is certain.
    pub(crate) fn same(self, other: Interval) -> Option<bool> {
        match () {
            () if self.hi < other.lo || other.hi < self.lo => Some(false),
            () if self.lo == other.hi && other.lo == self.hi && !self.nan && !other.nan => Some(true),
            () => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fmt::Arguments;

    const SOME: [f64; 10] = [f64::NEG_INFINITY, f64::MIN, -7.5, -1.0, 0.0, 5e-324, 1.0, 3.2, f64::MAX, f64::INFINITY];

    /// The intervals between any two numbers of the list, without NaN and with it.
    fn intervals() -> impl Iterator<Item = Interval> {
        let between = SOME.iter().flat_map(|lo| SOME.iter().map(|hi| Interval { lo: *lo, hi: *hi, nan: false }));
        let between = between.filter(|interval| interval.lo <= interval.hi);
        between.flat_map(|interval| [interval, Interval { nan: true, ..interval }])
    }

    fn pairs() -> impl Iterator<Item = (Interval, Interval)> {
        intervals().flat_map(|a| intervals().map(move |b| (a, b)))
    }

    /// The numbers of the list in an interval, and NaN.
    fn members(of: Interval) -> impl Iterator<Item = f64> + Clone {
        SOME.into_iter().chain([f64::NAN]).filter(move |value| has(of, *value))
    }

    fn has(interval: Interval, value: f64) -> bool {
        if value.is_nan() { interval.nan } else { interval.lo <= value && value <= interval.hi }
    }

    fn has_finite(interval: Interval) -> bool {
        interval.lo < f64::INFINITY && f64::NEG_INFINITY < interval.hi
    }

    /// The smallest interval of values, if they are not all NaN.
    fn hull(values: impl Iterator<Item = f64>) -> Option<Interval> {
        let (odd, numbers): (Vec<f64>, Vec<f64>) = values.partition(|value| value.is_nan());
        let all = numbers.into_iter().map(Interval::point).reduce(Interval::or)?;
        Some(Interval { nan: !odd.is_empty(), ..all })
    }

    /// Asserts that a result contains values, and nothing around them.
    fn assert_smallest(result: Interval, values: impl Iterator<Item = f64> + Clone, what: Arguments) {
        assert!(values.clone().all(|value| has(result, value)), "{what} is not in {result:?}");
        assert!(hull(values).is_none_or(|hull| hull == result), "{what} is less than {result:?}");
    }

    type Operation = (&'static str, fn(Interval, Interval) -> Interval, fn(f64, f64) -> f64);

    const OPERATIONS: [Operation; 7] = [
        ("+", Interval::add, |a, b| a + b),
        ("-", Interval::sub, |a, b| a - b),
        ("*", Interval::mul, |a, b| a * b),
        ("min", Interval::min, f64::min),
        ("max", Interval::max, f64::max),
        ("/", Interval::div, |a, b| a / b),
        ("%", Interval::rem, |a, b| a % b),
    ];

    #[test]
    fn operations_give_the_smallest_interval_of_all_results() {
        for (a, b) in pairs() {
            for (name, rough, exact) in OPERATIONS {
                let result = rough(a, b);
                let values = members(a).flat_map(|x| members(b).map(move |y| exact(x, y)));
                let is_exact = match name {
                    "%" => false,
                    "/" if b.has_zero() => false,
                    _ => has_finite(a) && has_finite(b),
                };
                if is_exact {
                    assert_smallest(result, values, format_args!("{a:?} {name} {b:?}"));
                } else {
                    values.for_each(|value| assert!(has(result, value), "{a:?} {name} {b:?}: {result:?}"));
                }
            }
            assert_smallest(a.or(b), members(a).chain(members(b)), format_args!("the join"));
        }
    }

    #[test]
    fn functions_give_the_smallest_interval_of_all_results() {
        for a in intervals().filter(|a| has_finite(*a)) {
            let taken = members(a).map(|x| if x.is_finite() { x } else { 0.0 });
            assert_smallest(a.taken(), taken.clone(), format_args!("the value that operations take"));
            assert_smallest(a.tame(), members(a).filter(|x| x.is_finite()), format_args!("the finite part"));
            assert_smallest(a.ordered(), members(a).filter(|x| !x.is_nan()), format_args!("the part without NaN"));
            assert_eq!(a.is_odd(), members(a).any(|x| !x.is_finite()), "{a:?}");
            assert_eq!(a.may_be_nan(), members(a).any(f64::is_nan), "{a:?}");
            type Exact = fn(f64) -> f64;
            let functions: [(Meaning, Exact); 5] = [
                (Meaning::Floor, f64::floor),
                (Meaning::Ceil, f64::ceil),
                (Meaning::Round, f64::round_ties_even),
                (Meaning::Sqrt, f64::sqrt),
                (Meaning::Abs, f64::abs),
            ];
            for (meaning, exact) in functions {
                let result = Interval::function(meaning, &[a]);
                assert_smallest(result, taken.clone().map(exact), format_args!("{meaning:?} of {a:?}"));
            }
            // A random number is a share of its argument.
            let random = taken.clone().chain([0.0]);
            assert_smallest(Interval::function(Meaning::Random, &[a]), random, format_args!("a random number"));
            assert_eq!(Interval::function(Meaning::Wave, &[a]), Interval::finite(-1.0, 1.0));
            assert_eq!(Interval::function(Meaning::Opaque, &[a]), Interval::ALL);
        }
        assert_eq!(Interval::function(Meaning::Random, &[]), Interval::finite(0.0, 1.0));
        let (low, high) = (Interval::finite(1.0, 4.0), Interval::finite(2.0, 3.0));
        assert_eq!(Interval::function(Meaning::Min, &[low, high]), Interval::finite(1.0, 3.0));
        assert_eq!(Interval::function(Meaning::Max, &[low, high]), Interval::finite(2.0, 4.0));
    }

    #[test]
    fn comparisons_are_certain_if_all_numbers_agree() {
        for (a, b) in pairs() {
            let certain = |holds: fn(f64, f64) -> bool| {
                let mut all = members(a).flat_map(|x| members(b).map(move |y| holds(x, y)));
                let first = all.next()?;
                all.all(|other| other == first).then_some(first)
            };
            // NaN is less than everything.
            assert_eq!(a.less(b), certain(|x, y| x < y || x.is_nan() || y.is_nan()), "{a:?} < {b:?}");
            assert_eq!(a.at_most(b), certain(|x, y| x <= y || x.is_nan() || y.is_nan()), "{a:?} <= {b:?}");
            assert_eq!(a.same(b), certain(|x, y| x == y), "{a:?} == {b:?}");
        }
    }

    #[test]
    fn a_comparison_leaves_the_numbers_that_satisfy_it() {
        type Holds = fn(f64, f64) -> bool;
        let operators: [(Binary, Holds); 5] = [
            (Binary::Lt, |x, y| x <= y),
            (Binary::Le, |x, y| x <= y),
            (Binary::Gt, |x, y| x >= y),
            (Binary::Ge, |x, y| x >= y),
            (Binary::Eq, |x, y| x == y),
        ];
        for (a, b) in pairs() {
            for (op, holds) in operators {
                let left = members(a).filter(|x| x.is_nan() || members(b).any(|y| holds(*x, y)));
                assert_eq!(a.compared(op, b), hull(left), "{a:?} {op:?} {b:?}");
            }
        }
    }

    #[test]
    fn a_number_is_known_if_it_is_finite_and_the_only_one() {
        for a in intervals() {
            let list: Vec<f64> = members(a).collect();
            assert_eq!(a.known(), list.first().copied().filter(|x| list.len() == 1 && x.is_finite()), "{a:?}");
        }
        for value in SOME {
            assert_eq!(Interval::point(value), Interval { lo: value, hi: value, nan: false });
            assert_eq!(Interval::between(value, 1.0), Interval::point(value).or(Interval::point(1.0)));
        }
        assert_eq!((Interval::point(f64::NAN), Interval::between(2.0, f64::NAN)), (Interval::ALL, Interval::ALL));
        assert_eq!(Interval::finite(2.0, f64::INFINITY), Interval { lo: 2.0, ..Interval::FINITE });
        assert_eq!(Interval::EXTENT, Interval { lo: 0.0, ..Interval::FINITE });
        assert!(!Interval::FINITE.is_odd() && !Interval::EXTENT.is_odd());
    }

    #[test]
    fn remainders_are_nearer_to_zero_than_the_divisor_and_not_farther_than_the_dividend() {
        let below = |number: f64| number.next_down();
        let rem = |a: (f64, f64), b: (f64, f64)| Interval::finite(a.0, a.1).rem(Interval::finite(b.0, b.1));
        assert_eq!(rem((0.0, 9.0), (2.0, 3.0)), Interval::finite(0.0, below(3.0)));
        assert_eq!(rem((-9.0, 1.0), (-3.0, -2.0)), Interval::finite(-below(3.0), 1.0));
        assert_eq!(rem((-9.0, -4.0), (3.0, 3.0)), Interval::finite(-below(3.0), 0.0));
        assert_eq!(rem((2.0, 4.0), (5.0, 6.0)), Interval::finite(0.0, 4.0));
        assert_eq!(rem((7.0, 7.0), (4.0, 4.0)), Interval::point(3.0));
        assert_eq!(rem((7.0, 7.0), (4.0, 5.0)), Interval::finite(0.0, below(5.0)));
        assert_eq!(rem((7.0, 8.0), (4.0, 4.0)), Interval::finite(0.0, below(4.0)));
        // The remainder of a division by zero is NaN, and so is the remainder of infinity.
        assert_eq!(rem((1.0, 9.0), (0.0, 3.0)), Interval { nan: true, ..Interval::finite(0.0, below(3.0)) });
        let infinite = Interval::between(1.0, f64::INFINITY);
        assert_eq!(infinite.rem(Interval::point(3.0)), Interval { nan: true, ..Interval::finite(0.0, below(3.0)) });
        assert_eq!(Interval::finite(1.0, 2.0).rem(infinite), Interval::finite(0.0, 2.0));
    }

    /// The largest random number of runs.
    const LARGEST_SHARE: f64 = 1.0f64.next_down();

    /// A sequence of random numbers from 0 to 1.
    fn shares() -> impl Iterator<Item = f64> {
        let step = |x: &u64| Some(x.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407));
        std::iter::successors(Some(1), step).map(|x| (x >> 11) as f64 / (1u64 << 53) as f64)
    }

    #[test]
    fn rounded_results_of_numbers_inside_are_in_the_interval() {
        let mut shares = shares();
        let mut share = || shares.next().expect("without end");
        for _ in 0..2000 {
            let scale = [1e-3, 1.0, 1e12][(share() * 3.0) as usize];
            let mut some = || {
                let of = Interval::between((share() - 0.5) * scale, (share() - 0.5) * 10.0);
                (of, [of.lo, of.hi, (of.lo + (of.hi - of.lo) * share()).clamp(of.lo, of.hi)])
            };
            let ((a, left), (b, right)) = (some(), some());
            for (name, rough, exact) in OPERATIONS {
                for (x, y) in left.into_iter().flat_map(|x| right.map(|y| (x, y))) {
                    assert!(has(rough(a, b), exact(x, y)), "{x} {name} {y} in {a:?} and {b:?}");
                }
            }
        }
    }

    #[test]
    fn random_numbers_are_between_the_arguments_in_spite_of_rounding() {
        let mut shares = shares();
        let mut share = || shares.next().expect("without end");
        for _ in 0..5000 {
            let scale = [1e-300, 1.0, 1e12, 1e300][(share() * 4.0) as usize];
            let (min, max) = ((share() - 0.5) * scale, (share() - 0.5) * 10.0);
            let all = Interval::function(Meaning::Random, &[Interval::point(min), Interval::point(max)]);
            assert_eq!(all, Interval::between(min, max));
            for draw in [0.0, share(), LARGEST_SHARE] {
                // The computation of runs.
                let number = min + (max - min) * draw;
                assert!(has(all, number), "{number} in {all:?}");
            }
        }
        // Runs take NaN as zero.
        let unknown = Interval { nan: true, ..Interval::finite(2.0, 3.0) };
        let all = Interval::function(Meaning::Random, &[unknown, Interval::finite(1.0, 4.0)]);
        assert_eq!(all, Interval::finite(0.0, 4.0));
        assert_eq!(all, Interval::function(Meaning::Random, &[Interval::finite(1.0, 4.0), unknown]));
    }

    #[test]
    fn ends_that_moved_are_widened_to_zero_then_to_the_largest_number_then_to_infinity() {
        let widen = |before: (f64, f64), now: (f64, f64)| {
            let widened = Interval::between(now.0, now.1).widen(Interval::between(before.0, before.1));
            (widened.lo, widened.hi)
        };
        assert_eq!(widen((-2.0, 4.0), (-2.0, 4.0)), (-2.0, 4.0));
        assert_eq!(widen((-2.0, 4.0), (-1.0, 3.0)), (-1.0, 3.0));
        assert_eq!(widen((2.0, 4.0), (1.0, 4.0)), (0.0, 4.0));
        assert_eq!(widen((2.0, 4.0), (0.0, 4.0)), (0.0, 4.0));
        assert_eq!(widen((2.0, 4.0), (-1.0, 5.0)), (f64::MIN, f64::MAX));
        assert_eq!(widen((-4.0, -2.0), (-4.0, -1.0)), (-4.0, 0.0));
        assert_eq!(widen((-4.0, -2.0), (-4.0, 0.0)), (-4.0, 0.0));
        assert_eq!(widen((-4.0, 4.0), (f64::NEG_INFINITY, f64::INFINITY)), (f64::NEG_INFINITY, f64::INFINITY));
        let unknown = Interval { nan: true, ..Interval::ZERO };
        assert_eq!(unknown.widen(Interval::ZERO), unknown);
    }

    #[test]
    fn widening_comes_to_an_end() {
        let count = |step: fn(Interval) -> Interval, first: Interval| {
            let mut last = first;
            (0..9).find(|_| {
                let next = last.or(step(last)).widen(last);
                next == std::mem::replace(&mut last, next)
            })
        };
        assert_eq!(count(|x| x.sub(Interval::point(1.0)), Interval::point(5.0)), Some(2));
        assert_eq!(count(|x| x.mul(Interval::point(2.0)), Interval::point(-5.0)), Some(2));
        assert_eq!(count(|x| x.mul(Interval::point(-3.0)).add(x), Interval::point(5.0)), Some(3));
    }
}
