//! `min`, `max`, `clamp`.

use std::cmp::Ordering;

use super::array::{each_pair, same_form};
use crate::run::env::Env;
use crate::value::array::{Array, Element};
use crate::value::compare::Compare;

/// Returns true if `a` is less than `b`. NaN is never less.
fn before<T: Compare>(a: &T, b: &T) -> bool {
    !a.unordered() && !b.unordered() && a.compare(b) == Ordering::Less
}

/// The smaller value (*min*). If one of the two is NaN, the other one.
pub fn min<T: Compare>(a: T, b: T) -> T {
    if a.unordered() || before(&b, &a) { b } else { a }
}

/// The larger value (*max*). If one of the two is NaN, the other one.
pub fn max<T: Compare>(a: T, b: T) -> T {
    if a.unordered() || before(&a, &b) { b } else { a }
}

/// `low` if `x` is less, `high` if `x` is greater, `x` otherwise (*clamp*).
pub fn clamp<T: Compare>(x: T, low: T, high: T) -> T {
    if before(&x, &low) {
        low
    } else if before(&high, &x) {
        high
    } else {
        x
    }
}

/// The smaller values, element by element. The pages *min*, *max* and *clamp* say only that the functions take arrays.
/// It is inferred that they compare elements, rather than choose one of the arrays by the order of arrays.
pub fn min_each<T: Element>(env: &mut Env, a: Array<T>, b: Array<T>) -> Array<T> {
    each_pair(env, "min", a, b, min)
}

/// The larger values, element by element; see [`min_each`].
pub fn max_each<T: Element>(env: &mut Env, a: Array<T>, b: Array<T>) -> Array<T> {
    each_pair(env, "max", a, b, max)
}

/// [`clamp`], element by element; see [`min_each`].
pub fn clamp_each<T: Element>(env: &mut Env, x: Array<T>, low: Array<T>, high: Array<T>) -> Array<T> {
    if !(same_form(env, "clamp", &x, &low) && same_form(env, "clamp", &x, &high)) {
        return Array::default();
    }
    if !env.may_hold(x.len()) {
        return Array::default();
    }
    let bounds = low.as_slice().iter().zip(high.as_slice());
    let values: Vec<T> =
        x.as_slice().iter().zip(bounds).map(|(x, (low, high))| clamp(x.clone(), low.clone(), high.clone())).collect();
    Array::new(values, x.rows(), x.columns())
}

#[cfg(test)]
mod tests {
    use super::super::tests::{env, faults};
    use super::*;
    use crate::value::text::Text;

    #[test]
    fn the_smaller_and_the_larger() {
        // *min*, *max*, *clamp*.
        assert_eq!((min(10.0, -10.0), max(10.0, -10.0)), (-10.0, 10.0));
        assert_eq!((clamp(1.5, 0.0, 1.0), clamp(-11.0, -10.0, 10.0), clamp(0.5, 0.0, 1.0)), (1.0, -10.0, 0.5));
        assert_eq!(clamp(0.0, 3.0, 1.0), 3.0);
        let (a, b) = (Text::fixed("abc"), Text::fixed("def"));
        assert_eq!((min(a.clone(), b.clone()), max(a.clone(), b.clone())), (a.clone(), b.clone()));
        assert_eq!(clamp(Text::fixed("x"), a.clone(), b.clone()), b);
        assert_eq!(clamp(Text::fixed("Z"), a.clone(), b), a);
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
