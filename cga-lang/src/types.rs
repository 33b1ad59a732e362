//! The types of values.

/// The type of a value.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Type {
    /// A 64-bit float; CGA has no integers.
    Float,
    /// A truth value.
    Bool,
    /// Text.
    Text,
    /// An array of floats, in rows.
    Floats,
    /// An array of truth values, in rows.
    Bools,
    /// An array of text, in rows.
    Texts,
}

impl Type {
    /// Every type.
    pub const ALL: [Type; 6] = [Type::Float, Type::Bool, Type::Text, Type::Floats, Type::Bools, Type::Texts];

    /// In CGA's words.
    pub const fn word(self) -> &'static str {
        match self {
            Type::Float => "float",
            Type::Bool => "bool",
            Type::Text => "string",
            Type::Floats => "float[]",
            Type::Bools => "bool[]",
            Type::Texts => "string[]",
        }
    }

    /// Returns true for an array.
    pub const fn is_array(self) -> bool {
        matches!(self, Type::Floats | Type::Bools | Type::Texts)
    }

    /// The type of an array's elements; a type that is not an array is its own element.
    pub const fn element(self) -> Type {
        match self {
            Type::Float | Type::Floats => Type::Float,
            Type::Bool | Type::Bools => Type::Bool,
            Type::Text | Type::Texts => Type::Text,
        }
    }

    /// An array of it; itself when it is one.
    pub const fn array(self) -> Type {
        match self.element() {
            Type::Bool => Type::Bools,
            Type::Text => Type::Texts,
            _ => Type::Floats,
        }
    }
}
