//! Numbers as rules print them.

use std::fmt;

/// A number as rules print it: without exponent and trailing zeros, at most 15 digits so that rounding noise stays out
/// of sight (*str function*: `1.69 - 0.69` is 1; *CGA changelog 2024.1*: one digit less than before, and pages of before
/// have 16).
pub(crate) struct Number(pub(crate) f64);

impl fmt::Display for Number {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let number = self.0;
        if number.is_nan() {
            return f.write_str("nan");
        }
        if number.is_infinite() {
            return f.write_str(if 0.0 < number { "inf" } else { "-inf" });
        }
        if number == 0.0 {
            return f.write_str("0");
        }
        // Small whole numbers, which are most, need no rounding.
        if number.abs() < 1e15 && number == number.trunc() {
            return write!(f, "{}", number as i64);
        }
        // Round in decimal, then print the shortest form of what that is. Beyond the largest number there is nothing to
        // round to.
        let rounded = format!("{number:.14e}").parse().ok().filter(|rounded: &f64| rounded.is_finite());
        write!(f, "{}", rounded.unwrap_or(number))
    }
}
