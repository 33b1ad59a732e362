//! Elements by their numbers: `a[2]`, `a[0, 1]`, `a[[2, 0]]`, `a[a .> 2]`, `m[[2, 3], -1:1]` (*index operator*).
//!
//! Elements outside the array have the default value: 0, false, "".

use super::super::whole;
use super::each::Operand;
use crate::run::env::Env;
use crate::value::array::{Array, Element};

/// An index of elements, rows or columns: a number, numbers, or truth values that mark the selected ones.
pub trait Indices: Operand {
    /// The selected positions; `None` for an impossible one.
    fn places(&self, env: &mut Env) -> Vec<Option<usize>>;

    /// The rows and columns of a result with `places` elements.
    fn result_form(&self, places: usize) -> (usize, usize) {
        (1, places)
    }
}

impl Indices for f64 {
    fn places(&self, env: &mut Env) -> Vec<Option<usize>> {
        vec![whole(env.finite(*self, "an index"))]
    }
}

impl Indices for Array<f64> {
    fn places(&self, _: &mut Env) -> Vec<Option<usize>> {
        self.into_iter().map(|&index| whole(index)).collect()
    }

    /// The result has the shape of the array of indices.
    fn result_form(&self, _: usize) -> (usize, usize) {
        (self.rows(), self.columns())
    }
}

impl Indices for Array<bool> {
    /// The positions of true values, counted row by row.
    fn places(&self, _: &mut Env) -> Vec<Option<usize>> {
        self.into_iter().enumerate().filter(|(_, truth)| **truth).map(|(place, _)| Some(place)).collect()
    }
}

/// `a[index]`, counted row by row.
pub fn element<T: Element>(env: &mut Env, array: Array<T>, index: f64) -> T {
    whole(env.finite(index, "an index")).and_then(|place| array.get(place)).cloned().unwrap_or_default()
}

/// `a[row, column]`.
pub fn element_at<T: Element>(env: &mut Env, array: Array<T>, row: f64, column: f64) -> T {
    let (row, column) = (whole(env.finite(row, "a row index")), whole(env.finite(column, "a column index")));
    row.zip(column).and_then(|(row, column)| array.at(row, column)).cloned().unwrap_or_default()
}

/// `a[indices]`, counted row by row. The result has the shape of the numbers; for truth values it is one row.
pub fn elements<T: Element>(env: &mut Env, array: Array<T>, indices: impl Indices) -> Array<T> {
    let places = indices.places(env);
    if !env.may_hold(places.len()) {
        return Array::default();
    }
    let (rows, columns) = indices.result_form(places.len());
    let values: Vec<T> =
        places.into_iter().map(|place| place.and_then(|place| array.get(place)).cloned().unwrap_or_default()).collect();
    Array::new(values, rows, columns)
}

/// `a[rows, columns]`: a row for each row index, a column for each column index.
pub fn elements_at<T: Element>(env: &mut Env, array: Array<T>, rows: impl Indices, columns: impl Indices) -> Array<T> {
    let (rows, columns) = (rows.places(env), columns.places(env));
    if !env.may_hold(rows.len().saturating_mul(columns.len())) {
        return Array::default();
    }
    let mut values = Vec::with_capacity(rows.len() * columns.len());
    for row in &rows {
        let row = row.and_then(|row| array.row(row)).unwrap_or_default();
        values.extend(columns.iter().map(|column| column.and_then(|at| row.get(at)).cloned().unwrap_or_default()));
    }
    Array::new(values, rows.len(), columns.len())
}

#[cfg(test)]
mod tests {
    use super::super::super::tests::{Random, env, faults, limit, small_env, text};
    use super::super::build::range_by;
    use super::super::each::each_greater;
    use super::*;
    use crate::fault::LimitKind;
    use crate::func::tests::range;

    fn row<const N: usize>(values: [f64; N]) -> Array<f64> {
        Array::from(values)
    }

    fn matrix() -> Array<f64> {
        Array::from(vec![vec![1.0, 2.0, 3.0], vec![4.0, 5.0, 6.0], vec![7.0, 8.0, 9.0]])
    }

    #[test]
    fn one_index_counts_row_by_row() {
        // *index operator*, the examples with one index.
        let env = &mut env();
        let a = row([1.0, 2.0, 3.0, 4.0]);
        assert_eq!([0.0, 3.0, -1.0, 4.0].map(|index| element(env, a.clone(), index)), [1.0, 4.0, 0.0, 0.0]);
        assert_eq!(elements(env, a.clone(), row([0.0, 2.0])), row([1.0, 3.0]));
        assert_eq!(elements(env, a.clone(), row([1.0, 1.0])), row([2.0, 2.0]));
        let back = range_by(env, 3.0, -1.0, 1.0);
        assert_eq!(elements(env, a.clone(), back), row([4.0, 3.0, 2.0]));
        let square = Array::from(vec![vec![0.0, 1.0], vec![2.0, 3.0]]);
        assert_eq!(elements(env, a.clone(), square), Array::from(vec![vec![1.0, 2.0], vec![3.0, 4.0]]));
        assert_eq!(elements(env, a.clone(), Array::from([true, false, true])), row([1.0, 3.0]));
        let large = each_greater(env, a.clone(), 2.0);
        assert_eq!(elements(env, a.clone(), large), row([3.0, 4.0]));
        assert_eq!(elements(env, a.clone(), Array::from([false, false, true, true, true])), row([3.0, 4.0, 0.0]));
        let truths = Array::from(vec![vec![true, false], vec![true, false]]);
        assert_eq!(elements(env, a, truths), row([1.0, 3.0]));
        assert_eq!(element(env, matrix(), 3.0), 4.0);
        let down = Array::from(vec![vec![0.0], vec![3.0], vec![6.0]]);
        assert_eq!(elements(env, matrix(), down), Array::from(vec![vec![1.0], vec![4.0], vec![7.0]]));
        let all = range(env, 0.0, 8.0);
        assert_eq!(elements(env, matrix(), all), row([1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0]));
        assert_eq!(faults(env), 0);
    }

    #[test]
    fn two_indices_select_rows_and_columns() {
        // *index operator*, the examples with two indices.
        let env = &mut env();
        assert_eq!((element_at(env, matrix(), 1.0, 1.0), element_at(env, matrix(), 0.0, 3.0)), (5.0, 0.0));
        assert_eq!(elements_at(env, matrix(), 1.0, row([0.0, 2.0])), row([4.0, 6.0]));
        let down = Array::from(vec![vec![3.0], vec![3.0], vec![6.0]]);
        assert_eq!(elements_at(env, matrix(), row([0.0, 0.0, 1.0]), 2.0), down);
        let outer = Array::from(vec![vec![1.0, 3.0], vec![4.0, 6.0], vec![7.0, 9.0]]);
        assert_eq!(elements_at(env, matrix(), row([0.0, 1.0, 2.0]), row([0.0, 2.0])), outer);
        let truths = Array::from([false, true, true]);
        assert_eq!(elements_at(env, matrix(), truths, 0.0), Array::from(vec![vec![4.0], vec![7.0]]));
        let columns = range(env, -1.0, 1.0);
        let beyond = Array::from(vec![vec![0.0, 7.0, 8.0], vec![0.0; 3]]);
        assert_eq!(elements_at(env, matrix(), row([2.0, 3.0]), columns), beyond);
        let square = Array::from(vec![vec![0.0, 1.0], vec![2.0, 3.0]]);
        assert_eq!(elements_at(env, matrix(), 0.0, square), row([1.0, 2.0, 3.0, 0.0]));
        // "Indexing out of bounds" gives an array of zeros.
        let (rows, columns) = (range(env, 1.0, 2.0), range(env, 1.0, 3.0));
        assert_eq!(elements_at(env, Array::<f64>::default(), rows, columns), Array::from(vec![vec![0.0; 3]; 2]));
        assert_eq!(faults(env), 0);
    }

    #[test]
    fn what_is_missing_is_the_default_of_its_type() {
        let env = &mut env();
        assert_eq!(element(env, Array::from([text("a")]), 1.0), text(""));
        assert!(!element(env, Array::from([true]), -1.0));
        assert_eq!(elements(env, Array::from([true]), row([0.0, 1e300, f64::NAN])), Array::from([true, false, false]));
        assert_eq!(faults(env), 0);
        assert_eq!((element(env, row([7.0]), f64::NAN), element(env, row([7.0]), f64::INFINITY)), (7.0, 7.0));
        assert_eq!(faults(env), 2);
        assert!(elements(env, row([1.0]), Array::<f64>::default()).is_empty());
        assert!(elements_at(env, row([1.0]), 0.0, Array::<bool>::default()).is_empty());
    }

    #[test]
    fn what_indices_ask_for_has_a_limit() {
        let env = &mut small_env(5, 0);
        assert!(elements_at(env, row([1.0]), row([0.0; 3]), row([0.0; 2])).is_empty());
        assert_eq!(limit(env), Some(LimitKind::Array));
    }

    #[test]
    fn many_indices_are_as_many_single_ones() {
        let mut random = Random(78);
        for _ in 0..5_000 {
            let env = &mut env();
            let mut numbers = |rows: usize, columns: usize| -> Array<f64> {
                Array::new((0..rows * columns).map(|_| random.number()).collect::<Vec<_>>(), rows, columns)
            };
            let (array, first, second) = (numbers(3, 4), numbers(2, 3), numbers(2, 2));
            // Single numbers that are not finite count as 0, with a fault. In arrays they select no element.
            let one =
                |env: &mut Env, index: f64| if index.is_finite() { element(env, array.clone(), index) } else { 0.0 };
            let expected: Vec<f64> = first.into_iter().map(|&index| one(env, index)).collect();
            let chosen = elements(env, array.clone(), first.clone());
            assert_eq!((chosen.rows(), chosen.columns()), (2, 3));
            assert!(same(chosen.as_slice(), &expected), "{array:?}[{first:?}]");
            let block = elements_at(env, array.clone(), first.clone(), second.clone());
            assert_eq!((block.rows(), block.columns()), (6, 4));
            for (row, &r) in first.into_iter().enumerate() {
                for (column, &c) in second.into_iter().enumerate() {
                    let finite = r.is_finite() && c.is_finite();
                    let expected = if finite { element_at(env, array.clone(), r, c) } else { 0.0 };
                    assert!(same(&[*block.at(row, column).unwrap()], &[expected]), "{array:?}[{r}, {c}]");
                }
            }
        }
    }

    fn same(a: &[f64], b: &[f64]) -> bool {
        a.iter().map(|value| value.to_bits()).eq(b.iter().map(|value| value.to_bits()))
    }
}
