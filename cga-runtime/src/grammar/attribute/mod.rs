//! The attributes of a grammar as data: types, defaults, limits, and the errors for refused values.

mod error;
mod limits;
#[cfg(feature = "serde")]
mod serde;

pub use error::AttributeError;
pub use limits::{ChoiceValues, Choices, Range, check};

use crate::value::array::{Array, Element};
use crate::value::text::{Text, shortened};
use crate::value::{Value, ValueType};
use cga_split::suggest::nearest;

/// An attribute of a grammar. Generated code makes attributes; programs read them.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Attribute {
    /// The name in the rules, and of the field.
    pub name: &'static str,
    /// `@DisplayName`: the name in user interfaces. If it is empty, they show [`name`](Attribute::name).
    pub display_name: &'static str,
    /// The type and the default.
    pub default: AttributeDefault,
    /// `@Range`. Without it, the range that `@Angle` or `@Percent` implies.
    pub range: Option<Range>,
    /// `@Enum`, or the list of values that `@Range` has in old files.
    pub choices: Option<Choices>,
    /// The meaning of the value.
    pub kind: AttributeKind,
    /// `@Group`, from the outermost group to the innermost. A group holds until the next `@Group`, across imports.
    pub group: &'static [&'static str],
    /// The number in `@Group("A", "B", 3)`. User interfaces show the innermost groups in this order, and groups
    /// without a number last. If attributes of one group have different numbers, the first one counts.
    pub group_order: Option<f64>,
    /// `@Description`, or the doc comment.
    pub about: &'static str,
    /// `@Order`: user interfaces show attributes in this order, and attributes without a number last.
    pub order: Option<f64>,
    /// `@Hidden`: user interfaces leave the attribute out.
    pub hidden: bool,
}

/// The type of an attribute, and its default if that is a constant. Arrays are lists of rows.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum AttributeDefault {
    /// A number. In all variants, `None` is a default that is computed for each initial shape.
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

/// The meaning of a value: how user interfaces show it and edit it (*annotations*).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum AttributeKind {
    /// No particular meaning.
    Plain,
    /// `@Angle`, in degrees.
    Angle,
    /// `@Percent`: 1 is shown as 100 %.
    Percent,
    /// `@Distance`, in metres.
    Distance,
    /// `@Color`, as in `#ff8000`.
    Color,
    /// `@File`, with the file name endings that are offered; empty for all.
    File(&'static [&'static str]),
    /// `@Directory`.
    Directory,
    /// `@MaterialFile`.
    MaterialFile,
}

impl AttributeKind {
    /// The name of the kind for machines, which never changes: `plain`, `angle`, `percent`, `distance`, `color`, `file`,
    /// `directory` or `material_file`.
    pub const fn name(self) -> &'static str {
        match self {
            AttributeKind::Plain => "plain",
            AttributeKind::Angle => "angle",
            AttributeKind::Percent => "percent",
            AttributeKind::Distance => "distance",
            AttributeKind::Color => "color",
            AttributeKind::File(_) => "file",
            AttributeKind::Directory => "directory",
            AttributeKind::MaterialFile => "material_file",
        }
    }
}

impl AttributeDefault {
    /// The default as a value; `None` if it is computed for each initial shape.
    pub fn value(&self) -> Option<Value> {
        fn array<T, U: Element>(rows: &[&[T]], element: impl Fn(&T) -> U) -> Array<U> {
            let elements: Vec<U> = rows.iter().copied().flatten().map(element).collect();
            Array::new(elements, rows.len(), rows.first().map_or(0, |row| row.len()))
        }
        match *self {
            AttributeDefault::Float(number) => number.map(Value::Float),
            AttributeDefault::Bool(truth) => truth.map(Value::Bool),
            AttributeDefault::Text(text) => text.map(|text| Value::Text(Text::fixed(text))),
            AttributeDefault::Floats(rows) => rows.map(|rows| Value::Floats(array(rows, f64::clone))),
            AttributeDefault::Bools(rows) => rows.map(|rows| Value::Bools(array(rows, bool::clone))),
            AttributeDefault::Texts(rows) => rows.map(|rows| Value::Texts(array(rows, |text| Text::fixed(text)))),
        }
    }
}

impl Attribute {
    /// An attribute with a name and a default, and no annotations.
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

    /// Sets the name for user interfaces.
    #[must_use]
    pub const fn display_name(self, display_name: &'static str) -> Self {
        Attribute { display_name, ..self }
    }

    /// Sets the range.
    #[must_use]
    pub const fn range(self, range: Range) -> Self {
        Attribute { range: Some(range), ..self }
    }

    /// Sets the choices.
    #[must_use]
    pub const fn choices(self, choices: Choices) -> Self {
        Attribute { choices: Some(choices), ..self }
    }

    /// Sets the meaning of the value.
    #[must_use]
    pub const fn kind(self, kind: AttributeKind) -> Self {
        Attribute { kind, ..self }
    }

    /// Sets the group.
    #[must_use]
    pub const fn group(self, group: &'static [&'static str]) -> Self {
        Attribute { group, ..self }
    }

    /// Sets the place of its group among the groups.
    #[must_use]
    pub const fn group_order(self, order: f64) -> Self {
        Attribute { group_order: Some(order), ..self }
    }

    /// Sets the description.
    #[must_use]
    pub const fn about(self, about: &'static str) -> Self {
        Attribute { about, ..self }
    }

    /// Sets its place among the attributes.
    #[must_use]
    pub const fn order(self, order: f64) -> Self {
        Attribute { order: Some(order), ..self }
    }

    /// Hides it from user interfaces.
    #[must_use]
    pub const fn hidden(self) -> Self {
        Attribute { hidden: true, ..self }
    }

    /// The type of the attribute's values.
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

    /// The error for a text that cannot be read as a value of the attribute.
    pub(crate) fn no_value(&self, text: &str) -> AttributeError {
        AttributeError::Text { name: self.name, wanted: self.ty(), text: shortened(text) }
    }
}

/// The index and the row of the attribute with a name.
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
