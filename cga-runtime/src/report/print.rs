//! What rules print, line by line.

use std::fmt;

use super::MOST_BYTES;
use crate::value::Value;

/// One thing printed. `to_string` is the line as the language prints it.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Print {
    /// The rule that printed it; empty for attributes and constants, which are evaluated before any rule runs.
    pub rule: &'static str,
    /// What it printed.
    pub value: Value,
}

impl fmt::Display for Print {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.value.fmt(f)
    }
}

/// The lines of a run, in its order.
#[derive(Clone, Debug, Default)]
pub(crate) struct Prints {
    pub(crate) list: Vec<Print>,
    bytes: usize,
    pub(crate) left_out: u64,
}

impl Prints {
    /// Adds a line. `false` when there was no room for it.
    pub(crate) fn add(&mut self, rule: &'static str, value: Value, limit: u64) -> bool {
        let bytes = match &value {
            Value::Text(text) => text.len(),
            Value::Floats(array) => size_of::<f64>() * array.len(),
            Value::Bools(array) => array.len(),
            Value::Texts(array) => array.as_slice().iter().map(|text| size_of_val(text) + text.len()).sum(),
            _ => 0,
        };
        let room = (self.list.len() as u64) < limit && self.bytes + bytes <= MOST_BYTES;
        if room {
            self.bytes += bytes;
            self.list.push(Print { rule, value });
        } else {
            self.left_out += 1;
        }
        room
    }
}
