//! All attributes of a grammar as JSON.

use serde::Serialize;
use serde::ser::{SerializeMap, Serializer};

use super::Grammar;
use super::attribute::{self, Attribute, AttributeError};
use crate::value::Value;

/// The values of a grammar, by name.
struct Values<'g, G: ?Sized>(&'g G);

impl<G: Grammar + ?Sized> Serialize for Values<'_, G> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let attributes = self.0.attributes();
        let mut map = serializer.serialize_map(Some(attributes.len()))?;
        for (index, attribute) in attributes.iter().enumerate() {
            map.serialize_entry(attribute.name, &self.0.attribute_get(index))?;
        }
        map.end()
    }
}

/// An attribute with its value.
#[derive(Serialize)]
struct Described {
    #[serde(flatten)]
    attribute: &'static Attribute,
    value: Option<Value>,
    /// The values to choose from, also if another attribute has them.
    allowed: Option<Vec<Value>>,
}

/// See [`Grammar::values_json`].
pub(super) fn values<G: Grammar + ?Sized>(grammar: &G) -> String {
    serde_json::to_string(&Values(grammar)).unwrap_or_default()
}

/// See [`Grammar::attributes_json`].
pub(super) fn attributes<G: Grammar + ?Sized>(grammar: &G) -> String {
    let rows = grammar.attributes().iter().enumerate().map(|(index, attribute)| Described {
        attribute,
        value: grammar.attribute_get(index),
        allowed: attribute.choices.and_then(|choices| choices.of(grammar)),
    });
    serde_json::to_string(&rows.collect::<Vec<_>>()).unwrap_or_default()
}

/// See [`Grammar::set_values_json`].
pub(super) fn set_values<G: Grammar + ?Sized>(grammar: &mut G, json: &str) -> Result<(), AttributeError> {
    let refused = |error: serde_json::Error| AttributeError::Json { message: error.to_string() };
    let object: serde_json::Map<String, serde_json::Value> = serde_json::from_str(json).map_err(refused)?;
    let mut values = Vec::with_capacity(object.len());
    for (name, value) in object {
        let (index, attribute) = attribute::find(grammar.attributes(), &name)?;
        let value = match value {
            serde_json::Value::Null => None,
            value => {
                let text = value.to_string();
                Some(Value::of_type(attribute.ty(), value).map_err(|_| attribute.no_value(&text))?)
            }
        };
        values.push((index, attribute, value));
    }
    // Choices may be values of other attributes, so all are set before they are checked.
    let before: Vec<(usize, Option<Value>)> =
        values.iter().map(|&(index, ..)| (index, grammar.attribute_get(index))).collect();
    for (index, _, value) in &values {
        put(grammar, *index, value.clone());
    }
    let checked = values.iter().try_for_each(|(_, attribute, value)| match value {
        Some(value) => attribute.allows(value, grammar),
        None => Ok(()),
    });
    if checked.is_err() {
        before.into_iter().for_each(|(index, value)| put(grammar, index, value));
    }
    checked
}

/// Sets an attribute, or gives it its default if that is computed.
fn put<G: Grammar + ?Sized>(grammar: &mut G, index: usize, value: Option<Value>) {
    match value {
        Some(value) => grammar.attribute_set(index, value),
        None => grammar.attribute_reset(index),
    }
}
