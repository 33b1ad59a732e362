//! Arrays: values of rules in rows and columns, cheap to copy.
//!
//! Elements are numbered from 0, row by row. An array without elements always has no rows and no columns, so all empty
//! arrays of a type are equal.

use std::cmp::Ordering;
use std::fmt::{self, Write};
use std::sync::Arc;

use super::compare::Compare;
use super::number::Number;
use crate::value::text::Text;

/// An array of numbers, truth values or texts (*array initialization function*). Arrays never change; copies share
/// their elements.
#[derive(Clone, PartialEq)]
pub struct Array<T> {
    values: Arc<[T]>,
    rows: usize,
    columns: usize,
}

/// A type that an array can hold: `f64`, `bool` and [`Text`]. Its default is the value of a missing element: 0, false,
/// "" (*index operator*).
pub trait Element:
    Clone + Default + PartialEq + fmt::Debug + Send + Sync + Compare + sealed::Printed + 'static
{
}

impl Element for f64 {}
impl Element for bool {}
impl Element for Text {}

mod sealed {
    use std::fmt;

    /// Writes a value as `str` and `print` show it. Private, so that other crates cannot add element types.
    pub trait Printed {
        fn print(&self, out: &mut dyn fmt::Write) -> fmt::Result;

        /// A lower bound of the printed bytes, known without printing.
        fn least_bytes(&self) -> usize {
            1
        }
    }
}

pub(crate) use sealed::Printed;

impl Printed for f64 {
    fn print(&self, out: &mut dyn Write) -> fmt::Result {
        write!(out, "{}", Number(*self))
    }
}

impl Printed for bool {
    fn print(&self, out: &mut dyn Write) -> fmt::Result {
        out.write_str(if *self { "true" } else { "false" })
    }
}

impl Printed for Text {
    fn print(&self, out: &mut dyn Write) -> fmt::Result {
        out.write_str(self)
    }

    fn least_bytes(&self) -> usize {
        self.len()
    }
}

impl<T> Array<T> {
    /// The elements, row by row.
    pub fn iter(&self) -> std::slice::Iter<'_, T> {
        self.values.iter()
    }

    /// The number of elements.
    pub fn len(&self) -> usize {
        self.values.len()
    }

    /// Returns true if the array has no elements.
    pub fn is_empty(&self) -> bool {
        self.values.is_empty()
    }

    /// The number of rows; 0 without elements.
    pub fn rows(&self) -> usize {
        self.rows
    }

    /// The number of columns; 0 without elements.
    pub fn columns(&self) -> usize {
        self.columns
    }

    /// An element by its number, counted from 0, row by row.
    pub fn get(&self, index: usize) -> Option<&T> {
        self.values.get(index)
    }

    /// An element by its row and column, counted from 0.
    pub fn at(&self, row: usize, column: usize) -> Option<&T> {
        self.row(row)?.get(column)
    }

    /// The elements of a row, counted from 0.
    pub fn row(&self, row: usize) -> Option<&[T]> {
        if row < self.rows { self.values.get(row * self.columns..(row + 1) * self.columns) } else { None }
    }

    /// All elements, row by row.
    pub fn as_slice(&self) -> &[T] {
        &self.values
    }

    /// The rows, from the first to the last.
    pub fn iter_rows(&self) -> impl ExactSizeIterator<Item = &[T]> {
        // Without columns there are no rows; the 1 only satisfies `chunks_exact`, which panics on 0.
        self.values.chunks_exact(self.columns.max(1))
    }

    /// Elements in rows of equal length.
    pub(crate) fn new(values: impl Into<Arc<[T]>>, rows: usize, columns: usize) -> Self {
        let values = values.into();
        debug_assert_eq!(values.len(), rows * columns);
        let (rows, columns) = if values.is_empty() { (0, 0) } else { (rows, columns) };
        Array { values, rows, columns }
    }

    /// An array of the same shape with `each` applied to every element.
    pub(crate) fn map<R>(&self, each: impl FnMut(&T) -> R) -> Array<R> {
        Array { values: self.values.iter().map(each).collect(), rows: self.rows, columns: self.columns }
    }
}

impl<T> Default for Array<T> {
    /// The empty array.
    fn default() -> Self {
        Array { values: Arc::from([]), rows: 0, columns: 0 }
    }
}

impl<T: Element> From<Vec<T>> for Array<T> {
    /// One row.
    fn from(row: Vec<T>) -> Self {
        let columns = row.len();
        Array::new(row, 1, columns)
    }
}

impl<T: Element, const N: usize> From<[T; N]> for Array<T> {
    /// One row.
    fn from(row: [T; N]) -> Self {
        Array::new(row, 1, N)
    }
}

impl<T: Element> FromIterator<T> for Array<T> {
    /// One row.
    fn from_iter<I: IntoIterator<Item = T>>(row: I) -> Self {
        Array::from(row.into_iter().collect::<Vec<_>>())
    }
}

impl<T: Element> From<Vec<Vec<T>>> for Array<T> {
    /// Several rows. Shorter rows are filled with the default; the reference defines only rows of equal length.
    fn from(rows: Vec<Vec<T>>) -> Self {
        let columns = rows.iter().map(Vec::len).max().unwrap_or_default();
        let count = rows.len();
        let mut values = Vec::with_capacity(count * columns);
        for (number, row) in rows.into_iter().enumerate() {
            values.extend(row);
            values.resize((number + 1) * columns, T::default());
        }
        Array::new(values, count, columns)
    }
}

impl<'a, T> IntoIterator for &'a Array<T> {
    type Item = &'a T;
    type IntoIter = std::slice::Iter<'a, T>;
    fn into_iter(self) -> Self::IntoIter {
        self.iter()
    }
}

impl<T: fmt::Debug> fmt::Debug for Array<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_list().entries(self.iter_rows()).finish()
    }
}

impl<T: Element> fmt::Display for Array<T> {
    /// The array as `print` and `str` show it (*array initialization function*): `(3)[0,1,2]`, or `(2x2)` and the rows
    /// below, with each column right-aligned after three spaces.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.rows <= 1 {
            write!(f, "({})[", self.len())?;
            for (i, value) in self.values.iter().enumerate() {
                f.write_str(if i == 0 { "" } else { "," })?;
                value.print(f)?;
            }
            return f.write_str("]");
        }
        write!(f, "({}x{})", self.rows, self.columns)?;
        let mut widths = vec![0; self.columns];
        for row in self.iter_rows() {
            for (width, value) in widths.iter_mut().zip(row) {
                *width = value_width(value)?.max(*width);
            }
        }
        for row in self.iter_rows() {
            f.write_str("\n")?;
            for (width, value) in widths.iter().zip(row) {
                // Written by hand, because a formatter's width is at most 65,535.
                for _ in value_width(value)?..width + 3 {
                    f.write_str(" ")?;
                }
                value.print(f)?;
            }
        }
        Ok(())
    }
}

/// The number of characters of a printed value.
fn value_width(value: &impl Printed) -> Result<usize, fmt::Error> {
    struct Count(usize);
    impl Write for Count {
        fn write_str(&mut self, text: &str) -> fmt::Result {
            self.0 += text.chars().count();
            Ok(())
        }
    }
    let mut count = Count(0);
    value.print(&mut count)?;
    Ok(count.0)
}

impl<T: Element> Compare for Array<T> {
    /// Element by element, row by row. If two rows agree up to the shorter one, the array with fewer columns is less;
    /// if all common rows are equal, the array with fewer rows is less (*Array types operators*).
    fn compare(&self, other: &Self) -> Ordering {
        for (row, other_row) in self.iter_rows().zip(other.iter_rows()) {
            let elements = row.iter().zip(other_row).map(|(a, b)| a.compare(b));
            let order = elements.fold(Ordering::Equal, Ordering::then).then(row.len().cmp(&other_row.len()));
            if order.is_ne() {
                return order;
            }
        }
        self.rows().cmp(&other.rows())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_row_prints_in_brackets() {
        assert_eq!(Array::from([0.0, 1.0, 2.0]).to_string(), "(3)[0,1,2]");
        assert_eq!(Array::from([false, false, true]).to_string(), "(3)[false,false,true]");
        assert_eq!(Array::from(["B", "", "D"].map(Text::fixed)).to_string(), "(3)[B,,D]");
        assert_eq!(Array::<f64>::default().to_string(), "(0)[]");
    }

    #[test]
    fn rows_print_below_each_other_in_columns() {
        // *array initialization function*.
        assert_eq!(Array::from(vec![vec![-1.0], vec![-2.0]]).to_string(), "(2x1)\n   -1\n   -2");
        let rows = [[-1.0, 0.0, 1.0, 2.0], [-2.0, 3.0, 3.0, 3.0], [0.0, 1.0, 2.0, -1.0], [3.0, 3.0, 3.0, -2.0]];
        let array = Array::from(rows.iter().map(|row| row.to_vec()).collect::<Vec<_>>());
        let lines = ["(4x4)", "   -1   0   1    2", "   -2   3   3    3", "    0   1   2   -1", "    3   3   3   -2"];
        assert_eq!(array.to_string(), lines.join("\n"));
        let wide = "ü".repeat(70_000);
        let array = Array::from(vec![vec![Text::from(wide.as_str())], vec![Text::fixed("x")]]);
        assert_eq!(array.to_string(), format!("(2x1)\n   {wide}\n   {}x", " ".repeat(69_999)));
    }

    #[test]
    fn rows_are_as_long_as_the_longest() {
        let array = Array::from(vec![vec![1.0, 2.0], vec![], vec![3.0]]);
        assert_eq!((array.rows(), array.columns(), array.len()), (3, 2, 6));
        assert_eq!(array.as_slice(), [1.0, 2.0, 0.0, 0.0, 3.0, 0.0]);
        assert_eq!(array.row(2), Some([3.0, 0.0].as_slice()));
        assert_eq!(
            (array.at(2, 0), array.at(0, 2), array.at(3, 0), array.get(1)),
            (Some(&3.0), None, None, Some(&2.0))
        );
        assert_eq!(array.iter_rows().map(<[f64]>::len).collect::<Vec<_>>(), [2, 2, 2]);
        assert_eq!(format!("{array:?}"), "[[1.0, 2.0], [0.0, 0.0], [3.0, 0.0]]");
    }

    #[test]
    fn nothing_is_nothing_however_it_came_to_be() {
        let empties = [Array::from(Vec::<f64>::new()), Array::from(vec![vec![], vec![]]), Array::new(vec![], 0, 7)];
        for empty in empties {
            assert_eq!((empty.rows(), empty.columns(), empty.len(), empty.row(0)), (0, 0, 0, None));
            assert_eq!(empty, Array::default());
            assert_eq!(empty.iter_rows().len(), 0);
        }
    }

    #[test]
    fn equal_needs_the_same_form() {
        assert_ne!(Array::from([1.0, 2.0]), Array::from(vec![vec![1.0], vec![2.0]]));
        assert_ne!(Array::from([f64::NAN]), Array::from([f64::NAN]));
    }
}
