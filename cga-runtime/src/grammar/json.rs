//! All attributes of a grammar as JSON. The code gets functions that read the values of a grammar, so it is compiled once, not
//! for each grammar.

use serde::Serialize;
use serde::ser::{SerializeMap, Serializer};

use super::attribute::{self, Attribute, AttributeError};
use super::{Grammar, put};
use crate::value::Value;

/// The value of an attribute by its index.
type Own<'a> = &'a dyn Fn(usize) -> Option<Value>;

/// The values of attributes, by name.
struct Values<'a> {
    attributes: &'a [Attribute],
    own: Own<'a>,
}

impl Serialize for Values<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(Some(self.attributes.len()))?;
        for (index, attribute) in self.attributes.iter().enumerate() {
            map.serialize_entry(&attribute.name, &(self.own)(index))?;
        }
        map.end()
    }
}

/// An attribute with its value.
#[derive(Serialize)]
struct Described<'a> {
    #[serde(flatten)]
    attribute: &'a Attribute,
    value: Option<Value>,
    /// The values to choose from, also if another attribute has them.
    allowed: Option<Vec<Value>>,
}

/// See [`Grammar::values_json`].
pub(super) fn values(attributes: &[Attribute], own: Own<'_>) -> String {
    serde_json::to_string(&Values { attributes, own }).unwrap_or_default()
}

/// See [`Grammar::attributes_json`].
pub(super) fn attributes(attributes: &[Attribute], own: Own<'_>, get: &dyn Fn(&str) -> Option<Value>) -> String {
    let rows = attributes.iter().enumerate().map(|(index, attribute)| Described {
        attribute,
        value: own(index),
        allowed: attribute.choices.as_ref().and_then(|choices| choices.of_values(get)),
    });
    serde_json::to_string(&rows.collect::<Vec<_>>()).unwrap_or_default()
}

/// An attribute by its index, and the value that it gets; `None` is the default.
type Change = (usize, Option<Value>);

/// A grammar of any type, whose attributes are read and set.
pub(super) trait Slots {
    fn attributes(&self) -> &[Attribute];
    fn own(&self, index: usize) -> Option<Value>;
    fn get(&self, name: &str) -> Option<Value>;
    fn put(&mut self, index: usize, value: Option<Value>);
}

/// A grammar as [`Slots`].
pub(super) struct Of<'a, G: ?Sized>(pub(super) &'a mut G);

impl<G: Grammar + ?Sized> Slots for Of<'_, G> {
    fn attributes(&self) -> &[Attribute] {
        self.0.attributes()
    }

    fn own(&self, index: usize) -> Option<Value> {
        self.0.attribute_get(index)
    }

    fn get(&self, name: &str) -> Option<Value> {
        self.0.get(name).ok()
    }

    fn put(&mut self, index: usize, value: Option<Value>) {
        put(self.0, index, value);
    }
}

/// See [`Grammar::set_values_json`].
pub(super) fn set_values(grammar: &mut dyn Slots, json: &str) -> Result<(), AttributeError> {
    let changes = read(grammar.attributes(), json)?;
    // Choices may be values of other attributes, so all are set before they are checked.
    let before: Vec<Change> = changes.iter().map(|&(index, _)| (index, grammar.own(index))).collect();
    put_all(grammar, &changes);
    let checked = allowed(grammar.attributes(), &changes, &|name| grammar.get(name));
    if checked.is_err() {
        put_all(grammar, &before);
    }
    checked
}

/// The values of a JSON object.
fn read(attributes: &[Attribute], json: &str) -> Result<Vec<Change>, AttributeError> {
    let refused = |error: serde_json::Error| AttributeError::Json { message: error.to_string() };
    let object: serde_json::Map<String, serde_json::Value> = serde_json::from_str(json).map_err(refused)?;
    let change = |(name, value): (String, serde_json::Value)| {
        let (index, attribute) = attribute::find(attributes, &name)?;
        let value = match value {
            serde_json::Value::Null => None,
            value => {
                let text = value.to_string();
                Some(Value::of_type(attribute.ty, value).map_err(|_| attribute.no_value(&text))?)
            }
        };
        Ok((index, value))
    };
    object.into_iter().map(change).collect()
}

/// Checks the values of changes that were made.
fn allowed(
    attributes: &[Attribute],
    changes: &[Change],
    get: &dyn Fn(&str) -> Option<Value>,
) -> Result<(), AttributeError> {
    changes.iter().try_for_each(|(index, value)| match value {
        Some(value) => attributes[*index].allows(value, get),
        None => Ok(()),
    })
}

/// Makes changes. An attribute without a value gets its default.
fn put_all(grammar: &mut dyn Slots, changes: &[Change]) {
    changes.iter().for_each(|(index, value)| grammar.put(*index, value.clone()));
}
