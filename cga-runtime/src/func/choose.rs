//! `min`, `max`, `clamp`.

use std::cmp::Ordering;

use super::array::{each_pair, same_form};
use crate::run::env::Env;
use crate::value::array::{Array, Element};
use crate::value::compare::Compare;
use crate::value::text::Text;

/// Returns true if `a` is less than `b`. NaN is never less.
fn before<T: Compare>(a: &T, b: &T) -> bool {
    !a.unordered() && !b.unordered() && a.compare(b) == Ordering::Less
}

/// The smaller value. If one of the two is NaN, the other one.
fn smaller<T: Compare>(a: T, b: T) -> T {
    if a.unordered() || before(&b, &a) { b } else { a }
}

/// The larger value. If one of the two is NaN, the other one.
fn larger<T: Compare>(a: T, b: T) -> T {
    if a.unordered() || before(&a, &b) { b } else { a }
}

/// `low` if `x` is less, `high` if `x` is greater, `x` otherwise (*clamp*).
fn within<T: Compare>(x: T, low: T, high: T) -> T {
    if before(&x, &low) {
        low
    } else if before(&high, &x) {
        high
    } else {
        x
    }
}

/// The smaller one (*min*).
pub fn min(a: f64, b: f64) -> f64 {
    smaller(a, b)
}

/// The larger one (*max*).
pub fn max(a: f64, b: f64) -> f64 {
    larger(a, b)
}

/// `low` if `x` is less, `high` if `x` is greater, `x` otherwise (*clamp*).
pub fn clamp(x: f64, low: f64, high: f64) -> f64 {
    within(x, low, high)
}

/// The text that comes first (*min*).
pub fn min_text(a: Text, b: Text) -> Text {
    smaller(a, b)
}

/// The text that comes last (*max*).
pub fn max_text(a: Text, b: Text) -> Text {
    larger(a, b)
}

/// `low` if `x` comes before it, `high` if `x` comes after it, `x` otherwise (*clamp*).
pub fn clamp_text(x: Text, low: Text, high: Text) -> Text {
    within(x, low, high)
}

/// The smaller values, element by element. The pages *min*, *max* and *clamp* say only that the functions take arrays.
/// It is inferred that they compare elements, rather than choose one of the arrays by the order of arrays.
pub fn min_each<T: Element>(env: &mut Env, a: Array<T>, b: Array<T>) -> Array<T> {
    each_pair(env, "min", a, b, smaller)
}

/// The larger values, element by element; see [`min_each`].
pub fn max_each<T: Element>(env: &mut Env, a: Array<T>, b: Array<T>) -> Array<T> {
    each_pair(env, "max", a, b, larger)
}

/// [`clamp`], element by element; see [`min_each`].
pub fn clamp_each<T: Element>(env: &mut Env, x: Array<T>, low: Array<T>, high: Array<T>) -> Array<T> {
    if !(same_form(env, "clamp", &x, &low) && same_form(env, "clamp", &x, &high)) {
        return Array::default();
    }
    let bounds = low.as_slice().iter().zip(high.as_slice());
    let values: Vec<T> =
        x.as_slice().iter().zip(bounds).map(|(x, (low, high))| within(x.clone(), low.clone(), high.clone())).collect();
    Array::new(values, x.rows(), x.columns())
}

#[cfg(test)]
mod tests {
    use super::super::tests::{env, faults};
    use super::*;

    #[test]
    fn the_smaller_and_the_larger() {
        // *min*, *max*, *clamp*.
        assert_eq!((min(10.0, -10.0), max(10.0, -10.0)), (-10.0, 10.0));
        assert_eq!((clamp(1.5, 0.0, 1.0), clamp(-11.0, -10.0, 10.0), clamp(0.5, 0.0, 1.0)), (1.0, -10.0, 0.5));
        assert_eq!(clamp(0.0, 3.0, 1.0), 3.0);
        let (a, b) = (Text::fixed("abc"), Text::fixed("def"));
        assert_eq!((min_text(a.clone(), b.clone()), max_text(a.clone(), b.clone())), (a.clone(), b.clone()));
        assert_eq!(clamp_text(Text::fixed("x"), a.clone(), b.clone()), b);
        assert_eq!(clamp_text(Text::fixed("Z"), a.clone(), b), a);
    }

    #[test]
    fn a_number_is_preferred_to_none() {
        let none = f64::NAN;
        assert_eq!((min(none, 1.0), min(1.0, none), max(none, 1.0), max(1.0, none)), (1.0, 1.0, 1.0, 1.0));
        assert!(clamp(none, 0.0, 1.0).is_nan());
        assert_eq!((clamp(5.0, none, 1.0), clamp(5.0, 0.0, none)), (1.0, 5.0));
    }

    #[test]
    fn arrays_go_element_by_element() {
        let env = &mut env();
        let (a, b) = (Array::from([1.0, 5.0]), Array::from([2.0, 3.0]));
        assert_eq!(min_each(env, a.clone(), b.clone()), Array::from([1.0, 3.0]));
        assert_eq!(max_each(env, a.clone(), b.clone()), Array::from([2.0, 5.0]));
        assert_eq!(clamp_each(env, Array::from([0.0, 9.0]), a.clone(), b.clone()), Array::from([1.0, 3.0]));
        assert_eq!(clamp_each(env, Array::from([1.5, 4.0]), a.clone(), b), Array::from([1.5, 5.0]));
        assert_eq!(faults(env), 0);
        assert!(clamp_each(env, Array::from([0.0]), a.clone(), a.clone()).is_empty());
        assert!(min_each(env, Array::from(vec![vec![1.0], vec![2.0]]), a).is_empty());
        assert_eq!(faults(env), 2);
    }
}
