//! Attributes as fields of the generated struct, and their values in a run.

use super::lazy::Lazy;
use crate::value::Value;
use crate::value::array::Array;
use crate::value::text::Text;

/// A field that holds an attribute. Used by generated code.
pub trait Field: Sized {
    /// The value; `None` while it is computed for each initial shape.
    fn get(&self) -> Option<Value>;

    /// The field with a value, if the value has the type of the field.
    fn of(value: Value) -> Option<Self>;

    /// Sets the value, if it has the type of the field.
    fn set(&mut self, value: Value) {
        if let Some(field) = Self::of(value) {
            *self = field;
        }
    }
}

/// An attribute that a run has evaluated. Used by generated code.
pub trait Evaluated {
    /// The value; `None` if the run has no use for it.
    fn value(&self) -> Option<Value>;
}

impl<T: Evaluated> Evaluated for Lazy<T> {
    fn value(&self) -> Option<Value> {
        self.found()?.value()
    }
}

macro_rules! evaluated {
    ($($ty:ty)*) => {$(
        impl Evaluated for $ty {
            fn value(&self) -> Option<Value> {
                Some(self.clone().into())
            }
        }
    )*};
}

evaluated! { f64 bool Text Array<f64> Array<bool> Array<Text> }

macro_rules! fields {
    ($($field:ty => $variant:ident,)*) => {$(
        impl Field for $field {
            fn get(&self) -> Option<Value> {
                Some(Value::$variant(self.to_owned()))
            }

            fn of(value: Value) -> Option<Self> {
                if let Value::$variant(field) = value { Some(field) } else { None }
            }
        }
    )*};
}

fields! { f64 => Float, bool => Bool, Array<f64> => Floats, Array<bool> => Bools, Array<Text> => Texts, }

impl Field for String {
    fn get(&self) -> Option<Value> {
        Some(Value::from(self.as_str()))
    }

    fn of(value: Value) -> Option<Self> {
        if let Value::Text(text) = value { Some(text.as_str().to_owned()) } else { None }
    }
}

impl<F: Field> Field for Option<F> {
    fn get(&self) -> Option<Value> {
        self.as_ref()?.get()
    }

    fn of(value: Value) -> Option<Self> {
        F::of(value).map(Some)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_value_of_another_type_changes_nothing() {
        let (mut computed, mut set): (Option<f64>, Option<f64>) = (None, Some(3.0));
        computed.set(Value::Bool(true));
        set.set(Value::from("4"));
        assert_eq!((computed, set), (None, Some(3.0)));
        computed.set(Value::Float(5.0));
        assert_eq!(computed, Some(5.0));
    }
}
