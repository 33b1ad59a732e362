//! Values of expressions that are neither numbers nor truth values.

use cga_lang::ir::{self, Type};
use cga_runtime::rt::{Array, File, Files, Text, Value};

/// A text, an array, or the name of a file.
#[derive(Clone, Debug)]
pub(crate) enum Object {
    Text(Text),
    Floats(Array<f64>),
    Bools(Array<bool>),
    Texts(Array<Text>),
    File(Box<File>),
    Files(Box<Files>),
}

/// Returns true if values of the type are numbers on the stack.
pub(crate) fn is_number(ty: Type) -> bool {
    matches!(ty, Type::Float | Type::Bool)
}

impl Object {
    /// The value without elements or characters.
    pub(crate) fn empty(ty: Type) -> Self {
        match ty {
            Type::Floats => Object::Floats(Array::default()),
            Type::Bools => Object::Bools(Array::default()),
            Type::Texts => Object::Texts(Array::default()),
            Type::Float | Type::Bool | Type::Text => Object::Text(Text::default()),
        }
    }

    /// The bytes of a text, or the elements of an array.
    pub(crate) fn size(&self) -> usize {
        match self {
            Object::Text(text) => text.len(),
            Object::Floats(array) => array.len(),
            Object::Bools(array) => array.len(),
            Object::Texts(array) => array.len(),
            Object::File(_) | Object::Files(_) => 0,
        }
    }

    /// The value as the runtime has it. A file has none.
    pub(crate) fn into_value(self) -> Option<Value> {
        Some(match self {
            Object::Text(text) => Value::Text(text),
            Object::Floats(array) => Value::Floats(array),
            Object::Bools(array) => Value::Bools(array),
            Object::Texts(array) => Value::Texts(array),
            Object::File(_) | Object::Files(_) => return None,
        })
    }
}

/// The default of a type: 0, false or empty.
pub(crate) fn nothing(ty: Type) -> Value {
    match ty {
        Type::Float => Value::Float(0.0),
        Type::Bool => Value::Bool(false),
        Type::Text => Value::Text(Text::default()),
        Type::Floats => Value::Floats(Array::default()),
        Type::Bools => Value::Bools(Array::default()),
        Type::Texts => Value::Texts(Array::default()),
    }
}

/// A constant of the rules.
pub(crate) fn constant(value: &ir::Value) -> Value {
    match value {
        ir::Value::Float(number) => Value::Float(*number),
        ir::Value::Bool(truth) => Value::Bool(*truth),
        ir::Value::Text(text) => Value::Text(Text::from(text.as_str())),
        ir::Value::Array(rows) => match rows.first().and_then(|row| row.first()) {
            Some(ir::Value::Bool(_)) => Value::Bools(array(rows, |value| matches!(value, ir::Value::Bool(true)))),
            Some(ir::Value::Text(_)) => Value::Texts(array(rows, |value| match value {
                ir::Value::Text(text) => Text::from(text.as_str()),
                _ => Text::default(),
            })),
            _ => Value::Floats(array(rows, |value| if let ir::Value::Float(number) = value { *number } else { 0.0 })),
        },
    }
}

fn array<T>(rows: &[Vec<ir::Value>], element: impl Fn(&ir::Value) -> T) -> Array<T>
where
    Array<T>: From<Vec<Vec<T>>>,
{
    Array::from(rows.iter().map(|row| row.iter().map(&element).collect()).collect::<Vec<Vec<T>>>())
}
