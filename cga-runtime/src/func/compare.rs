//! Comparisons: one order for all operators, and for values of every type.

use std::cmp::Ordering;

use crate::array::{Array, Element};
use crate::text::Text;

/// Values that the relational operators can compare.
pub trait Compare {
    /// The order of two values. The operators follow from it: `a <= b` is "not greater".
    fn compare(&self, other: &Self) -> Ordering;

    /// Whether it has no place in an order.
    fn unordered(&self) -> bool {
        false
    }
}

impl Compare for f64 {
    /// With something that is no number on either side the answer is "less": compiled rules of the original compare in
    /// three ways and treat it so. So `<`, `<=` and `!=` are true and `==`, `>` and `>=` are false. Inferred, not
    /// documented.
    #[inline]
    fn compare(&self, other: &Self) -> Ordering {
        self.partial_cmp(other).unwrap_or(Ordering::Less)
    }

    fn unordered(&self) -> bool {
        self.is_nan()
    }
}

impl Compare for bool {
    fn compare(&self, other: &Self) -> Ordering {
        self.cmp(other)
    }
}

impl Compare for Text {
    /// Character by character, by their numbers in Unicode.
    fn compare(&self, other: &Self) -> Ordering {
        // Copies share their characters, and long ones are not gone through.
        if std::ptr::eq(self.as_str(), other.as_str()) { Ordering::Equal } else { self.cmp(other) }
    }
}

impl<T: Element> Compare for Array<T> {
    /// Element by element, row by row. When the first rows are equal as far as both go, the array with fewer columns is
    /// less; when all rows that both have are equal, the one with fewer rows (*Array types operators*).
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

/// `a == b`. Arrays are equal if they have the same form and equal elements.
#[inline]
pub fn equal<T: Compare>(a: T, b: T) -> bool {
    a.compare(&b).is_eq()
}

/// `a != b`.
#[inline]
pub fn unequal<T: Compare>(a: T, b: T) -> bool {
    a.compare(&b).is_ne()
}

/// `a < b`.
#[inline]
pub fn less<T: Compare>(a: T, b: T) -> bool {
    a.compare(&b).is_lt()
}

/// `a <= b`.
#[inline]
pub fn less_equal<T: Compare>(a: T, b: T) -> bool {
    a.compare(&b).is_le()
}

/// `a > b`.
#[inline]
pub fn greater<T: Compare>(a: T, b: T) -> bool {
    a.compare(&b).is_gt()
}

/// `a >= b`.
#[inline]
pub fn greater_equal<T: Compare>(a: T, b: T) -> bool {
    a.compare(&b).is_ge()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn column(values: &[&'static str]) -> Array<Text> {
        Array::from(values.iter().map(|&value| vec![Text::fixed(value)]).collect::<Vec<_>>())
    }

    #[test]
    fn fact_80_arrays_are_compared_row_by_row() {
        // *Array types operators*.
        let row = |values: &[f64]| Array::from(values.to_vec());
        let down = Array::from(vec![vec![1.0], vec![2.0]]);
        assert!(!equal(row(&[1.0, 2.0]), down.clone()) && unequal(row(&[1.0, 2.0]), down));
        assert!(less(row(&[1.0, 2.0]), row(&[1.0, 3.0])) && greater(row(&[1.0, 3.0]), row(&[1.0, 2.0])));
        assert!(!less_equal(column(&["a", "b"]), column(&["a"])) && greater(column(&["a", "b"]), column(&["a"])));
        assert!(greater_equal(column(&["a", "b"]), column(&["a", "b"])));
        assert!(greater_equal(row(&[1.0, 2.0, 3.0]), row(&[1.0, 2.0])));
        // Fewer columns decide before the second rows are looked at.
        let wide = Array::from(vec![vec![1.0, 2.0], vec![0.0, 0.0]]);
        let narrow = Array::from(vec![vec![1.0], vec![9.0]]);
        assert!(less(narrow, wide));
        assert!(less(Array::default(), row(&[-1.0])) && equal(Array::<f64>::default(), Array::default()));
        assert!(unequal(Array::from([true, true]), Array::from([true, false])));
    }

    #[test]
    fn no_number_is_less_and_not_equal() {
        let none = f64::NAN;
        for (a, b) in [(none, 1.0), (1.0, none), (none, none)] {
            assert!(less(a, b) && less_equal(a, b) && unequal(a, b));
            assert!(!equal(a, b) && !greater(a, b) && !greater_equal(a, b));
            assert!(less(Array::from([a]), Array::from([b])) && unequal(Array::from([a]), Array::from([b])));
        }
        assert!(equal(0.0, -0.0) && less(f64::NEG_INFINITY, f64::INFINITY));
    }

    #[test]
    fn text_is_compared_by_characters() {
        assert!(less(Text::fixed("abc"), Text::fixed("abd")) && less(Text::fixed("ab"), Text::fixed("abc")));
        assert!(less(Text::fixed("Z"), Text::fixed("a")) && greater(Text::fixed("ä"), Text::fixed("z")));
    }
}
