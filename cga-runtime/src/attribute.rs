//! The attributes of a grammar as data: what there is, what it may be, and why a value is refused.

use std::fmt;

use crate::fault::Error;
use crate::nearest::nearest;
use crate::text::Text;
use crate::value::{Value, ValueType};

/// An attribute of a grammar. Generated code makes them; programs read them.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Attribute {
    /// As written, and the name of the field.
    pub name: &'static str,
    /// `@DisplayName`: what user interfaces show instead, if that is not empty.
    pub display_name: &'static str,
    /// Type and default.
    pub default: Default,
    /// `@Range`.
    pub range: Option<Range>,
    /// `@Enum`.
    pub choices: Option<Choices>,
    /// What the value stands for.
    pub kind: AttributeKind,
    /// `@Group`, from the outermost to the innermost.
    pub group: &'static [&'static str],
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
pub enum Default {
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

/// `@Range(min, max)`: what a slider may offer.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Range {
    /// Smallest value.
    pub min: f64,
    /// Largest value.
    pub max: f64,
    /// Step of a slider, 0 when free.
    pub step: f64,
    /// Whether a run refuses values outside. What the host program sets is checked; what rules compute or `set` is not.
    pub restricted: bool,
}

/// `@Enum(…)`: values to choose from. Of an array each element is one of them.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Choices {
    /// The values.
    pub values: ChoiceValues,
    /// Whether others are refused.
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
    /// Those that another attribute of that name holds.
    Attribute(&'static str),
}

impl Attribute {
    /// An attribute about which nothing else is known.
    pub const fn new(name: &'static str, default: Default) -> Self {
        Attribute {
            name,
            display_name: "",
            default,
            range: None,
            choices: None,
            kind: AttributeKind::Plain,
            group: &[],
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
            Default::Float(_) => ValueType::Float,
            Default::Bool(_) => ValueType::Bool,
            Default::Text(_) => ValueType::Text,
            Default::Floats(_) => ValueType::Floats,
            Default::Bools(_) => ValueType::Bools,
            Default::Texts(_) => ValueType::Texts,
        }
    }

    /// Whether a value is its default. Old files have defaults that their annotations refuse: such a one is no mistake.
    fn is_default(&self, value: &Value) -> bool {
        match (self.default, value) {
            (Default::Float(Some(default)), Value::Float(value)) => default == *value,
            (Default::Text(Some(default)), Value::Text(value)) => default == value.as_str(),
            _ => false,
        }
    }

    /// The text is no value for it.
    pub(crate) fn no_value(&self, text: &str) -> AttributeError {
        AttributeError::Text { name: self.name, wanted: self.ty(), text: shortened(text) }
    }

    /// Checks a value that a program sets. `choices` are those to choose from, where they are restricted and known.
    pub(crate) fn check(&self, value: &Value, choices: Option<Vec<Value>>) -> Result<(), AttributeError> {
        let name = self.name;
        if value.ty() != self.ty() {
            return Err(AttributeError::Type { name, wanted: self.ty(), got: value.ty() });
        }
        if self.is_default(value) {
            return Ok(());
        }
        if let (Some(range), Value::Float(number)) = (self.range, value)
            && !range.allows(*number)
        {
            return Err(AttributeError::Range { name, value: *number, range });
        }
        match choices {
            Some(choices) if !choices.contains(value) => {
                Err(AttributeError::Choice { name, value: value.clone(), choices })
            }
            _ => Ok(()),
        }
    }
}

impl Range {
    /// From the smallest to the largest value, in steps (0 when free); `restricted` when others are refused.
    pub const fn new(min: f64, max: f64, step: f64, restricted: bool) -> Self {
        Range { min, max, step, restricted }
    }

    /// Whether a value is allowed: in an unrestricted range all are.
    fn allows(&self, value: f64) -> bool {
        !self.restricted || (self.min <= value && value <= self.max)
    }

    /// Checks the value of an attribute. Used by generated code.
    ///
    /// # Errors
    /// [`Error::Attribute`] when the range is restricted and the value outside or not a number.
    pub fn check(&self, name: &'static str, value: f64) -> Result<(), Error> {
        if self.allows(value) {
            return Ok(());
        }
        let message = format!("{value} is outside of {} to {}", self.min, self.max);
        Err(Error::Attribute { name, message })
    }
}

impl Choices {
    /// Values to choose from; `restricted` when others are refused.
    pub const fn new(values: ChoiceValues, restricted: bool) -> Self {
        Choices { values, restricted }
    }

    /// The values, unless another attribute holds them.
    pub fn known(&self) -> Option<Vec<Value>> {
        match self.values {
            ChoiceValues::Floats(list) => Some(list.iter().map(|&number| Value::Float(number)).collect()),
            ChoiceValues::Texts(list) => Some(list.iter().map(|&text| Value::Text(Text::fixed(text))).collect()),
            ChoiceValues::Attribute(_) => None,
        }
    }

    /// Checks the value of an attribute. Used by generated code.
    ///
    /// # Errors
    /// [`Error::Attribute`] when the choices are restricted and known, and the value is none of them.
    pub fn check(&self, name: &'static str, value: impl Into<Value>) -> Result<(), Error> {
        let value = value.into();
        match self.known().filter(|_| self.restricted) {
            Some(choices) if !choices.contains(&value) => {
                Err(Error::Attribute { name, message: not_among(&value, &choices) })
            }
            _ => Ok(()),
        }
    }
}

/// Why an attribute cannot be read or set by its name.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum AttributeError {
    /// There is none of that name.
    Unknown {
        /// The name asked for.
        name: String,
        /// The name that was meant, perhaps.
        near: Option<&'static str>,
    },
    /// It has no value before a run: each initial shape has its own.
    Computed {
        /// Its name.
        name: &'static str,
    },
    /// The value is of another type.
    Type {
        /// Its name.
        name: &'static str,
        /// The type it has.
        wanted: ValueType,
        /// The type of the value.
        got: ValueType,
    },
    /// The text is no value of its type.
    Text {
        /// Its name.
        name: &'static str,
        /// The type it has.
        wanted: ValueType,
        /// The text.
        text: String,
    },
    /// The value is outside of its range, which is restricted.
    Range {
        /// Its name.
        name: &'static str,
        /// The value.
        value: f64,
        /// The range.
        range: Range,
    },
    /// The value is none of those to choose from, which are restricted.
    Choice {
        /// Its name.
        name: &'static str,
        /// The value.
        value: Value,
        /// Those to choose from.
        choices: Vec<Value>,
    },
}

impl fmt::Display for AttributeError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            AttributeError::Unknown { name, near: None } => write!(f, "there is no attribute `{name}`"),
            AttributeError::Unknown { name, near: Some(near) } => {
                write!(f, "there is no attribute `{name}`; did you mean `{near}`?")
            }
            AttributeError::Computed { name } => {
                write!(f, "attribute `{name}` is computed for each initial shape, as long as it is not set")
            }
            AttributeError::Type { name, wanted, got } => {
                write!(f, "attribute `{name}` is {wanted}, and the value is {got}")
            }
            AttributeError::Text { name, wanted, text } => {
                write!(f, "attribute `{name}` is {wanted}, and `{text}` is not")
            }
            AttributeError::Range { name, value, range } => {
                write!(f, "attribute `{name}`: {value} is outside of {} to {}", range.min, range.max)
            }
            AttributeError::Choice { name, value, choices } => {
                write!(f, "attribute `{name}`: {}", not_among(value, choices))
            }
        }
    }
}

impl std::error::Error for AttributeError {}

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

/// As many choices as a message names.
const NAMED: usize = 12;

fn not_among(value: &Value, choices: &[Value]) -> String {
    let names: Vec<String> = choices.iter().take(NAMED).map(|choice| shortened(&choice.to_string())).collect();
    let more = if NAMED < choices.len() { ", …" } else { "" };
    format!("`{}` is none of {}{more}", shortened(&value.to_string()), names.join(", "))
}

/// Short enough for a message.
fn shortened(text: &str) -> String {
    const LONGEST: usize = 80;
    match text.char_indices().nth(LONGEST) {
        Some((end, _)) => format!("{}…", &text[..end]),
        None => text.to_owned(),
    }
}
