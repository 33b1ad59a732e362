//! Properties of a whole array: its size, its sum, the position of a value.

use crate::run::env::Env;
use crate::value::array::{Array, Element};
use crate::value::text::Text;

/// The number of elements (*size function*).
pub fn size<T: Element>(array: Array<T>) -> f64 {
    array.len() as f64
}

/// The number of rows (*nRows function*); 0 without elements.
pub fn n_rows<T: Element>(array: Array<T>) -> f64 {
    array.rows() as f64
}

/// The number of columns (*nColumns function*); 0 without elements.
pub fn n_columns<T: Element>(array: Array<T>) -> f64 {
    array.columns() as f64
}

/// The sum of all numbers, added from the first to the last (*sum function*).
pub fn sum(array: Array<f64>) -> f64 {
    // A fold, because `sum` of an empty iterator is -0.
    array.into_iter().fold(0.0, |sum, value| sum + value)
}

/// The number of true elements (*sum function*).
pub fn count_true(array: Array<bool>) -> f64 {
    array.into_iter().filter(|truth| **truth).count() as f64
}

/// All texts joined in order (*sum function*).
pub fn join(env: &mut Env, array: Array<Text>) -> Text {
    if env.may_write(array.into_iter().map(|text| text.len()).fold(0, usize::saturating_add)) {
        Text::from(array.into_iter().map(Text::as_str).collect::<String>())
    } else {
        Text::default()
    }
}

/// The position of the first element equal to `value`, counted row by row from 0; -1 without one (*findFirst function
/// (builtin)*).
pub fn find_element<T: Element>(array: Array<T>, value: T) -> f64 {
    place(array.into_iter().position(|element| element.compare(&value).is_eq()))
}

/// The position of the first number at most `epsilon` from `value`, counted row by row from 0; -1 without one
/// (*findFirst function (builtin)*).
pub fn find_near(env: &mut Env, array: Array<f64>, value: f64, epsilon: f64) -> f64 {
    let value = env.finite(value, "the value to find");
    let epsilon = env.finite(epsilon, "the tolerance");
    place(array.into_iter().position(|element| (element - value).abs() <= epsilon))
}

fn place(place: Option<usize>) -> f64 {
    place.map_or(-1.0, |place| place as f64)
}

/// Rows as columns (*transpose function*).
pub fn transpose<T: Element>(env: &mut Env, array: Array<T>) -> Array<T> {
    if !env.may_hold(array.len()) {
        return Array::default();
    }
    let columns = (0..array.columns()).flat_map(|column| array.iter_rows().map(move |row| row[column].clone()));
    Array::new(columns.collect::<Vec<_>>(), array.columns(), array.rows())
}

#[cfg(test)]
mod tests {
    use super::super::super::tests::{env, faults, limit, small_env, text};
    use super::*;
    use crate::fault::LimitKind;

    fn two_rows() -> Array<f64> {
        Array::from(vec![vec![1.0, 2.0, 3.0], vec![4.0, 5.0, 6.0]])
    }

    #[test]
    fn sizes_are_counted() {
        // *size function*, *nRows function*, *nColumns function*.
        assert_eq!((size(two_rows()), n_rows(two_rows()), n_columns(two_rows())), (6.0, 2.0, 3.0));
        let none = Array::<bool>::default();
        assert_eq!((size(none.clone()), n_rows(none.clone()), n_columns(none)), (0.0, 0.0, 0.0));
        assert_eq!((n_rows(Array::from([true])), n_columns(Array::from([text("")]))), (1.0, 1.0));
    }

    #[test]
    fn numbers_are_added_truths_counted_and_texts_joined() {
        assert_eq!(sum(Array::from([1.0, 2.0, 3.0])), 6.0);
        assert_eq!(count_true(Array::from([true, false, true])), 2.0);
        assert_eq!(join(&mut env(), Array::from(["a", "b", "c"].map(text))), text("abc"));
        assert_eq!(sum(Array::default()).to_bits(), 0.0f64.to_bits());
        assert_eq!((count_true(Array::default()), join(&mut env(), Array::default())), (0.0, text("")));
        let env = &mut small_env(10, 3);
        assert_eq!(join(env, Array::from(["ab", "ü"].map(text))), text(""));
        assert_eq!(limit(env), Some(LimitKind::Text));
    }

    #[test]
    fn values_are_found() {
        // *findFirst function (builtin)*.
        let env = &mut env();
        assert_eq!(find_near(env, Array::from([1.0, 2.0, 3.0, 4.0]), 2.0, 0.0), 1.0);
        assert_eq!(find_near(env, two_rows(), 4.0, 0.0), 3.0);
        assert_eq!(find_near(env, Array::from([6.0, 8.1, 6.0, 8.1]), 8.0, 0.5), 1.0);
        assert_eq!(find_near(env, two_rows(), 9.0, 0.5), -1.0);
        assert_eq!(find_near(env, Array::from([f64::NAN, f64::INFINITY, 0.0]), 0.0, 1.0), 2.0);
        assert_eq!(find_near(env, two_rows(), 1.0, -1.0), -1.0);
        assert_eq!(find_element(Array::from(["a", "b", "b"].map(text)), text("b")), 1.0);
        assert_eq!((find_element(Array::from([true]), false), find_element(Array::from([true]), true)), (-1.0, 0.0));
        assert_eq!(faults(env), 0);
        assert_eq!(find_near(env, Array::from([1.0, 0.0]), f64::NAN, f64::NAN), 1.0);
        assert_eq!(faults(env), 2);
    }

    #[test]
    fn rows_become_columns() {
        // *transpose function*.
        let env = &mut env();
        let array = Array::from(vec![["a", "b"].map(text).to_vec(), ["c", "d"].map(text).to_vec()]);
        assert_eq!(transpose(env, array.clone()).to_string(), "(2x2)\n   a   c\n   b   d");
        let turned = transpose(env, array.clone());
        assert_eq!(transpose(env, turned), array);
        assert_eq!((transpose(env, two_rows()).rows(), transpose(env, two_rows()).columns()), (3, 2));
        assert_eq!(transpose(env, two_rows()).as_slice(), [1.0, 4.0, 2.0, 5.0, 3.0, 6.0]);
        assert!(transpose(env, Array::<f64>::default()).is_empty());
    }
}
