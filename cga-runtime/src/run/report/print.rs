//! The lines that rules print.

use std::fmt;

use super::quota::Quota;
use crate::geometry::small_sort::sort_owned_by;
use crate::value::Value;
use crate::value::text::Text;

/// One printed value. `to_string` is the line as the language prints it.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct Print {
    /// The rule that printed it; empty for attributes and constants, which are evaluated before any rule runs.
    pub rule: Text,
    /// The printed value.
    pub value: Value,
}

impl fmt::Display for Print {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.value.fmt(f)
    }
}

/// The lines of a run, collected in order of derivation.
///
/// The reference lists lines breadth first (*getTreeKey function*): by the depth of the shape in the tree of shapes,
/// lines of equal depth in order of derivation. The depth is the number of rules called from the start rule on:
///
/// - The start rule has depth 1, and each call of a rule adds 1.
/// - Blocks of `split` and `comp` belong to the shape of their rule, whose tree key "stays the same during derivation
///   of the whole rule". The same holds for conditions, sizes, selectors, arguments of calls, and functions that they
///   call.
/// - Attributes and constants are evaluated before the start rule and have depth 0. An import that is called with new
///   values evaluates its attributes again, at the depth of the rule that calls.
/// - A call that waits on the list of a run keeps the depth of its place in the tree.
///
/// The number of lines is limited while they are collected, so the first lines in order of derivation are kept.
#[derive(Clone, Debug, Default)]
pub(crate) struct Prints {
    /// Lines, each with the depth of its shape.
    lines: Vec<(usize, Print)>,
    pub(crate) quota: Quota,
}

impl Prints {
    /// Adds a line. Returns false if there was no room for it.
    pub(crate) fn add(&mut self, depth: usize, rule: Text, value: Value, limit: u64) -> bool {
        let bytes = match &value {
            Value::Text(text) => text.len(),
            Value::Floats(array) => size_of::<f64>() * array.len(),
            Value::Bools(array) => array.len(),
            Value::Texts(array) => array.as_slice().iter().map(|text| size_of_val(text) + text.len()).sum(),
            _ => 0,
        };
        let has_room = self.quota.take(bytes, limit);
        if has_room {
            self.lines.push((depth, Print { rule, value }));
        }
        has_room
    }

    /// The lines, breadth first.
    pub(crate) fn in_order(mut self) -> Vec<Print> {
        sort_owned_by(&mut self.lines, |a, b| a.0.cmp(&b.0));
        self.lines.into_iter().map(|(_, print)| print).collect()
    }
}
