//! Numbers in messages.

use crate::analysis::interval::Interval;
use crate::ops::MOST_SIZE;

/// A number in a message.
pub(crate) fn shown(number: f64) -> String {
    let rounded = (number * 1e6).round() / 1e6;
    // Very small and very large numbers keep their exponent. The sum removes the sign of zero.
    let is_far = rounded == 0.0 && number != 0.0 || 1e15 < number.abs();
    if is_far { format!("{number:e}") } else { format!("{}", rounded + 0.0) }
}

/// A bound in a message, without the digits that rounding may add.
pub(crate) fn about(number: f64) -> String {
    shown((number * 1e4).round() / 1e4)
}

/// Returns true if an end of an interval is a bound for messages: no size is larger.
pub(crate) fn is_bound(end: f64) -> bool {
    end.abs() <= MOST_SIZE
}

/// An interval in a message: "3", "between 3 and 60", "3 or more".
pub(crate) fn range(of: Interval) -> String {
    match (of.lo == of.hi, is_bound(of.lo), is_bound(of.hi)) {
        (true, ..) => shown(of.lo),
        (false, true, true) if shown(of.lo) == shown(of.hi) => format!("about {}", shown(of.lo)),
        (false, true, true) => format!("between {} and {}", shown(of.lo), shown(of.hi)),
        (false, true, false) => format!("{} or more", shown(of.lo)),
        (false, false, true) => format!("{} or less", shown(of.hi)),
        (false, false, false) => "any number".into(),
    }
}
