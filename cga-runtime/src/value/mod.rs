//! Values of the language as data: the values of attributes, and the values that rules print.

pub mod array;
pub(crate) mod compare;
pub(crate) mod number;
pub(crate) mod pattern;
pub(crate) mod read;
#[cfg(feature = "serde")]
mod serde;
pub(crate) mod shown;
pub mod text;

use std::fmt;

use self::number::Number;
use crate::value::array::{Array, Element};
use crate::value::text::Text;

/// A value of the language. Variants may be added.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Value {
    /// A number.
    Float(f64),
    /// A truth value.
    Bool(bool),
    /// Text.
    Text(Text),
    /// An array of numbers.
    Floats(Array<f64>),
    /// An array of truth values.
    Bools(Array<bool>),
    /// An array of texts.
    Texts(Array<Text>),
}

/// The type of a [`Value`]. Variants may be added.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum ValueType {
    /// A number.
    Float,
    /// A truth value.
    Bool,
    /// Text.
    Text,
    /// An array of numbers.
    Floats,
    /// An array of truth values.
    Bools,
    /// An array of texts.
    Texts,
}

impl ValueType {
    /// The name of the type for machines, in CGA's words: `float`, `bool`, `string`, `float[]`, `bool[]` or `string[]`.
    pub const fn name(self) -> &'static str {
        match self {
            ValueType::Float => "float",
            ValueType::Bool => "bool",
            ValueType::Text => "string",
            ValueType::Floats => "float[]",
            ValueType::Bools => "bool[]",
            ValueType::Texts => "string[]",
        }
    }
}

impl Value {
    /// The type of the value.
    pub fn ty(&self) -> ValueType {
        match self {
            Value::Float(_) => ValueType::Float,
            Value::Bool(_) => ValueType::Bool,
            Value::Text(_) => ValueType::Text,
            Value::Floats(_) => ValueType::Floats,
            Value::Bools(_) => ValueType::Bools,
            Value::Texts(_) => ValueType::Texts,
        }
    }

    /// Returns true for values with the same type, shape and bits.
    pub(crate) fn is_same(&self, other: &Value) -> bool {
        match (self, other) {
            (Value::Float(own), Value::Float(other)) => own.to_bits() == other.to_bits(),
            (Value::Floats(own), Value::Floats(other)) => {
                let bits =
                    |array: &Array<f64>| array.as_slice().iter().map(|number| number.to_bits()).collect::<Vec<_>>();
                own.rows() == other.rows() && bits(own) == bits(other)
            }
            _ => self == other,
        }
    }

    /// Parses a value as a user types it. Unlike the language's own conversions it accepts no partial match: a number
    /// is the whole text except surrounding space (`nan` and `inf` are numbers, and `1e999`, which no number holds, is none), and a truth
    /// value is `true` or `false`. Text is taken as it is, without quotes. Arrays are written as in rules, with or without their brackets:
    /// `[1, 2; 3, 4]`, `["a", "b"]`; `[]` has no elements.
    pub fn parse(text: &str, ty: ValueType) -> Option<Value> {
        match ty {
            ValueType::Float => number(text.trim()).map(Value::Float),
            ValueType::Bool => text.trim().parse().ok().map(Value::Bool),
            ValueType::Text => Some(Value::Text(Text::from(text))),
            ValueType::Floats => array(text, number).map(Value::Floats),
            ValueType::Bools => array(text, |entry| entry.parse().ok()).map(Value::Bools),
            ValueType::Texts => array(text, quoted).map(Value::Texts),
        }
    }
}

/// The value as the language prints it (*print operation*, *str function*): numbers with at most 15 digits, text
/// without quotes.
impl fmt::Display for Value {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Value::Float(number) => Number(*number).fmt(f),
            Value::Bool(truth) => truth.fmt(f),
            Value::Text(text) => f.write_str(text),
            Value::Floats(array) => array.fmt(f),
            Value::Bools(array) => array.fmt(f),
            Value::Texts(array) => array.fmt(f),
        }
    }
}

impl fmt::Display for ValueType {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            ValueType::Float => "a number",
            ValueType::Bool => "true or false",
            ValueType::Text => "text",
            ValueType::Floats => "an array of numbers",
            ValueType::Bools => "an array of truth values",
            ValueType::Texts => "an array of texts",
        })
    }
}

/// Parses a number. Only a word is infinite: JSON refuses digits beyond the range of numbers too.
fn number(text: &str) -> Option<f64> {
    let number: f64 = text.parse().ok()?;
    (number.is_finite() || !text.contains(|c: char| c.is_ascii_digit())).then_some(number)
}

/// Parses `[a, b; c, d]`. All rows must have the same length.
fn array<T: Element>(text: &str, read: impl Fn(&str) -> Option<T>) -> Option<Array<T>> {
    let text = text.trim();
    let inner = text.strip_prefix('[').and_then(|text| text.strip_suffix(']')).unwrap_or(text).trim();
    if inner.is_empty() {
        return Some(Array::default());
    }
    let mut rows: Vec<Vec<T>> = vec![Vec::new()];
    let (mut start, mut inside, mut escaped) = (0, false, false);
    for (at, sign) in inner.char_indices().chain([(inner.len(), ';')]) {
        match sign {
            _ if escaped => escaped = false,
            '\\' if inside => escaped = true,
            '"' => inside = !inside,
            ',' | ';' if !inside || at == inner.len() => {
                rows.last_mut()?.push(read(inner[start..at].trim())?);
                start = at + 1;
                if sign == ';' && at < inner.len() {
                    rows.push(Vec::new());
                }
            }
            _ => {}
        }
    }
    let columns = rows[0].len();
    (!inside && rows.iter().all(|row| row.len() == columns)).then(|| Array::from(rows))
}

/// Parses `"text"`, in which a backslash escapes quotes and backslashes.
fn quoted(text: &str) -> Option<Text> {
    let inner = text.strip_prefix('"')?.strip_suffix('"')?;
    let mut out = String::with_capacity(inner.len());
    let mut signs = inner.chars();
    while let Some(sign) = signs.next() {
        match sign {
            '"' => return None,
            '\\' => out.push(signs.next()?),
            sign => out.push(sign),
        }
    }
    Some(Text::from(out))
}

macro_rules! from_values {
    ($($ty:ty => $variant:ident,)*) => {$(
        impl From<$ty> for Value {
            fn from(value: $ty) -> Self {
                Value::$variant(value.into())
            }
        }
    )*};
}

from_values! {
    f64 => Float,
    f32 => Float,
    i32 => Float,
    u32 => Float,
    bool => Bool,
    Text => Text,
    &str => Text,
    String => Text,
    Array<f64> => Floats,
    Array<bool> => Bools,
    Array<Text> => Texts,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_value_is_read_whole_or_not_at_all() {
        let float = |text| Value::parse(text, ValueType::Float);
        assert_eq!((float("inf"), float("-1e999")), (Some(f64::INFINITY.into()), None));
        assert_eq!(Value::parse("[1, 1e999]", ValueType::Floats), None);
        assert_eq!(float(" -2.5 "), Some(Value::Float(-2.5)));
        assert_eq!((float("5+6"), float(""), float("2 m"), float("ⅷ")), (None, None, None, None));
        assert!(matches!(float("nan"), Some(Value::Float(number)) if number.is_nan()));
        assert_eq!(Value::parse("true", ValueType::Bool), Some(true.into()));
        assert_eq!(Value::parse("f", ValueType::Bool), None);
        assert_eq!(Value::parse(" a", ValueType::Text), Some(" a".into()));
    }

    #[test]
    fn arrays_are_read_as_rules_write_them() {
        let floats = |text| Value::parse(text, ValueType::Floats);
        assert_eq!(floats("[1, 2; 3, -4.5]"), Some(Array::from(vec![vec![1.0, 2.0], vec![3.0, -4.5]]).into()));
        assert_eq!(
            (floats("1,2"), floats(" [] ")),
            (Some(Array::from([1.0, 2.0]).into()), Some(Array::<f64>::default().into()))
        );
        for wrong in ["[1,,2]", "[1;2,3]", "[1", "1]", ",", "[a]", "[1,]"] {
            assert_eq!(floats(wrong), None, "{wrong}");
        }
        assert_eq!(
            Value::parse("true; false", ValueType::Bools),
            Some(Array::from(vec![vec![true], vec![false]]).into())
        );
        let texts = |text| Value::parse(text, ValueType::Texts);
        let expected = Array::from([Text::from("a, b"), Text::from("\"\\;")]);
        assert_eq!(texts(r#"["a, b", "\"\\;"]"#), Some(expected.into()));
        assert_eq!((texts("[a]"), texts(r#"["a"b"]"#), texts(r#"["a]"#)), (None, None, None));
    }

    #[test]
    fn what_is_shown_is_read_back() {
        for value in [Value::from(0.1 + 0.2), Value::from(-1e300), false.into(), "é\n".into()] {
            let back = Value::parse(&value.to_string(), value.ty()).expect("it was shown");
            assert_eq!(back.to_string(), value.to_string());
        }
    }
}
