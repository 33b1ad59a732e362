//! Attributes for `serde`: the names of fields, without the names of Rust's types.

use serde::Serialize;
use serde::ser::{SerializeStruct, Serializer};

use super::{Attribute, AttributeKind, ChoiceValues, Choices, Range};

impl Serialize for AttributeKind {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.name())
    }
}

impl Serialize for Range {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut row = serializer.serialize_struct("Range", 4)?;
        row.serialize_field("min", &self.min)?;
        row.serialize_field("max", &self.max)?;
        row.serialize_field("step", &self.step)?;
        row.serialize_field("restricted", &self.restricted)?;
        row.end()
    }
}

/// A list of values, or an object with the name of the attribute that has them.
impl Serialize for ChoiceValues {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            ChoiceValues::Floats(list) => list.serialize(serializer),
            ChoiceValues::Texts(list) => list.serialize(serializer),
            ChoiceValues::Attribute(name) => {
                let mut row = serializer.serialize_struct("Attribute", 1)?;
                row.serialize_field("attribute", name)?;
                row.end()
            }
        }
    }
}

impl Serialize for Choices {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut row = serializer.serialize_struct("Choices", 3)?;
        row.serialize_field("values", &self.values)?;
        row.serialize_field("labels", &self.labels)?;
        row.serialize_field("restricted", &self.restricted)?;
        row.end()
    }
}

/// The fields, the type of the values (`type`), and the file name endings of `@File` (`endings`).
impl Serialize for Attribute {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let endings = match &self.kind {
            AttributeKind::File(endings) => endings.as_slice(),
            _ => &[],
        };
        let mut row = serializer.serialize_struct("Attribute", 13)?;
        row.serialize_field("name", &self.name)?;
        row.serialize_field("display_name", &self.display_name)?;
        row.serialize_field("type", &self.ty)?;
        row.serialize_field("default", &self.default)?;
        row.serialize_field("range", &self.range)?;
        row.serialize_field("choices", &self.choices)?;
        row.serialize_field("kind", &self.kind)?;
        row.serialize_field("endings", endings)?;
        row.serialize_field("group", &self.group)?;
        row.serialize_field("group_order", &self.group_order)?;
        row.serialize_field("about", &self.about)?;
        row.serialize_field("order", &self.order)?;
        row.serialize_field("hidden", &self.hidden)?;
        row.end()
    }
}
