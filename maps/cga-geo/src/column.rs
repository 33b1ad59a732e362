//! Values of columns.

use std::fmt;

use cga::{Value, ValueType};
use serde::{Deserialize, Serialize};

/// A value of a column, as a map file has it. A row without a value has no entry.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum ColumnValue {
    /// A number. Whole numbers beyond 2⁵³ are rounded.
    Number(f64),
    /// A truth value.
    Truth(bool),
    /// A text, or a list as JSON.
    Text(String),
}

impl ColumnValue {
    /// The value for an attribute of a type. Maps often have numbers as text. `None` if the value is not of that type.
    pub fn to_value(&self, ty: ValueType) -> Option<Value> {
        match (self, ty) {
            (ColumnValue::Number(number), ValueType::Float) => Some(Value::Float(*number)),
            (ColumnValue::Truth(truth), ValueType::Bool) => Some(Value::Bool(*truth)),
            // Shapefiles have truth values as 0 and 1.
            (ColumnValue::Number(number), ValueType::Bool) if *number == 0.0 || *number == 1.0 => {
                Some(Value::Bool(*number == 1.0))
            }
            (ColumnValue::Text(text), _) => Value::parse(text, ty),
            _ => Value::parse(&self.to_string(), ty),
        }
    }

    /// The value of an attribute as a column has it, so that equal values of several formats are equal.
    pub fn of_value(value: &Value) -> Self {
        match value {
            Value::Float(number) => ColumnValue::Number(*number),
            Value::Bool(truth) => ColumnValue::Truth(*truth),
            other => ColumnValue::Text(other.to_string()),
        }
    }
}

/// The value as text: whole numbers without a fraction.
impl fmt::Display for ColumnValue {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            ColumnValue::Number(number) => number.fmt(f),
            ColumnValue::Truth(truth) => truth.fmt(f),
            ColumnValue::Text(text) => f.write_str(text),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_have_the_type_of_the_attribute() {
        let number = ColumnValue::Number(12.0);
        assert_eq!(number.to_value(ValueType::Float), Some(Value::Float(12.0)));
        assert_eq!(number.to_value(ValueType::Text), Some(Value::from("12")));
        assert_eq!(number.to_value(ValueType::Bool), None);
        assert_eq!(ColumnValue::Number(1.0).to_value(ValueType::Bool), Some(Value::Bool(true)));
        assert_eq!(ColumnValue::Text(" 7.5 ".into()).to_value(ValueType::Float), Some(Value::Float(7.5)));
        assert_eq!(ColumnValue::Text("tall".into()).to_value(ValueType::Float), None);
        assert_eq!(ColumnValue::Truth(true).to_value(ValueType::Text), Some(Value::from("true")));
        let list = ColumnValue::Text("[1,2]".into()).to_value(ValueType::Floats);
        assert_eq!(list, Value::parse("[1, 2]", ValueType::Floats));
        assert!(list.is_some());
    }
}
