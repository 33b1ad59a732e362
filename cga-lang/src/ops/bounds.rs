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
    /// The bounds in calls with one of these words.
    pub with_word: &'static [(&'static str, &'static ParamBounds)],
    /// The bounds of one element of an array, if they differ from those that at least one element has to meet.
    pub element: Option<&'static ParamBounds>,
}

impl ParamBounds {
    /// The bounds in a call. `word` returns true for the words of the call.
    pub fn in_call(&self, word: impl Fn(&str) -> bool) -> &ParamBounds {
        self.with_word.iter().find(|(own, _)| word(own)).map_or(self, |(_, bounds)| bounds)
    }

    /// The bounds of one element of an array.
    pub fn of_element(&self) -> &ParamBounds {
        self.element.unwrap_or(self)
    }
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
