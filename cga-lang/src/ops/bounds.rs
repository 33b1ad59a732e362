//! The documented values of parameters.

use crate::diag::code::Code;

/// The documented values of a parameter.
#[derive(Debug, PartialEq)]
pub struct Bounds {
    /// The values that are allowed.
    pub values: Values,
    /// The allowed values in words, for a note.
    pub about: &'static str,
    /// The code for any other value.
    pub code: Code,
    /// The documented result of any other value. Without one the value has no meaning.
    pub result: Option<&'static str>,
}

/// A set of values.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Values {
    /// The numbers between two numbers, ends included.
    Between(f64, f64),
    /// The whole numbers between two numbers, ends included.
    Whole(f64, f64),
    /// The numbers from a number on.
    AtLeast(f64),
    /// The numbers above a number.
    Above(f64),
    /// Text with at least one character.
    NotEmpty,
}
