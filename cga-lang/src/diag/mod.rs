//! Diagnostics, and a list of them that cannot be dropped unread.

mod basis;
pub mod code;
mod line;

use crate::diag::code::Code;
pub use crate::diag::code::Level;
use crate::span::Span;
pub use basis::Basis;
pub use line::{Line, RELATIVE};
pub(crate) use line::{by_way_of, count, quoted};

/// A diagnostic: the problem, its place, the reasons, and the text to type instead.
#[derive(Clone, Debug, PartialEq)]
pub struct Diag {
    /// The kind of diagnostic.
    pub code: Code,
    /// The level.
    pub level: Level,
    /// The guilty tokens.
    pub span: Span,
    /// The problem.
    pub message: Line,
    /// The content of the message that programs read.
    pub detail: Detail,
    /// The reason for a claim about runs.
    pub basis: Basis,
    /// The reasons. [`reasons`](Diag::reasons) returns these and the basis.
    pub notes: Vec<Note>,
    /// The text to type.
    pub help: Vec<Line>,
}

/// The content of a message that programs read, beyond the code of the diagnostic.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub enum Detail {
    /// None.
    #[default]
    None,
    /// The value that a condition always has.
    Condition(bool),
}

/// A reason, with an optional second place.
#[derive(Clone, Debug, PartialEq)]
pub struct Note {
    /// The line.
    pub text: Line,
    /// The second place: its line number is shown after the text.
    pub related: Option<Span>,
}

impl Diag {
    /// The reasons: the notes, then the basis.
    pub fn reasons(&self) -> impl Iterator<Item = Note> {
        self.notes.iter().cloned().chain(self.basis.notes())
    }

    /// The diagnostic in the spelling of a source: with its sign of relative sizes.
    pub fn spelled(&self, relative: char) -> Diag {
        let spelled = |line: &Line| Line::from(line.spelled(relative));
        let note = |note: &Note| Note { text: spelled(&note.text), related: note.related };
        Diag {
            message: spelled(&self.message),
            notes: self.notes.iter().map(note).collect(),
            help: self.help.iter().map(spelled).collect(),
            ..self.clone()
        }
    }

    /// Adds a reason.
    pub fn note(&mut self, text: impl Into<Line>) -> &mut Self {
        self.notes.push(Note { text: text.into(), related: None });
        self
    }

    /// Adds a reason with a second place. It is shown with its line, as in "first declared in line 3".
    pub fn related(&mut self, text: impl Into<Line>, place: Span) -> &mut Self {
        self.notes.push(Note { text: text.into(), related: Some(place) });
        self
    }

    /// Adds the text to type.
    pub fn help(&mut self, text: impl Into<Line>) -> &mut Self {
        self.help.push(text.into());
        self
    }

    /// The same diagnostic in other places. A source makes no claims about runs, so the basis has none.
    pub(crate) fn moved(mut self, to: impl Fn(Span) -> Span) -> Diag {
        self.span = to(self.span);
        for note in &mut self.notes {
            note.related = note.related.map(&to);
        }
        self
    }

    /// Adds "did you mean" if there is a near name.
    pub(crate) fn suggest(&mut self, near: Option<impl std::fmt::Display>) -> &mut Self {
        if let Some(near) = near {
            self.help(format!("did you mean `{near}`?"));
        }
        self
    }
}

/// A collection of diagnostics. Dropping it before [`finish`](Diags::finish) panics, so none are lost by accident.
#[derive(Debug, Default)]
pub struct Diags {
    list: Vec<Diag>,
    finished: bool,
}

impl Diags {
    /// An empty list.
    pub fn new() -> Self {
        Self::default()
    }

    /// Adds a diagnostic with the level of its code.
    pub fn report(&mut self, code: Code, span: Span, message: impl Into<Line>) -> &mut Diag {
        self.report_as(code, code.level(), span, message)
    }

    /// Adds a diagnostic with another level than its code has.
    pub fn report_as(&mut self, code: Code, level: Level, span: Span, message: impl Into<Line>) -> &mut Diag {
        self.list.push(Diag {
            code,
            level,
            span,
            message: message.into(),
            detail: Detail::None,
            basis: Basis::Rules,
            notes: Vec::new(),
            help: Vec::new(),
        });
        self.list.last_mut().expect("one was pushed")
    }

    /// Appends the diagnostics of another list.
    pub fn append(&mut self, list: Vec<Diag>) {
        self.list.extend(list);
    }

    /// Returns true if one of the diagnostics is an error.
    pub fn has_errors(&self) -> bool {
        self.list.iter().any(|diag| diag.level == Level::Error)
    }

    /// The diagnostics so far, in the order of the reports.
    pub(crate) fn so_far(&mut self) -> &mut Vec<Diag> {
        &mut self.list
    }

    /// Returns all diagnostics in source order. Several instances of a file report the same diagnostic: the first is
    /// kept.
    pub fn finish(mut self) -> Vec<Diag> {
        self.finished = true;
        let mut list = std::mem::take(&mut self.list);
        list.sort_by(|a, b| (a.span, a.code, &a.message).cmp(&(b.span, b.code, &b.message)));
        list.dedup_by(|b, a| (a.span, a.code, &a.message) == (b.span, b.code, &b.message));
        list
    }
}

impl Drop for Diags {
    fn drop(&mut self) {
        if !self.finished && !std::thread::panicking() {
            panic!("diagnostics were dropped unread");
        }
    }
}
