//! Numbers as rules print them.

use std::fmt;

/// A number as rules print it: without exponent and trailing zeros, with at most 15 digits to hide rounding noise (*str
/// function*: `1.69 - 0.69` is 1; *CGA changelog 2024.1*: one digit less than before, so older pages show 16).
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
        // Small whole numbers, the most frequent case, need no rounding.
        if number.abs() < 1e15 && number == number.trunc() {
            return write!(f, "{}", number as i64);
        }
        // Rounds in decimal, then prints the shortest form of the result. The rounded number may overflow to infinity;
        // then the number itself is printed.
        let rounded = format!("{number:.14e}").parse().ok().filter(|rounded: &f64| rounded.is_finite());
        write!(f, "{}", rounded.unwrap_or(number))
    }
}
