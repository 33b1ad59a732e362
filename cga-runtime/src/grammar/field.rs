//! Attributes as fields of the generated struct.

use crate::value::Value;
use crate::value::array::Array;
use crate::value::text::Text;

/// A field that holds an attribute. Used by generated code.
pub trait Field {
    /// The value; `None` while it is computed for each initial shape.
    fn get(&self) -> Option<Value>;
    /// Sets the value, if it has the type of the field.
    fn set(&mut self, value: Value);
}

impl Field for f64 {
    fn get(&self) -> Option<Value> {
        Some(Value::Float(*self))
    }

    fn set(&mut self, value: Value) {
        if let Value::Float(number) = value {
            *self = number;
        }
    }
}

impl Field for bool {
    fn get(&self) -> Option<Value> {
        Some(Value::Bool(*self))
    }

    fn set(&mut self, value: Value) {
        if let Value::Bool(truth) = value {
            *self = truth;
        }
    }
}

impl Field for String {
    fn get(&self) -> Option<Value> {
        Some(Value::from(self.as_str()))
    }

    fn set(&mut self, value: Value) {
        if let Value::Text(text) = value {
            text.as_str().clone_into(self);
        }
    }
}

macro_rules! arrays {
    ($($item:ty => $variant:ident,)*) => {$(
        impl Field for Array<$item> {
            fn get(&self) -> Option<Value> {
                Some(Value::$variant(self.clone()))
            }

            fn set(&mut self, value: Value) {
                if let Value::$variant(array) = value {
                    *self = array;
                }
            }
        }
    )*};
}

arrays! { f64 => Floats, bool => Bools, Text => Texts, }

impl<F: Field + std::default::Default> Field for Option<F> {
    fn get(&self) -> Option<Value> {
        self.as_ref()?.get()
    }

    fn set(&mut self, value: Value) {
        self.get_or_insert_default().set(value);
    }
}
