//! The rules that a run can start with.

/// A rule that a run can start with. Generated code makes these rules; programs read them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct StartRule {
    /// The name, `Style$Rule` in a style other than `Default`, as
    /// [`Settings::start`](crate::run::settings::Settings::start) takes it.
    pub name: &'static str,
    /// `@Description`, or the doc comment.
    pub about: &'static str,
    /// `@StartRule`, or the mark `start`: user interfaces offer these rules first, or only these.
    pub marked: bool,
    /// `@Hidden`: user interfaces leave the rule out. A run can still start with it, as annotations do not change
    /// rules.
    pub hidden: bool,
}

impl StartRule {
    /// A start rule with a name and no annotations.
    pub const fn new(name: &'static str) -> Self {
        StartRule { name, about: "", marked: false, hidden: false }
    }

    /// Sets the description.
    #[must_use]
    pub const fn about(self, about: &'static str) -> Self {
        StartRule { about, ..self }
    }

    /// Marks it as offered first.
    #[must_use]
    pub const fn marked(self) -> Self {
        StartRule { marked: true, ..self }
    }

    /// Hides it from user interfaces.
    #[must_use]
    pub const fn hidden(self) -> Self {
        StartRule { hidden: true, ..self }
    }
}
