//! The attributes of a grammar as data: types, defaults, limits, and the errors for refused values.

mod error;
mod limits;
#[cfg(feature = "serde")]
mod serde;

pub use error::AttributeError;
pub use limits::{ChoiceValues, Choices, Range, check};

use crate::value::text::{Text, shortened};
use crate::value::{Value, ValueType};
use cga_split::suggest::nearest;

/// An attribute of a grammar. Generated code makes attributes; programs read them.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Attribute {
    /// The name in the rules, and of the field.
    pub name: Text,
    /// `@DisplayName`: the name in user interfaces. If it is empty, they show [`name`](Attribute::name).
    pub display_name: Text,
    /// The type of the values.
    pub ty: ValueType,
    /// The default; `None` if it is computed for each initial shape.
    pub default: Option<Value>,
    /// `@Range`. Without it, the range that `@Angle` or `@Percent` implies.
    pub range: Option<Range>,
    /// `@Enum`, or the list of values that `@Range` has in old files.
    pub choices: Option<Choices>,
    /// The meaning of the value.
    pub kind: AttributeKind,
    /// `@Group`, from the outermost group to the innermost. A group holds until the next `@Group`, across imports.
    pub group: Vec<Text>,
    /// The number in `@Group("A", "B", 3)`. User interfaces show the innermost groups in this order, and groups
    /// without a number last. If attributes of one group have different numbers, the first one counts.
    pub group_order: Option<f64>,
    /// `@Description`, or the doc comment.
    pub about: Text,
    /// `@Order`: user interfaces show attributes in this order, and attributes without a number last.
    pub order: Option<f64>,
    /// `@Hidden`: user interfaces leave the attribute out.
    pub hidden: bool,
}

/// The meaning of a value: how user interfaces show it and edit it (*annotations*).
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
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
    File(Vec<Text>),
    /// `@Directory`.
    Directory,
    /// `@MaterialFile`.
    MaterialFile,
}

impl AttributeKind {
    /// The name of the kind for machines, which never changes: `plain`, `angle`, `percent`, `distance`, `color`, `file`,
    /// `directory` or `material_file`.
    pub const fn name(&self) -> &'static str {
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

impl Attribute {
    /// An attribute with a name and a default, and no annotations.
    pub fn new(name: impl Into<Text>, default: impl Into<Value>) -> Self {
        let default = default.into();
        Attribute { default: Some(default.clone()), ..Attribute::computed(name, default.ty()) }
    }

    /// An attribute with a name and values of a type, whose default is computed for each initial shape.
    pub fn computed(name: impl Into<Text>, ty: ValueType) -> Self {
        Attribute {
            name: name.into(),
            display_name: Text::default(),
            ty,
            default: None,
            range: None,
            choices: None,
            kind: AttributeKind::Plain,
            group: Vec::new(),
            group_order: None,
            about: Text::default(),
            order: None,
            hidden: false,
        }
    }

    /// Sets the name for user interfaces.
    #[must_use]
    pub fn display_name(self, display_name: impl Into<Text>) -> Self {
        Attribute { display_name: display_name.into(), ..self }
    }

    /// Sets the range.
    #[must_use]
    pub fn range(self, range: Range) -> Self {
        Attribute { range: Some(range), ..self }
    }

    /// Sets the choices.
    #[must_use]
    pub fn choices(self, choices: Choices) -> Self {
        Attribute { choices: Some(choices), ..self }
    }

    /// Sets the meaning of the value.
    #[must_use]
    pub fn kind(self, kind: AttributeKind) -> Self {
        Attribute { kind, ..self }
    }

    /// Sets the group.
    #[must_use]
    pub fn group(self, group: impl IntoIterator<Item = impl Into<Text>>) -> Self {
        Attribute { group: group.into_iter().map(Into::into).collect(), ..self }
    }

    /// Sets the place of its group among the groups.
    #[must_use]
    pub fn group_order(self, order: f64) -> Self {
        Attribute { group_order: Some(order), ..self }
    }

    /// Sets the description.
    #[must_use]
    pub fn about(self, about: impl Into<Text>) -> Self {
        Attribute { about: about.into(), ..self }
    }

    /// Sets its place among the attributes.
    #[must_use]
    pub fn order(self, order: f64) -> Self {
        Attribute { order: Some(order), ..self }
    }

    /// Hides it from user interfaces.
    #[must_use]
    pub fn hidden(self) -> Self {
        Attribute { hidden: true, ..self }
    }

    /// The error for a text that cannot be read as a value of the attribute.
    pub(crate) fn no_value(&self, text: &str) -> AttributeError {
        AttributeError::Text { name: self.name.clone(), wanted: self.ty, text: shortened(text) }
    }
}

/// The index and the row of the attribute with a name.
pub(crate) fn find<'a>(attributes: &'a [Attribute], name: &str) -> Result<(usize, &'a Attribute), AttributeError> {
    let found = attributes.iter().enumerate().find(|(_, attribute)| attribute.name.is(name));
    found.ok_or_else(|| {
        let near = nearest(name, attributes.iter().map(|attribute| attribute.name.as_str())).map(Text::from);
        let known = attributes.iter().filter(|attribute| !attribute.hidden).map(|attribute| attribute.name.clone());
        AttributeError::Unknown { name: shortened(name), near, known: known.collect() }
    })
}

/// The value of the attribute with a name, which `own` reads by its index.
///
/// # Errors
/// The attribute does not exist, or its default is computed and it is not set.
pub(crate) fn value(
    attributes: &[Attribute],
    name: &str,
    own: &dyn Fn(usize) -> Option<Value>,
) -> Result<Value, AttributeError> {
    let (index, attribute) = find(attributes, name)?;
    own(index).ok_or(AttributeError::Computed { name: attribute.name.clone() })
}

/// The index of the attribute with a name, which may have the value. `get` reads other attributes.
///
/// # Errors
/// The attribute does not exist, or the value is refused.
pub(crate) fn allowed(
    attributes: &[Attribute],
    name: &str,
    value: &Value,
    get: &dyn Fn(&str) -> Option<Value>,
) -> Result<usize, AttributeError> {
    let (index, attribute) = find(attributes, name)?;
    attribute.allows(value, get)?;
    Ok(index)
}

/// The value that a text gives the attribute with a name.
///
/// # Errors
/// The attribute does not exist, or the text cannot be read as a value of its type.
pub(crate) fn parsed(attributes: &[Attribute], name: &str, text: &str) -> Result<Value, AttributeError> {
    let (_, attribute) = find(attributes, name)?;
    Value::parse(text, attribute.ty).ok_or_else(|| attribute.no_value(text))
}
