//! Where a run can start.

/// A rule that a run can start with. Generated code makes them; programs read them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct StartRule {
    /// Its name, `Style$Rule` in a style other than `Default`: what [`Settings::start`](crate::run::settings::Settings::start) takes.
    pub name: &'static str,
    /// `@Description` or doc comment.
    pub about: &'static str,
    /// `@StartRule`, or marked with `start`: user interfaces offer these first, or only these.
    pub marked: bool,
    /// `@Hidden`: user interfaces leave it out. A run can start with it all the same, for annotations change no rules.
    pub hidden: bool,
}

impl StartRule {
    /// A rule about which nothing else is said.
    pub const fn new(name: &'static str) -> Self {
        StartRule { name, about: "", marked: false, hidden: false }
    }

    /// With a description.
    #[must_use]
    pub const fn about(self, about: &'static str) -> Self {
        StartRule { about, ..self }
    }

    /// Offered first.
    #[must_use]
    pub const fn marked(self) -> Self {
        StartRule { marked: true, ..self }
    }

    /// Left out by user interfaces.
    #[must_use]
    pub const fn hidden(self) -> Self {
        StartRule { hidden: true, ..self }
    }
}
