//! One order for the values of every type.

use std::cmp::Ordering;

use super::array::{Array, Element};
use super::text::Text;

/// Values that the relational operators can compare.
pub trait Compare {
    /// The order of two values. The operators are derived from it: `a <= b` is "not greater".
    fn compare(&self, other: &Self) -> Ordering;

    /// Returns true if the value is not ordered: NaN.
    fn unordered(&self) -> bool {
        false
    }
}

impl Compare for f64 {
    /// NaN on either side gives "less", because compiled rules of the original compare in three ways and treat NaN so.
    /// So `<`, `<=` and `!=` are true and `==`, `>` and `>=` are false. Inferred, not documented.
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
    /// Character by character, by Unicode code point.
    fn compare(&self, other: &Self) -> Ordering {
        // Copies share their characters, so equal pointers need no comparison of long texts.
        if std::ptr::eq(self.as_str(), other.as_str()) { Ordering::Equal } else { self.cmp(other) }
    }
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
