//! The parts of JSON that a writer with a fixed order of keys needs.

use std::fmt::Write as _;

use crate::output::number_text::Short;
use crate::value::Value;

/// A string with its quotes, escaped.
pub(super) fn quoted(text: &str) -> String {
    let mut json = String::with_capacity(text.len() + 2);
    json.push('"');
    for c in text.chars() {
        match c {
            '"' => json.push_str("\\\""),
            '\\' => json.push_str("\\\\"),
            c if c < ' ' => {
                let _ = write!(json, "\\u{:04x}", c as u32);
            }
            c => json.push(c),
        }
    }
    json.push('"');
    json
}

/// A value of a grammar. A number that is not finite is null.
pub(super) fn value(value: &Value) -> String {
    let number = |value: &f64| if value.is_finite() { Short(*value).to_string() } else { "null".to_owned() };
    let list = |items: Vec<String>| format!("[{}]", items.join(","));
    match value {
        Value::Float(value) => number(value),
        Value::Bool(value) => value.to_string(),
        Value::Text(text) => quoted(text),
        Value::Floats(array) => list(array.as_slice().iter().map(number).collect()),
        Value::Bools(array) => list(array.as_slice().iter().map(ToString::to_string).collect()),
        Value::Texts(array) => list(array.as_slice().iter().map(|text| quoted(text)).collect()),
    }
}

/// The members of an object or elements of an array, separated by commas.
pub(super) fn joined(items: impl IntoIterator<Item = String>) -> String {
    items.into_iter().collect::<Vec<_>>().join(",")
}
