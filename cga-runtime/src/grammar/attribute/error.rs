//! The reasons why an attribute cannot be read or set.

use crate::value::shown::shown;
use std::fmt;

use super::Range;
use crate::value::text::Text;
use crate::value::{Value, ValueType};

/// The reason why an attribute cannot be read or set by its name.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum AttributeError {
    /// No attribute has that name.
    Unknown {
        /// The requested name.
        name: String,
        /// The nearest name of an attribute, if one is near enough.
        near: Option<Text>,
        /// The names of the attributes, without hidden ones.
        known: Vec<Text>,
    },
    /// The attribute has no value before a run: its default is computed for each initial shape.
    Computed {
        /// The name of the attribute.
        name: Text,
    },
    /// The value has another type than the attribute.
    Type {
        /// The name of the attribute.
        name: Text,
        /// The type of the attribute.
        wanted: ValueType,
        /// The type of the value.
        got: ValueType,
    },
    /// The text cannot be read as a value of the attribute's type.
    Text {
        /// The name of the attribute.
        name: Text,
        /// The type of the attribute.
        wanted: ValueType,
        /// The text.
        text: String,
    },
    /// The values of all attributes are not a JSON object.
    #[cfg(feature = "serde")]
    Json {
        /// The problem, with its line and column.
        message: String,
    },
    /// The value, or an element of it, is outside of its restricted range.
    Range {
        /// The name of the attribute.
        name: Text,
        /// The number.
        value: f64,
        /// The range.
        range: Range,
    },
    /// The value, or an element of it, is not among its restricted choices.
    Choice {
        /// The name of the attribute.
        name: Text,
        /// The value or the element.
        value: Value,
        /// The choices.
        choices: Vec<Value>,
    },
}

impl AttributeError {
    /// The reason why a value is refused. It leaves out the attribute's name where the caller has written it already.
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
            AttributeError::Unknown { name, near, known } => {
                write!(f, "unknown attribute `{}`", shown(name))?;
                match near {
                    Some(near) => write!(f, "; did you mean `{near}`?"),
                    None if known.is_empty() => Ok(()),
                    None => write!(f, "; the attributes are {}", beginning(known.iter().map(Text::to_string))),
                }
            }
            AttributeError::Computed { name } => {
                write!(f, "attribute `{name}` is computed for each initial shape unless it is set")
            }
            AttributeError::Type { name, wanted, got } => {
                write!(f, "attribute `{name}` is {wanted}, and the value is {got}")
            }
            AttributeError::Text { name, wanted, text } => {
                write!(f, "attribute `{name}` is {wanted}, and `{}` is not", shown(text))
            }
            #[cfg(feature = "serde")]
            AttributeError::Json { message } => write!(f, "the values are not a JSON object: {message}"),
            AttributeError::Range { name, .. } | AttributeError::Choice { name, .. } => {
                write!(f, "attribute `{name}`: {}", self.reason())
            }
        }
    }
}

impl std::error::Error for AttributeError {}

/// The number of choices or attributes that a message names.
const NAMED: usize = 12;

fn not_among(value: &Value, choices: &[Value]) -> String {
    if choices.is_empty() {
        return format!("`{}` is not allowed: the list of choices is empty", shown(&value.to_string()));
    }
    let choices = choices.iter().map(|choice| shown(&choice.to_string()));
    format!("`{}` is not one of {}", shown(&value.to_string()), beginning(choices))
}

/// The beginning of a list of names.
fn beginning(mut names: impl Iterator<Item = String>) -> String {
    let first: Vec<String> = names.by_ref().take(NAMED).collect();
    let more = if names.next().is_some() { ", …" } else { "" };
    format!("{}{more}", first.join(", "))
}
