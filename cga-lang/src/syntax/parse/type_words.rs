//! The type names of other languages.

/// The type names of other languages.
const TYPES: &[&str] = &[
    "float", "double", "int", "number", "bool", "boolean", "string", "str", "String", "f32", "f64", "i32", "u32",
    "usize", "var", "let",
];

/// Returns true if a name before another name was meant as its type.
pub(super) fn is_type(word: &str) -> bool {
    TYPES.contains(&word)
}

/// Returns true if a word declares a variable in other languages.
pub(super) fn is_binding(word: &str) -> bool {
    matches!(word, "let" | "var")
}
