//! Which values an attribute may have.

use super::{Attribute, AttributeDefault, AttributeError};
use crate::fault::Error;
use crate::grammar::Grammar;
use crate::value::Value;
use crate::value::array::Array;
use crate::value::text::Text;

/// `@Range(min, max)`: what a slider may offer (*annotations*).
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Range {
    /// Smallest value.
    pub min: f64,
    /// Largest value.
    pub max: f64,
    /// Step of a slider, 0 when free.
    pub step: f64,
    /// Whether a run refuses values outside. What the host program sets is checked, of an array each element; what rules
    /// compute or `set` is not, and neither is a default.
    pub restricted: bool,
}

/// `@Enum(…)`: values to choose from (*annotations*). Of an array each element is one of them.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Choices {
    /// The values.
    pub values: ChoiceValues,
    /// What they are called in old files, as in `@Range(few = 1, many = 5)`; none, or one for each.
    pub labels: &'static [&'static str],
    /// Whether others are refused, as those outside of a [`Range`] are.
    pub restricted: bool,
}

/// The values of [`Choices`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum ChoiceValues {
    /// Numbers.
    Floats(&'static [f64]),
    /// Texts.
    Texts(&'static [&'static str]),
    /// The value of another attribute of that name, or the elements of its array. While it is to be computed for each
    /// initial shape nothing is refused.
    Attribute(&'static str),
}

impl Range {
    /// From the smallest to the largest value, in steps (0 when free); `restricted` when others are refused.
    pub const fn new(min: f64, max: f64, step: f64, restricted: bool) -> Self {
        Range { min, max, step, restricted }
    }

    /// Whether a number lies in it, restricted or not.
    pub fn contains(&self, number: f64) -> bool {
        self.min <= number && number <= self.max
    }
}

impl Choices {
    /// Values to choose from; `restricted` when others are refused.
    pub const fn new(values: ChoiceValues, restricted: bool) -> Self {
        Choices { values, labels: &[], restricted }
    }

    /// With names for the values.
    #[must_use]
    pub const fn labels(self, labels: &'static [&'static str]) -> Self {
        Choices { labels, ..self }
    }

    /// The values; of another attribute those it holds in that grammar, `None` while they are to be computed.
    pub fn of<G: Grammar + ?Sized>(&self, grammar: &G) -> Option<Vec<Value>> {
        match self.values {
            ChoiceValues::Floats(list) => Some(list.iter().map(|&number| Value::Float(number)).collect()),
            ChoiceValues::Texts(list) => Some(list.iter().map(|&text| Value::Text(Text::fixed(text))).collect()),
            ChoiceValues::Attribute(name) => grammar.get(name).ok().map(|value| elements(&value)),
        }
    }
}

impl Attribute {
    /// Whether some values of its type are refused.
    fn is_restricted(&self) -> bool {
        self.range.is_some_and(|range| range.restricted) || self.choices.is_some_and(|choices| choices.restricted)
    }

    /// Whether a value is its default. Old files have defaults that their annotations refuse: such a one is no mistake.
    fn is_default(&self, value: &Value) -> bool {
        fn same<T, U>(rows: &[&[T]], array: &Array<U>, equal: impl Fn(&T, &U) -> bool) -> bool {
            let columns = rows.first().map_or(0, |row| row.len());
            let fixed = rows.iter().copied().flatten();
            rows.len() == array.rows()
                && columns == array.columns()
                && fixed.zip(array.as_slice()).all(|(one, other)| equal(one, other))
        }
        match (self.default, value) {
            (AttributeDefault::Float(Some(default)), Value::Float(value)) => default == *value,
            (AttributeDefault::Text(Some(default)), Value::Text(value)) => default == value.as_str(),
            (AttributeDefault::Floats(Some(rows)), Value::Floats(array)) => {
                same(rows, array, |one, other| one == other)
            }
            (AttributeDefault::Texts(Some(rows)), Value::Texts(array)) => {
                same(rows, array, |one, other| *one == other.as_str())
            }
            _ => false,
        }
    }

    /// Whether a program may set it to a value, with the others as the grammar has them.
    pub(crate) fn allows<G: Grammar + ?Sized>(&self, value: &Value, grammar: &G) -> Result<(), AttributeError> {
        let name = self.name;
        if value.ty() != self.ty() {
            return Err(AttributeError::Type { name, wanted: self.ty(), got: value.ty() });
        }
        if !self.is_restricted() || self.is_default(value) {
            return Ok(());
        }
        let elements = elements(value);
        if let Some(range) = self.range.filter(|range| range.restricted) {
            for element in &elements {
                match *element {
                    Value::Float(value) if !range.contains(value) => {
                        return Err(AttributeError::Range { name, value, range });
                    }
                    _ => {}
                }
            }
        }
        let choices = self.choices.filter(|choices| choices.restricted);
        if let Some(choices) = choices.and_then(|choices| choices.of(grammar)) {
            for value in elements {
                if !choices.contains(&value) {
                    return Err(AttributeError::Choice { name, value, choices });
                }
            }
        }
        Ok(())
    }
}

/// The elements of an array; a single value is its own.
fn elements(value: &Value) -> Vec<Value> {
    match value {
        Value::Floats(array) => array.as_slice().iter().map(|&number| Value::Float(number)).collect(),
        Value::Bools(array) => array.as_slice().iter().map(|&truth| Value::Bool(truth)).collect(),
        Value::Texts(array) => array.as_slice().iter().map(|text| Value::Text(text.clone())).collect(),
        single => vec![single.clone()],
    }
}

/// Checks what the attributes of a grammar hold against what their annotations restrict. Used by generated code when a run
/// begins.
///
/// # Errors
/// [`Error::Attribute`] for the first that is refused.
pub fn check<G: Grammar + ?Sized>(grammar: &G) -> Result<(), Error> {
    for (index, attribute) in grammar.attributes().iter().enumerate() {
        if attribute.is_restricted()
            && let Some(value) = grammar.attribute_get(index)
        {
            let refused = |error: AttributeError| Error::Attribute { name: attribute.name, message: error.reason() };
            attribute.allows(&value, grammar).map_err(refused)?;
        }
    }
    Ok(())
}
