//! The values of lots, in the place of the values of their grammars.

use crate::fault::{Error, Fault, FaultKind};
use crate::grammar::Grammar;
use crate::grammar::attribute::{self, AttributeError};
use crate::run::settings::WrongLots;
use crate::shape::Shape;
use crate::shape::lot::Lot;
use crate::value::Value;
use crate::value::text::Text;

/// Sets the attributes that a lot has. Returns what is wrong; such attributes keep the value of the grammar.
pub(crate) fn set_values(grammar: &mut dyn Grammar, lot: &Lot) -> Vec<String> {
    let mut problems = Vec::new();
    let mut changes = Vec::new();
    for (name, value) in &lot.attributes {
        match place_of(grammar, name, value) {
            Ok(index) => changes.push((index, value)),
            Err(error) => problems.push(error.to_string()),
        }
    }
    // Choices may be values of other attributes, so all are set before they are checked.
    let before: Vec<Option<Value>> = changes.iter().map(|&(index, _)| grammar.attribute_get(index)).collect();
    changes.iter().for_each(|&(index, value)| grammar.attribute_set(index, value.clone()));
    for (&(index, value), before) in changes.iter().zip(before) {
        let Err(error) = grammar.attributes()[index].allows(value, &|name| grammar.get(name).ok()) else { continue };
        problems.push(error.to_string());
        match before {
            Some(before) => grammar.attribute_set(index, before),
            None => grammar.attribute_reset(index),
        }
    }
    problems
}

/// The index of an attribute that can have the value, its limits aside.
fn place_of(grammar: &dyn Grammar, name: &Text, value: &Value) -> Result<usize, AttributeError> {
    let (index, attribute) = attribute::find(grammar.attributes(), name)?;
    attribute.has_type_of(value)?;
    Ok(index)
}

/// The faults that a run gets for what is wrong with its lot.
///
/// # Errors
/// [`Error::Lot`] if problems are errors.
pub(crate) fn faults(shape: &Shape, problems: &[String], wrong: WrongLots) -> Result<Vec<Fault>, Error> {
    if problems.is_empty() {
        return Ok(Vec::new());
    }
    let error = |problems: &[String]| Error::Lot { lot: shape.name().to_owned(), problems: problems.to_vec() };
    match wrong {
        WrongLots::Fail => Err(error(problems)),
        WrongLots::Fault => Ok(problems
            .chunks(1)
            .map(|one| Fault { kind: FaultKind::Value, message: error(one).to_string(), count: 1, trail: Vec::new() })
            .collect()),
    }
}
