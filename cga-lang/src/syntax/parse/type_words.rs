//! The words that other languages have for types.

/// What other languages call the types of values.
const TYPES: &[&str] = &[
    "float", "double", "int", "number", "bool", "boolean", "string", "str", "String", "f32", "f64", "i32", "u32",
    "usize", "var", "let",
];

/// Whether a name before another one was meant as its type.
pub(super) fn is_type(word: &str) -> bool {
    TYPES.contains(&word)
}
