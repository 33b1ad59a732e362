//! Why an attribute cannot be read or set.

use crate::value::text::shortened;
use std::fmt;

use super::Range;
use crate::value::{Value, ValueType};

/// Why an attribute cannot be read or set by its name.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum AttributeError {
    /// There is none of that name.
    Unknown {
        /// The name asked for.
        name: String,
        /// The name that was meant, perhaps.
        near: Option<&'static str>,
    },
    /// It has no value before a run: each initial shape has its own.
    Computed {
        /// Its name.
        name: &'static str,
    },
    /// The value is of another type.
    Type {
        /// Its name.
        name: &'static str,
        /// The type it has.
        wanted: ValueType,
        /// The type of the value.
        got: ValueType,
    },
    /// The text is no value of its type.
    Text {
        /// Its name.
        name: &'static str,
        /// The type it has.
        wanted: ValueType,
        /// The text.
        text: String,
    },
    /// The value, or an element of it, is outside of its range, which is restricted.
    Range {
        /// Its name.
        name: &'static str,
        /// The number.
        value: f64,
        /// The range.
        range: Range,
    },
    /// The value, or an element of it, is none of those to choose from, which are restricted.
    Choice {
        /// Its name.
        name: &'static str,
        /// The value or element.
        value: Value,
        /// Those to choose from.
        choices: Vec<Value>,
    },
}

impl AttributeError {
    /// Why the value is refused, without the attribute's name where that stands in front.
    pub(super) fn reason(&self) -> String {
        match self {
            AttributeError::Range { value, range, .. } => {
                format!("{value} is outside of {} to {}", range.min, range.max)
            }
            AttributeError::Choice { value, choices, .. } => not_among(value, choices),
            other => other.to_string(),
        }
    }
}

impl fmt::Display for AttributeError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            AttributeError::Unknown { name, near: None } => write!(f, "there is no attribute `{name}`"),
            AttributeError::Unknown { name, near: Some(near) } => {
                write!(f, "there is no attribute `{name}`; did you mean `{near}`?")
            }
            AttributeError::Computed { name } => {
                write!(f, "attribute `{name}` is computed for each initial shape, as long as it is not set")
            }
            AttributeError::Type { name, wanted, got } => {
                write!(f, "attribute `{name}` is {wanted}, and the value is {got}")
            }
            AttributeError::Text { name, wanted, text } => {
                write!(f, "attribute `{name}` is {wanted}, and `{text}` is not")
            }
            AttributeError::Range { name, .. } | AttributeError::Choice { name, .. } => {
                write!(f, "attribute `{name}`: {}", self.reason())
            }
        }
    }
}

impl std::error::Error for AttributeError {}

/// As many choices as a message names.
const NAMED: usize = 12;

fn not_among(value: &Value, choices: &[Value]) -> String {
    if choices.is_empty() {
        return format!("`{}` is not to be had, there is nothing to choose from", shortened(&value.to_string()));
    }
    let names: Vec<String> = choices.iter().take(NAMED).map(|choice| shortened(&choice.to_string())).collect();
    let more = if NAMED < choices.len() { ", …" } else { "" };
    format!("`{}` is none of {}{more}", shortened(&value.to_string()), names.join(", "))
}
