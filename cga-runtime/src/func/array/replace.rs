//! `setElems`: a copy of an array with some values replaced.

use super::each::Operand;
use super::index::Indices;
use crate::fault::FaultKind;
use crate::run::env::Env;
use crate::value::array::{Array, Element};

/// `setElems(array, indices, values)`: elements counted row by row (*setElems function*).
///
/// A single value goes to every position. An array must have as many values as there are positions; otherwise the
/// result is the unchanged array, with a fault. Positions below 0 are skipped. Positions beyond the end enlarge the
/// array: a single row gets longer, and an array with several rows gets more rows, so that every element keeps its
/// number.
pub fn set_elements<T: Element>(
    env: &mut Env,
    array: Array<T>,
    indices: impl Indices,
    values: impl Operand<Item = T>,
) -> Array<T> {
    let places = indices.places(env);
    let wanted = values.form().map(|(rows, columns)| rows * columns);
    if let Some(wanted) = wanted
        && wanted != places.len()
    {
        env.fault(
            FaultKind::Value,
            format!("setElems has {} places for {wanted} values; the array stays as it is", places.len()),
        );
        return array;
    }
    let size = places.iter().flatten().max().map_or(0, |last| last.saturating_add(1)).max(array.len());
    let columns = if array.rows() <= 1 { size } else { array.columns() };
    let rows = size.div_ceil(columns.max(1));
    let Some(mut elements) = enlarged(env, &array, rows, columns) else { return Array::default() };
    for (number, place) in places.into_iter().enumerate() {
        if let Some(element) = place.and_then(|place| elements.get_mut(place)) {
            *element = values.item(number);
        }
    }
    Array::new(elements, rows, columns)
}

/// `setElems(array, rowIndices, colIndices, values)`: elements by row and column (*setElems function*).
///
/// A single value goes to every position. An array must have a row for each row index and a column for each column
/// index; otherwise the result is the unchanged array, with a fault. Positions below 0 are skipped. Positions beyond
/// the end enlarge the array.
pub fn set_elements_at<T: Element>(
    env: &mut Env,
    array: Array<T>,
    rows: impl Indices,
    columns: impl Indices,
    values: impl Operand<Item = T>,
) -> Array<T> {
    let (row_places, column_places) = (rows.places(env), columns.places(env));
    let form = (row_places.len(), column_places.len());
    if let Some((rows, columns)) = values.form()
        && (rows, columns) != form
        && rows * columns + form.0 * form.1 != 0
    {
        let message =
            format!("setElems has {}x{} places for {rows}x{columns} values; the array stays as it is", form.0, form.1);
        env.fault(FaultKind::Value, message);
        return array;
    }
    let end = |places: &[Option<usize>]| places.iter().flatten().max().map(|last| last.saturating_add(1));
    // Without a row or a column there is no position.
    let Some((last_row, last_column)) = end(&row_places).zip(end(&column_places)) else { return array };
    let (rows, columns) = (array.rows().max(last_row), array.columns().max(last_column));
    let Some(mut elements) = enlarged(env, &array, rows, columns) else { return Array::default() };
    for (i, row) in row_places.into_iter().enumerate() {
        for (j, column) in column_places.iter().enumerate() {
            if let Some((row, column)) = row.zip(*column) {
                elements[row * columns + column] = values.item(i * form.1 + j);
            }
        }
    }
    Array::new(elements, rows, columns)
}

/// The elements of an array enlarged to `rows` rows and `columns` columns. `None` beyond the limit.
fn enlarged<T: Element>(env: &mut Env, array: &Array<T>, rows: usize, columns: usize) -> Option<Vec<T>> {
    let count = rows.saturating_mul(columns);
    if !env.may_hold(count) {
        return None;
    }
    let mut elements = Vec::with_capacity(count);
    for row in array.iter_rows() {
        elements.extend_from_slice(row);
        elements.extend(std::iter::repeat_n(T::default(), columns - row.len()));
    }
    elements.resize(count, T::default());
    Some(elements)
}

#[cfg(test)]
mod tests {
    use super::super::super::tests::{Random, env, faults, limit, small_env, text};
    use super::super::build::range_by;
    use super::super::each::{each_equal, each_greater};
    use super::super::measure::count_true;
    use super::*;
    use crate::fault::LimitKind;
    use crate::func::tests::range;

    fn row<const N: usize>(values: [f64; N]) -> Array<f64> {
        Array::from(values)
    }

    fn rows<const N: usize, const M: usize>(rows: [[f64; N]; M]) -> Array<f64> {
        Array::from(rows.iter().map(|row| row.to_vec()).collect::<Vec<_>>())
    }

    #[test]
    fn one_index_counts_row_by_row() {
        // *setElems function*, the examples with one index.
        let env = &mut env();
        let zeros = || row([0.0; 6]);
        assert_eq!(set_elements(env, zeros(), 2.0, 1.0), row([0.0, 0.0, 1.0, 0.0, 0.0, 0.0]));
        let (middle, values) = (range(env, 1.0, 4.0), range(env, 1.0, 3.0));
        assert_eq!(set_elements(env, zeros(), middle, 1.0), row([0.0, 1.0, 1.0, 1.0, 1.0, 0.0]));
        let mut set = |places: [f64; 3]| set_elements(env, zeros(), row(places), values.clone());
        assert_eq!(set([1.0, 3.0, 5.0]), row([0.0, 1.0, 0.0, 2.0, 0.0, 3.0]));
        assert_eq!(set([5.0, 1.0, 3.0]), row([0.0, 2.0, 0.0, 3.0, 0.0, 1.0]));
        assert_eq!(set([1.0, 1.0, 1.0]), row([0.0, 3.0, 0.0, 0.0, 0.0, 0.0]));
        let sequence = range(env, 1.0, 7.0);
        let large = each_greater(env, sequence.clone(), 4.0);
        assert_eq!(set_elements(env, sequence.clone(), large.clone(), 4.0), row([1.0, 2.0, 3.0, 4.0, 4.0, 4.0, 4.0]));
        let values = row([3.0, 2.0, 1.0]);
        assert_eq!(set_elements(env, sequence, large, values), row([1.0, 2.0, 3.0, 4.0, 3.0, 2.0, 1.0]));
        assert_eq!(set_elements(env, row([1.0, 1.0]), 3.0, 5.0), row([1.0, 1.0, 0.0, 5.0]));
        assert_eq!(faults(env), 0);
    }

    #[test]
    fn two_indices_select_rows_and_columns() {
        // *setElems function*, the examples with two indices.
        let env = &mut env();
        let zeros = || rows([[0.0; 3]; 3]);
        let values = || rows([[1.0, 2.0], [3.0, 4.0]]);
        let set = |env: &mut Env, a: [f64; 2], b: [f64; 2]| set_elements_at(env, zeros(), row(a), row(b), values());
        let one = set_elements_at(env, zeros(), 1.0, 1.0, 5.0);
        assert_eq!(one, rows([[0.0; 3], [0.0, 5.0, 0.0], [0.0; 3]]));
        let ends = set_elements_at(env, zeros(), row([0.0, 2.0]), row([0.0, 1.0, 2.0]), 1.0);
        assert_eq!(ends, rows([[1.0; 3], [0.0; 3], [1.0; 3]]));
        assert_eq!(set(env, [1.0, 2.0], [0.0, 2.0]), rows([[0.0; 3], [1.0, 0.0, 2.0], [3.0, 0.0, 4.0]]));
        assert_eq!(set(env, [2.0, 1.0], [2.0, 0.0]), rows([[0.0; 3], [4.0, 0.0, 3.0], [2.0, 0.0, 1.0]]));
        assert_eq!(set(env, [1.0, 1.0], [0.0, 2.0]), rows([[0.0; 3], [3.0, 0.0, 4.0], [0.0; 3]]));
        let grown = set_elements_at(env, row([1.0, 1.0]), 2.0, 2.0, 5.0);
        assert_eq!(grown, rows([[1.0, 1.0, 0.0], [0.0; 3], [0.0, 0.0, 5.0]]));
        assert_eq!(faults(env), 0);
    }

    #[test]
    fn the_examples_of_the_page_work() {
        let env = &mut env();
        // "Enumerate value".
        let found = each_equal(env, Array::from(["a", "c", "b", "a", "d", "a"].map(text)), text("a"));
        let numbers = range(env, 1.0, count_true(found.clone()));
        assert_eq!(set_elements(env, Array::default(), found, numbers), row([1.0, 0.0, 0.0, 2.0, 0.0, 3.0]));
        // "Create diagonal matrix".
        let diagonal = range_by(env, 0.0, 4.0, 8.0);
        let identity = rows([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]);
        assert_eq!(set_elements(env, rows([[0.0; 3]; 3]), diagonal, 1.0), identity);
        // "Reshape array".
        let all = range(env, 0.0, 5.0);
        let array = rows([[1.0, 2.0, 3.0], [4.0, 5.0, 6.0]]);
        let reshaped = rows([[1.0, 2.0], [3.0, 4.0], [5.0, 6.0]]);
        assert_eq!(set_elements(env, rows([[0.0; 2]; 3]), all, array), reshaped);
        assert_eq!(faults(env), 0);
    }

    #[test]
    fn places_below_zero_are_left_out() {
        let env = &mut env();
        assert_eq!(set_elements(env, row([1.0, 2.0]), row([-1.0, 0.0]), row([8.0, 9.0])), row([9.0, 2.0]));
        assert_eq!(set_elements(env, row([1.0]), row([f64::NAN]), 5.0), row([1.0]));
        assert_eq!(set_elements_at(env, row([1.0]), -1.0, 5.0, 5.0), row([1.0]));
        assert_eq!(set_elements_at(env, row([1.0]), row([-1.0, 0.0]), 1.0, 5.0), row([1.0, 5.0]));
        assert_eq!(set_elements(env, row([1.0]), Array::from([false]), 5.0), row([1.0]));
        assert!(set_elements(env, Array::<f64>::default(), Array::<f64>::default(), 5.0).is_empty());
        assert!(set_elements_at(env, Array::<f64>::default(), -1.0, -1.0, 5.0).is_empty());
        assert_eq!(faults(env), 0);
    }

    #[test]
    fn elements_keep_their_numbers_when_rows_are_added() {
        let env = &mut env();
        let grown = set_elements(env, rows([[1.0, 2.0], [3.0, 4.0]]), 6.0, 7.0);
        assert_eq!(grown, rows([[1.0, 2.0], [3.0, 4.0], [0.0, 0.0], [7.0, 0.0]]));
    }

    #[test]
    fn values_must_fit_the_places() {
        let env = &mut env();
        assert_eq!(set_elements(env, row([1.0, 2.0]), row([0.0, 1.0]), row([5.0])), row([1.0, 2.0]));
        assert_eq!(set_elements_at(env, row([1.0, 2.0]), 0.0, row([0.0, 1.0]), rows([[5.0], [6.0]])), row([1.0, 2.0]));
        assert_eq!(faults(env), 2);
        let none = Array::<f64>::default;
        assert_eq!(set_elements_at(env, row([1.0]), none(), row([0.0, 1.0]), none()), row([1.0]));
        assert_eq!(faults(env), 0);
    }

    #[test]
    fn growth_has_a_limit() {
        for index in [10.0, 1e9, 1e300] {
            let env = &mut small_env(10, 0);
            assert!(set_elements(env, row([1.0]), index, 1.0).is_empty());
            assert_eq!(limit(env), Some(LimitKind::Array));
            let env = &mut small_env(10, 0);
            assert!(set_elements_at(env, row([1.0]), row([0.0, index]), index, 1.0).is_empty());
            assert_eq!(limit(env), Some(LimitKind::Array));
        }
        assert_eq!(set_elements(&mut small_env(10, 0), row([1.0]), 9.0, 1.0).len(), 10);
    }

    #[test]
    fn what_was_set_can_be_read_and_the_rest_stays() {
        use super::super::index::{element_at, elements};
        let mut random = Random(81);
        for _ in 0..5_000 {
            let env = &mut small_env(1000, 0);
            let (height, width) = (random.below(4), random.below(4));
            let array = Array::new((0..height * width).map(|n| n as f64 + 1.0).collect::<Vec<_>>(), height, width);
            let places: Array<f64> = (0..random.below(4)).map(|_| random.number()).collect();
            let set = set_elements(env, array.clone(), places.clone(), -1.0);
            if !env.ended() {
                for &value in &elements(env, set.clone(), places.clone()) {
                    assert!(value == -1.0 || value == 0.0, "outside is the default, inside what was set");
                }
                let old = set.into_iter().zip(&array).filter(|(new, old)| **new != -1.0 && new != old).count();
                assert_eq!(old, 0, "{array:?} {places:?}");
                assert!(array.len() <= set.len());
            }
            let env = &mut small_env(1000, 0);
            let (row, column) = (random.number(), random.number());
            let set = set_elements_at(env, array.clone(), row, column, -1.0);
            if !env.ended() {
                for r in 0..height {
                    for c in 0..width {
                        let new = element_at(env, set.clone(), r as f64, c as f64);
                        assert!(new == -1.0 || Some(&new) == array.at(r, c));
                    }
                }
                assert!(set.into_iter().filter(|value| **value == -1.0).count() <= 1);
            }
        }
    }
}
