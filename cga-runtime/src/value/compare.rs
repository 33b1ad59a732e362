//! One order for the values of every type.

use std::cmp::Ordering;

use super::text::Text;

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
