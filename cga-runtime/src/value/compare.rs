//! One order for the values of every type.

use std::cmp::Ordering;

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
