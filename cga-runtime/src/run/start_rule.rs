//! The rules that a run can start with.

use crate::value::text::Text;

/// A rule that a run can start with. Generated code makes these rules; programs read them.
#[derive(Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct StartRule {
    /// The name, `Style$Rule` in a style other than `Default`, as
    /// [`Settings::start`](crate::run::settings::Settings::start) takes it.
    pub name: Text,
    /// `@Description`, or the doc comment.
    pub about: Text,
    /// `@StartRule`, or the mark `start`: user interfaces offer these rules first, or only these.
    pub marked: bool,
    /// `@Hidden`: user interfaces leave the rule out. A run can still start with it, as annotations do not change
    /// rules.
    pub hidden: bool,
}

impl StartRule {
    /// A start rule with a name and no annotations.
    pub fn new(name: impl Into<Text>) -> Self {
        StartRule { name: name.into(), about: Text::default(), marked: false, hidden: false }
    }

    /// Sets the description.
    #[must_use]
    pub fn about(self, about: impl Into<Text>) -> Self {
        StartRule { about: about.into(), ..self }
    }

    /// Marks it as offered first.
    #[must_use]
    pub fn marked(self) -> Self {
        StartRule { marked: true, ..self }
    }

    /// Hides it from user interfaces.
    #[must_use]
    pub fn hidden(self) -> Self {
        StartRule { hidden: true, ..self }
    }
}
