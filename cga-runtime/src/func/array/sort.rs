//! The order of elements and rows.

use std::cmp::Ordering;

use crate::geometry::small_sort::SmallSort;
use crate::run::env::Env;
use crate::value::array::{Array, Element};
use crate::value::compare::Compare;

/// A total order, which sorting needs: NaN comes last.
fn order<T: Compare>(a: &T, b: &T) -> Ordering {
    match (a.unordered(), b.unordered()) {
        (false, false) => a.compare(b),
        (one, other) => one.cmp(&other),
    }
}

/// For each row, the positions of its elements in the array, counted row by row, from the smallest to the largest
/// (*sortIndices function*). Equal elements keep their order.
pub fn sort_indices<T: Element>(env: &mut Env, array: Array<T>) -> Array<f64> {
    if !env.may_hold(array.len()) {
        return Array::default();
    }
    let mut indices: Vec<usize> = (0..array.len()).collect();
    for row in indices.chunks_mut(array.columns().max(1)) {
        row.small_sort_by(|&a, &b| order(&array.as_slice()[a], &array.as_slice()[b]));
    }
    Array::new(numbers(indices), array.rows(), array.columns())
}

/// The numbers of the rows, from the smallest to the largest. The first elements that differ decide (*sortRowIndices
/// function*). Equal rows keep their order.
pub fn sort_row_indices<T: Element>(env: &mut Env, array: Array<T>) -> Array<f64> {
    if !env.may_hold(array.rows()) {
        return Array::default();
    }
    let rows: Vec<&[T]> = array.iter_rows().collect();
    let mut indices: Vec<usize> = (0..rows.len()).collect();
    let compare = |a: &[T], b: &[T]| a.iter().zip(b).map(|(a, b)| order(a, b)).find(|order| order.is_ne());
    indices.small_sort_by(|&a, &b| compare(rows[a], rows[b]).unwrap_or(Ordering::Equal));
    Array::from(numbers(indices))
}

fn numbers(indices: Vec<usize>) -> Vec<f64> {
    indices.into_iter().map(|index| index as f64).collect()
}

#[cfg(test)]
mod tests {
    use super::super::super::tests::{Random, env, text};
    use super::*;

    #[test]
    fn elements_are_sorted_in_each_row() {
        let env = &mut env();
        // *sortIndices function*.
        assert_eq!(sort_indices(env, Array::from(["c", "b", "d", "a"].map(text))), Array::from([3.0, 1.0, 0.0, 2.0]));
        let numbers = Array::from([2.0, 1.0, 3.0, 3.0, 1.0]);
        assert_eq!(sort_indices(env, numbers), Array::from([1.0, 4.0, 0.0, 2.0, 3.0]));
        let rows = [["e", "c", "d"], ["b", "a", "c"], ["d", "a", "d"]].map(|row| row.map(text).to_vec()).to_vec();
        let sorted = [[1.0, 2.0, 0.0], [4.0, 3.0, 5.0], [7.0, 6.0, 8.0]].map(|row| row.to_vec()).to_vec();
        assert_eq!(sort_indices(env, Array::from(rows)), Array::from(sorted));
        assert!(sort_indices(env, Array::<f64>::default()).is_empty());
    }

    #[test]
    fn rows_are_sorted_by_their_first_difference() {
        let env = &mut env();
        // *sortRowIndices function*.
        let rows = [[4.0, 0.0, 1.0], [2.0, 1.0, 9.0], [1.0, 3.0, 0.0], [2.0, 1.0, 0.0]].map(|row| row.to_vec());
        assert_eq!(sort_row_indices(env, Array::from(rows.to_vec())), Array::from([2.0, 3.0, 1.0, 0.0]));
        let equal = Array::from(vec![vec![text("b")], vec![text("a")], vec![text("b")]]);
        assert_eq!(sort_row_indices(env, equal), Array::from([1.0, 0.0, 2.0]));
        assert!(sort_row_indices(env, Array::<f64>::default()).is_empty());
    }

    #[test]
    fn what_is_no_number_comes_last() {
        let env = &mut env();
        let none = f64::NAN;
        let array = Array::from([none, 2.0, f64::INFINITY, none, -0.0, 0.0, f64::NEG_INFINITY]);
        assert_eq!(sort_indices(env, array), Array::from([6.0, 4.0, 5.0, 1.0, 2.0, 0.0, 3.0]));
        let rows = Array::from(vec![vec![none, 1.0], vec![none, 0.0], vec![5.0, none]]);
        assert_eq!(sort_row_indices(env, rows), Array::from([2.0, 1.0, 0.0]));
    }

    #[test]
    fn sorting_is_a_permutation_in_order() {
        let env = &mut env();
        let mut random = Random(82);
        for _ in 0..2_000 {
            let (rows, columns) = (random.below(5), random.below(40));
            let values: Vec<f64> = (0..rows * columns).map(|_| random.number()).collect();
            let array = Array::new(values, rows, columns);
            let indices = sort_indices(env, array.clone());
            for (number, row) in indices.iter_rows().enumerate() {
                let mut seen: Vec<usize> = row.iter().map(|&index| index as usize).collect();
                for pair in seen.windows(2) {
                    let (a, b) = (array.as_slice()[pair[0]], array.as_slice()[pair[1]]);
                    let order = order(&a, &b);
                    assert!(order.is_lt() || order.is_eq() && pair[0] < pair[1]);
                }
                seen.sort_unstable();
                assert!(seen.into_iter().eq(number * columns..(number + 1) * columns));
            }
            let mut seen: Vec<f64> = sort_row_indices(env, array.clone()).as_slice().to_vec();
            seen.sort_by(f64::total_cmp);
            assert!(seen.into_iter().eq((0..array.rows()).map(|row| row as f64)));
        }
    }
}
