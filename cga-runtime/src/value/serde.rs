//! Values for `serde`: numbers, truth values, texts, and arrays as lists.
//!
//! An array with one row is a list of its elements, any other array a list of its rows. Numbers that JSON does not have
//! are the texts `NaN`, `inf` and `-inf`.

use std::fmt;

use serde::de::{self, Deserializer, Visitor};
use serde::ser::Serializer;
use serde::{Deserialize, Serialize};

use crate::value::array::{Array, Element};
use crate::value::text::Text;
use crate::value::{Value, ValueType};

/// A number that may be infinite or NaN.
#[derive(Clone, Copy)]
struct AnyNumber(f64);

impl Serialize for AnyNumber {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        if self.0.is_finite() { serializer.serialize_f64(self.0) } else { serializer.collect_str(&self.0) }
    }
}

impl<'de> Deserialize<'de> for AnyNumber {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Numbers;
        impl Visitor<'_> for Numbers {
            type Value = AnyNumber;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a number, \"NaN\", \"inf\" or \"-inf\"")
            }

            fn visit_f64<E: de::Error>(self, number: f64) -> Result<AnyNumber, E> {
                Ok(AnyNumber(number))
            }

            fn visit_i64<E: de::Error>(self, number: i64) -> Result<AnyNumber, E> {
                Ok(AnyNumber(number as f64))
            }

            fn visit_u64<E: de::Error>(self, number: u64) -> Result<AnyNumber, E> {
                Ok(AnyNumber(number as f64))
            }

            fn visit_str<E: de::Error>(self, text: &str) -> Result<AnyNumber, E> {
                match text {
                    "NaN" => Ok(AnyNumber(f64::NAN)),
                    "inf" => Ok(AnyNumber(f64::INFINITY)),
                    "-inf" => Ok(AnyNumber(f64::NEG_INFINITY)),
                    _ => Err(E::invalid_value(de::Unexpected::Str(text), &self)),
                }
            }
        }
        deserializer.deserialize_any(Numbers)
    }
}

impl Serialize for Text {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self)
    }
}

impl<'de> Deserialize<'de> for Text {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        String::deserialize(deserializer).map(Text::from)
    }
}

/// The elements of an array as they are written.
#[derive(Serialize, Deserialize)]
#[serde(untagged)]
enum Lists<T> {
    Elements(Vec<T>),
    Rows(Vec<Vec<T>>),
}

impl<T> Lists<T> {
    fn of<U: Element>(array: &Array<U>, element: impl Fn(&U) -> T) -> Self {
        if array.rows() <= 1 {
            return Lists::Elements(array.as_slice().iter().map(element).collect());
        }
        let rows = array.as_slice().chunks(array.columns().max(1));
        Lists::Rows(rows.map(|row| row.iter().map(&element).collect()).collect())
    }

    fn array<U: Element, E: de::Error>(self, element: impl Fn(T) -> U) -> Result<Array<U>, E> {
        match self {
            Lists::Elements(list) => Ok(Array::from(list.into_iter().map(element).collect::<Vec<U>>())),
            Lists::Rows(rows) => {
                if rows.windows(2).any(|pair| pair[0].len() != pair[1].len()) {
                    return Err(E::custom("the rows of an array have the same length"));
                }
                Ok(Array::from(
                    rows.into_iter().map(|row| row.into_iter().map(&element).collect()).collect::<Vec<Vec<U>>>(),
                ))
            }
        }
    }
}

macro_rules! arrays {
    ($($element:ty => $written:ty, $write:expr, $read:expr;)*) => {$(
        impl Serialize for Array<$element> {
            fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
                Lists::<$written>::of(self, $write).serialize(serializer)
            }
        }

        impl<'de> Deserialize<'de> for Array<$element> {
            fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
                Lists::<$written>::deserialize(deserializer)?.array($read)
            }
        }
    )*};
}

arrays! {
    f64 => AnyNumber, |&number| AnyNumber(number), |AnyNumber(number)| number;
    bool => bool, |&truth| truth, |truth| truth;
    Text => Text, Text::clone, |text| text;
}

impl Serialize for ValueType {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.name())
    }
}

impl Serialize for Value {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Value::Float(number) => AnyNumber(*number).serialize(serializer),
            Value::Bool(truth) => serializer.serialize_bool(*truth),
            Value::Text(text) => text.serialize(serializer),
            Value::Floats(array) => array.serialize(serializer),
            Value::Bools(array) => array.serialize(serializer),
            Value::Texts(array) => array.serialize(serializer),
        }
    }
}

/// Without the type of an attribute, an empty list has numbers, and `"NaN"` is text.
impl<'de> Deserialize<'de> for Value {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        #[derive(Deserialize)]
        #[serde(untagged, expecting = "a number, a truth value, a text, or a list or rows of one of these")]
        enum Any {
            Bool(bool),
            Float(f64),
            Text(Text),
            Floats(Lists<f64>),
            Bools(Lists<bool>),
            Texts(Lists<Text>),
        }
        Ok(match Any::deserialize(deserializer)? {
            Any::Bool(truth) => Value::Bool(truth),
            Any::Float(number) => Value::Float(number),
            Any::Text(text) => Value::Text(text),
            Any::Floats(lists) => Value::Floats(lists.array(|number| number)?),
            Any::Bools(lists) => Value::Bools(lists.array(|truth| truth)?),
            Any::Texts(lists) => Value::Texts(lists.array(|text| text)?),
        })
    }
}

impl Value {
    /// The value of a known type.
    pub(crate) fn of_type<'de, D: Deserializer<'de>>(ty: ValueType, deserializer: D) -> Result<Value, D::Error> {
        Ok(match ty {
            ValueType::Float => Value::Float(AnyNumber::deserialize(deserializer)?.0),
            ValueType::Bool => Value::Bool(bool::deserialize(deserializer)?),
            ValueType::Text => Value::Text(Text::deserialize(deserializer)?),
            ValueType::Floats => Value::Floats(Array::deserialize(deserializer)?),
            ValueType::Bools => Value::Bools(Array::deserialize(deserializer)?),
            ValueType::Texts => Value::Texts(Array::deserialize(deserializer)?),
        })
    }
}
