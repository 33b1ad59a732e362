//! The values that an attribute may have.

use super::{Attribute, AttributeError};
use crate::fault::Error;
use crate::grammar::Grammar;
use crate::value::Value;
use crate::value::text::Text;

/// The range of `@Range(min, max)`, for the slider of a user interface (*annotations*).
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Range {
    /// The smallest value.
    pub min: f64,
    /// The largest value.
    pub max: f64,
    /// The step of a slider; 0 for any value.
    pub step: f64,
    /// True if a run refuses values outside of the range. Values of the host program are checked, for arrays each
    /// element. Defaults, and values that rules compute or `set`, are not checked.
    pub restricted: bool,
}

/// The choices of `@Enum(…)` (*annotations*). Each element of an array is one of them.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Choices {
    /// The values.
    pub values: ChoiceValues,
    /// The names of the values in old files, as in `@Range(few = 1, many = 5)`: empty, or one for each value.
    pub labels: Vec<Text>,
    /// True if a run refuses other values, under the conditions of [`Range::restricted`].
    pub restricted: bool,
}

/// The values of [`Choices`].
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum ChoiceValues {
    /// Numbers.
    Floats(Vec<f64>),
    /// Texts.
    Texts(Vec<Text>),
    /// The value of the attribute with that name, or the elements of its array. Every value is allowed while that
    /// attribute is computed for each initial shape.
    Attribute(Text),
}

impl Range {
    /// A range from `min` to `max` in steps of `step` (0 for any value). If `restricted`, other values are refused.
    pub const fn new(min: f64, max: f64, step: f64, restricted: bool) -> Self {
        Range { min, max, step, restricted }
    }

    /// Returns true if `min <= number <= max`, restricted or not.
    pub fn contains(&self, number: f64) -> bool {
        self.min <= number && number <= self.max
    }
}

impl Choices {
    /// The choices `values`. If `restricted`, other values are refused.
    pub fn new(values: ChoiceValues, restricted: bool) -> Self {
        Choices { values, labels: Vec::new(), restricted }
    }

    /// Adds names for the values.
    #[must_use]
    pub fn labels(self, labels: impl IntoIterator<Item = impl Into<Text>>) -> Self {
        Choices { labels: labels.into_iter().map(Into::into).collect(), ..self }
    }

    /// The values. For the values of another attribute, `None` while the grammar has no value of it.
    pub fn of<G: Grammar + ?Sized>(&self, grammar: &G) -> Option<Vec<Value>> {
        self.of_values(&|name| grammar.get(name).ok())
    }

    /// The values, with a function that has the values of attributes by name.
    pub(crate) fn of_values(&self, get: &dyn Fn(&str) -> Option<Value>) -> Option<Vec<Value>> {
        match &self.values {
            ChoiceValues::Floats(list) => Some(list.iter().map(|&number| Value::Float(number)).collect()),
            ChoiceValues::Texts(list) => Some(list.iter().map(|text| Value::Text(text.clone())).collect()),
            ChoiceValues::Attribute(name) => get(name).map(|value| elements(&value)),
        }
    }
}

impl Attribute {
    /// Returns true if some values of the attribute's type may be refused.
    fn is_restricted(&self) -> bool {
        self.range.is_some_and(|range| range.restricted)
            || self.choices.as_ref().is_some_and(|choices| choices.restricted)
    }

    /// Returns true if the value is the attribute's default. Old files have defaults that their annotations refuse.
    /// Setting such a default is not an error.
    fn is_default(&self, value: &Value) -> bool {
        self.default.as_ref() == Some(value)
    }

    /// Checks the type of a value.
    pub(crate) fn has_type_of(&self, value: &Value) -> Result<(), AttributeError> {
        let (wanted, got) = (self.ty, value.ty());
        if got == wanted { Ok(()) } else { Err(AttributeError::Type { name: self.name.clone(), wanted, got }) }
    }

    /// Checks whether the host program may set the attribute to a value. Choices may depend on other attributes, whose
    /// values `get` has by name.
    pub(crate) fn allows(&self, value: &Value, get: &dyn Fn(&str) -> Option<Value>) -> Result<(), AttributeError> {
        self.has_type_of(value)?;
        let name = || self.name.clone();
        if !self.is_restricted() || self.is_default(value) {
            return Ok(());
        }
        let elements = elements(value);
        if let Some(range) = self.range.filter(|range| range.restricted) {
            for element in &elements {
                match *element {
                    Value::Float(value) if !range.contains(value) => {
                        return Err(AttributeError::Range { name: name(), value, range });
                    }
                    _ => {}
                }
            }
        }
        let choices = self.choices.as_ref().filter(|choices| choices.restricted);
        if let Some(choices) = choices.and_then(|choices| choices.of_values(get)) {
            for value in elements {
                if !choices.contains(&value) {
                    return Err(AttributeError::Choice { name: name(), value, choices });
                }
            }
        }
        Ok(())
    }
}

/// The elements of an array; for a single value, the value.
fn elements(value: &Value) -> Vec<Value> {
    match value {
        Value::Floats(array) => array.as_slice().iter().map(|&number| Value::Float(number)).collect(),
        Value::Bools(array) => array.as_slice().iter().map(|&truth| Value::Bool(truth)).collect(),
        Value::Texts(array) => array.as_slice().iter().map(|text| Value::Text(text.clone())).collect(),
        single => vec![single.clone()],
    }
}

/// Checks the attributes of a grammar against their restricted ranges and choices. Generated code calls it when a run
/// begins.
///
/// # Errors
/// [`Error::Attribute`] for the first value that is refused.
pub fn check<G: Grammar + ?Sized>(grammar: &G) -> Result<(), Error> {
    let own = |index| grammar.attribute_get(index);
    check_all(grammar.attributes(), &own, &|name| grammar.get(name).ok())
}

/// Checks attributes with functions that have their values by index and by name.
fn check_all(
    attributes: &[Attribute],
    own: &dyn Fn(usize) -> Option<Value>,
    get: &dyn Fn(&str) -> Option<Value>,
) -> Result<(), Error> {
    for (index, attribute) in attributes.iter().enumerate() {
        if attribute.is_restricted()
            && let Some(value) = own(index)
        {
            let refused =
                |error: AttributeError| Error::Attribute { name: attribute.name.clone(), message: error.reason() };
            attribute.allows(&value, get).map_err(refused)?;
        }
    }
    Ok(())
}
