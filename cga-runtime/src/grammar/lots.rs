//! The values of lots, in the place of the values of their grammars.

use std::collections::BTreeMap;

use crate::fault::{Error, Fault, FaultKind};
use crate::grammar::attribute::{self, AttributeError, ChoiceValues};
use crate::grammar::{Grammar, put};
use crate::run::settings::WrongLots;
use crate::shape::Shape;
use crate::shape::lot::Lot;
use crate::value::Value;
use crate::value::text::Text;

/// Sets the attributes that a lot has. Returns the problems; attributes with one keep the value of the grammar. The order of the lot's
/// attributes makes no difference to the values.
pub(crate) fn set_values(grammar: &mut dyn Grammar, lot: &Lot) -> Vec<String> {
    let mut problems = Vec::new();
    let mut before: BTreeMap<usize, Option<Value>> = BTreeMap::new();
    let mut changes = Vec::new();
    for (name, value) in &lot.attributes {
        match place_of(grammar, name, value) {
            Ok(index) => changes.push((index, value)),
            Err(error) => problems.push(error.to_string()),
        }
    }
    // Choices may be values of other attributes, so all are set before they are checked.
    for (index, value) in changes {
        before.insert(index, grammar.attribute_get(index));
        grammar.attribute_set(index, value.clone());
    }
    // Values that are taken back may be the choices of others.
    loop {
        let refused = refused(grammar, &before);
        if refused.is_empty() {
            return problems;
        }
        for (index, problem) in refused {
            problems.push(problem);
            before.remove(&index).into_iter().for_each(|value| put(grammar, index, value));
        }
    }
}

/// The attributes to take back among `set`, each with its problem: refused values, and lists of choices because of which the value of
/// another attribute is refused.
fn refused(grammar: &dyn Grammar, set: &BTreeMap<usize, Option<Value>>) -> BTreeMap<usize, String> {
    let attributes = grammar.attributes();
    let mut refused = BTreeMap::new();
    for (index, attribute) in attributes.iter().enumerate() {
        let Some(value) = grammar.attribute_get(index) else { continue };
        let Err(error) = attribute.allows(&value, &|name| grammar.get(name).ok()) else { continue };
        let choices = || match &attribute.choices.as_ref()?.values {
            ChoiceValues::Attribute(name) => attribute::find(attributes, name).ok().map(|(list, _)| list),
            ChoiceValues::Floats(_) | ChoiceValues::Texts(_) => None,
        };
        let own = if set.contains_key(&index) { Some(index) } else { choices().filter(|list| set.contains_key(list)) };
        refused.extend(own.map(|own| (own, error.to_string())));
    }
    refused
}

/// The index of an attribute that can have the value, its limits aside.
fn place_of(grammar: &dyn Grammar, name: &Text, value: &Value) -> Result<usize, AttributeError> {
    let (index, attribute) = attribute::find(grammar.attributes(), name)?;
    attribute.has_type_of(value)?;
    Ok(index)
}

/// The faults that a run gets for the problems of its lot.
///
/// # Errors
/// [`Error::Lot`] if problems are errors.
pub(crate) fn faults(shape: &Shape, problems: &[String], wrong: WrongLots) -> Result<Vec<Fault>, Error> {
    let error = |problems: &[String]| Error::Lot { lot: shape.name().to_owned(), problems: problems.to_vec() };
    if wrong == WrongLots::Fail && !problems.is_empty() {
        return Err(error(problems));
    }
    // Each fault names the lot.
    let fault = |problem: &[String]| Fault {
        kind: FaultKind::Value,
        message: error(problem).to_string(),
        count: 1,
        trail: Vec::new(),
    };
    Ok(problems.chunks(1).map(fault).collect())
}
