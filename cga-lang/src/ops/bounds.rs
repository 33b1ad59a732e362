//! The documented values of parameters.

use crate::diag::code::Code;

/// The documented values of a parameter.
#[derive(Debug, PartialEq)]
pub struct ParamBounds {
    /// The allowed values.
    pub values: Allowed,
    /// The allowed values in words, for a note.
    pub about: &'static str,
    /// The code for other values.
    pub code: Code,
    /// The documented result of other values. `None` if other values have no meaning.
    pub result: Option<&'static str>,
}

/// A set of values.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Allowed {
    /// The numbers between two numbers, inclusive.
    Between(f64, f64),
    /// The whole numbers between two numbers, inclusive.
    Whole(f64, f64),
    /// The numbers from a minimum, inclusive.
    AtLeast(f64),
    /// The numbers from a minimum, exclusive.
    Above(f64),
    /// The numbers between two numbers, exclusive.
    Inside(f64, f64),
    /// The numbers except 0 whose absolute value is below a number.
    Sloped(f64),
    /// Text with at least one character.
    NotEmpty,
    /// Text with characters that are not wildcards of tag queries.
    TagName,
    /// A query for tags.
    TagQuery,
}
