//! The attributes of a grammar as data: what there is, what it may be, and why a value is refused.

mod error;
mod limits;

pub use error::AttributeError;
pub use limits::{ChoiceValues, Choices, Range, check};

use crate::value::ValueType;
use crate::value::text::shortened;
use cga_split::suggest::nearest;

/// An attribute of a grammar. Generated code makes them; programs read them.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Attribute {
    /// As written, and the name of the field.
    pub name: &'static str,
    /// `@DisplayName`: what user interfaces show instead, if that is not empty.
    pub display_name: &'static str,
    /// Type and default.
    pub default: AttributeDefault,
    /// `@Range`; what `@Angle` and `@Percent` offer without one.
    pub range: Option<Range>,
    /// `@Enum`, or the list of values that `@Range` has in old files.
    pub choices: Option<Choices>,
    /// What the value stands for.
    pub kind: AttributeKind,
    /// `@Group`, from the outermost to the innermost. It goes on until the next one, across imports.
    pub group: &'static [&'static str],
    /// The number in `@Group("A", "B", 3)`: user interfaces show the innermost group before those with larger numbers, and
    /// those without one last. Attributes of one group may say it differently; the first that says it counts.
    pub group_order: Option<f64>,
    /// `@Description` or doc comment.
    pub about: &'static str,
    /// `@Order`: user interfaces show attributes with smaller numbers first, and those without one last.
    pub order: Option<f64>,
    /// `@Hidden`: user interfaces leave it out.
    pub hidden: bool,
}

/// The type of an attribute, and its default when that is a constant; of arrays row by row.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum AttributeDefault {
    /// A number; `None` when it is computed for each initial shape.
    Float(Option<f64>),
    /// A truth value.
    Bool(Option<bool>),
    /// Text.
    Text(Option<&'static str>),
    /// Numbers.
    Floats(Option<&'static [&'static [f64]]>),
    /// Truth values.
    Bools(Option<&'static [&'static [bool]]>),
    /// Texts.
    Texts(Option<&'static [&'static [&'static str]]>),
}

/// What a value stands for: how user interfaces show it and let it be changed (*Annotations*).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum AttributeKind {
    /// Nothing in particular.
    Plain,
    /// `@Angle`, in degrees.
    Angle,
    /// `@Percent`: 1 is shown as 100 %.
    Percent,
    /// `@Distance`, in metres.
    Distance,
    /// `@Color`, as in `#ff8000`.
    Color,
    /// `@File`, with the endings that are offered, all for none.
    File(&'static [&'static str]),
    /// `@Directory`.
    Directory,
    /// `@MaterialFile`.
    MaterialFile,
}

impl Attribute {
    /// An attribute about which nothing else is known.
    pub const fn new(name: &'static str, default: AttributeDefault) -> Self {
        Attribute {
            name,
            display_name: "",
            default,
            range: None,
            choices: None,
            kind: AttributeKind::Plain,
            group: &[],
            group_order: None,
            about: "",
            order: None,
            hidden: false,
        }
    }

    /// With the name that user interfaces show.
    #[must_use]
    pub const fn display_name(self, display_name: &'static str) -> Self {
        Attribute { display_name, ..self }
    }

    /// With a range.
    #[must_use]
    pub const fn range(self, range: Range) -> Self {
        Attribute { range: Some(range), ..self }
    }

    /// With values to choose from.
    #[must_use]
    pub const fn choices(self, choices: Choices) -> Self {
        Attribute { choices: Some(choices), ..self }
    }

    /// With what its value stands for.
    #[must_use]
    pub const fn kind(self, kind: AttributeKind) -> Self {
        Attribute { kind, ..self }
    }

    /// In a group.
    #[must_use]
    pub const fn group(self, group: &'static [&'static str]) -> Self {
        Attribute { group, ..self }
    }

    /// In a group that has a place among the others.
    #[must_use]
    pub const fn group_order(self, order: f64) -> Self {
        Attribute { group_order: Some(order), ..self }
    }

    /// With a description.
    #[must_use]
    pub const fn about(self, about: &'static str) -> Self {
        Attribute { about, ..self }
    }

    /// With a place among the others.
    #[must_use]
    pub const fn order(self, order: f64) -> Self {
        Attribute { order: Some(order), ..self }
    }

    /// Left out by user interfaces.
    #[must_use]
    pub const fn hidden(self) -> Self {
        Attribute { hidden: true, ..self }
    }

    /// The type of its value.
    pub const fn ty(&self) -> ValueType {
        match self.default {
            AttributeDefault::Float(_) => ValueType::Float,
            AttributeDefault::Bool(_) => ValueType::Bool,
            AttributeDefault::Text(_) => ValueType::Text,
            AttributeDefault::Floats(_) => ValueType::Floats,
            AttributeDefault::Bools(_) => ValueType::Bools,
            AttributeDefault::Texts(_) => ValueType::Texts,
        }
    }

    /// The text is no value for it.
    pub(crate) fn no_value(&self, text: &str) -> AttributeError {
        AttributeError::Text { name: self.name, wanted: self.ty(), text: shortened(text) }
    }
}

/// The number and row of an attribute.
pub(crate) fn find(
    attributes: &'static [Attribute],
    name: &str,
) -> Result<(usize, &'static Attribute), AttributeError> {
    let found = attributes.iter().enumerate().find(|(_, attribute)| attribute.name == name);
    found.ok_or_else(|| {
        let near = nearest(name, attributes.iter().map(|attribute| attribute.name));
        AttributeError::Unknown { name: shortened(name), near }
    })
}
