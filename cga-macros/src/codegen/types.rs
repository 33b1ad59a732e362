//! The Rust types of the language's types, and everything else that differs from type to type.

use cga_lang::ir::{Type, Value};
use proc_macro2::{Ident, Literal, TokenStream};
use quote::quote;

use super::hygienic;
use crate::location;

/// The Rust type of a value inside the rules. `runtime` is the path of the runtime there.
pub(super) fn inner(ty: Type, runtime: &TokenStream) -> TokenStream {
    match ty {
        Type::Float => code!(::core::primitive::f64),
        Type::Bool => code!(::core::primitive::bool),
        Type::Text => code!(#runtime::Text),
        Type::Floats | Type::Bools | Type::Texts => {
            let element = inner(ty.element(), runtime);
            code!(#runtime::Array<#element>)
        }
    }
}

/// The Rust type of a public field.
pub(super) fn outer(ty: Type, runtime: &TokenStream) -> TokenStream {
    match ty {
        Type::Text => code!(#runtime::String),
        ty => inner(ty, runtime),
    }
}

/// The variant of that type in the runtime's `Value` and `ValueType`.
pub(super) fn variant(ty: Type) -> Ident {
    let name = match ty {
        Type::Float => "Float",
        Type::Bool => "Bool",
        Type::Text => "Text",
        Type::Floats => "Floats",
        Type::Bools => "Bools",
        Type::Texts => "Texts",
    };
    hygienic(name)
}

/// A function of the runtime that exists for each type: `float_attribute` and so on.
pub(super) fn function(ty: Type, what: &str) -> Ident {
    hygienic(&format!("{}_{what}", variant(ty).to_string().to_lowercase()))
}

/// The value of a place: numbers and truth values are copied, the rest is shared.
pub(super) fn cloned(ty: Type, place: TokenStream) -> TokenStream {
    match ty {
        Type::Float | Type::Bool => place,
        _ => code!(::core::clone::Clone::clone(&#place)),
    }
}

/// A constant.
pub(super) fn value(value: &Value) -> TokenStream {
    match value {
        Value::Float(number) if number.is_nan() => code!(::core::primitive::f64::NAN),
        Value::Float(number) if number.is_infinite() && *number < 0.0 => {
            code!(::core::primitive::f64::NEG_INFINITY)
        }
        Value::Float(number) if number.is_infinite() => code!(::core::primitive::f64::INFINITY),
        Value::Float(number) => {
            let mut digits = Literal::f64_suffixed(number.abs());
            digits.set_span(location::current());
            if number.is_sign_negative() { code!((-#digits)) } else { quote!(#digits) }
        }
        Value::Bool(truth) => code!(#truth),
        Value::Text(text) => code!(cga_rt::Text::fixed(#text)),
        Value::Array(rows) => {
            let columns = rows.first().map_or(0, Vec::len);
            let elements = rows.iter().flatten().map(self::value);
            code!(cga_rt::array(#columns, [#(#elements),*]))
        }
    }
}

/// The default of a public field.
pub(super) fn field(known: &Value, runtime: &TokenStream) -> TokenStream {
    match known {
        Value::Text(text) => code!(#runtime::string(#text)),
        Value::Array(_) => {
            let known = value(known);
            code!({ use #runtime as cga_rt; #known })
        }
        known => value(known),
    }
}

/// As documentation shows it.
pub(super) fn show(value: &Value) -> String {
    match value {
        Value::Float(number) => number.to_string(),
        Value::Bool(truth) => truth.to_string(),
        Value::Text(text) => format!("{text:?}"),
        Value::Array(rows) => {
            let row = |row: &Vec<Value>| row.iter().map(show).collect::<Vec<_>>().join(", ");
            format!("[{}]", rows.iter().map(row).collect::<Vec<_>>().join("; "))
        }
    }
}

/// Stands for a value that is not known because the grammar has errors.
pub(super) fn nothing(ty: Option<Type>) -> Value {
    match ty {
        Some(Type::Bool) => Value::Bool(false),
        Some(Type::Text) => Value::Text(String::new()),
        Some(ty @ (Type::Floats | Type::Bools | Type::Texts)) => Value::Array(vec![vec![nothing(Some(ty.element()))]]),
        Some(Type::Float) | None => Value::Float(0.0),
    }
}
