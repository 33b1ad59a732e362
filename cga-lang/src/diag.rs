//! Findings, and a list of them that cannot be lost.

use crate::code::Code;
pub use crate::code::Level;
use crate::span::Span;

/// A finding: what is wrong, where, why, and what to type instead.
#[derive(Clone, Debug, PartialEq)]
pub struct Diag {
    /// Which kind.
    pub code: Code,
    /// How bad.
    pub level: Level,
    /// The guilty tokens.
    pub span: Span,
    /// What is wrong here: lower case, no full stop, names in backticks.
    pub message: String,
    /// Why.
    pub notes: Vec<Note>,
    /// What to type.
    pub help: Vec<String>,
}

/// A line that says why, and perhaps points to a second place.
#[derive(Clone, Debug, PartialEq)]
pub struct Note {
    /// The line.
    pub text: String,
    /// The second place: a door shows its line number after the text.
    pub related: Option<Span>,
}

impl Diag {
    /// Adds a reason.
    pub fn note(&mut self, text: impl Into<String>) -> &mut Self {
        self.notes.push(Note { text: text.into(), related: None });
        self
    }

    /// Adds a reason that lies elsewhere. The door shows `text` and the line, as in "first declared in line 3".
    pub fn related(&mut self, text: impl Into<String>, place: Span) -> &mut Self {
        self.notes.push(Note { text: text.into(), related: Some(place) });
        self
    }

    /// Adds what to type.
    pub fn help(&mut self, text: impl Into<String>) -> &mut Self {
        self.help.push(text.into());
        self
    }

    /// The same finding in other places.
    pub(crate) fn moved(mut self, to: impl Fn(Span) -> Span) -> Diag {
        self.span = to(self.span);
        for note in &mut self.notes {
            note.related = note.related.map(&to);
        }
        self
    }

    /// Adds "did you mean" when there is something near.
    pub(crate) fn suggest(&mut self, near: Option<impl std::fmt::Display>) -> &mut Self {
        if let Some(near) = near {
            self.help(format!("did you mean `{near}`?"));
        }
        self
    }
}

/// Collects findings. Dropping it before [`finish`](Diags::finish) panics, so none can be lost by accident.
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

    /// Adds a finding of the code's own level.
    pub fn report(&mut self, code: Code, span: Span, message: impl Into<String>) -> &mut Diag {
        self.report_as(code, code.level(), span, message)
    }

    /// Adds a finding of another level than the code's own.
    pub fn report_as(&mut self, code: Code, level: Level, span: Span, message: impl Into<String>) -> &mut Diag {
        self.list.push(Diag { code, level, span, message: message.into(), notes: Vec::new(), help: Vec::new() });
        self.list.last_mut().expect("one was pushed")
    }

    /// Takes over what another list has collected.
    pub fn append(&mut self, list: Vec<Diag>) {
        self.list.extend(list);
    }

    /// Whether one of them is an error.
    pub fn has_errors(&self) -> bool {
        self.list.iter().any(|diag| diag.level == Level::Error)
    }

    /// What was found since there were as many.
    pub(crate) fn since(&self, count: usize) -> &[Diag] {
        self.list.get(count..).unwrap_or_default()
    }

    /// Adds what to type to the first diagnostic since there were as many.
    pub(crate) fn help_since(&mut self, count: usize, help: &str) {
        if let Some(diag) = self.list.get_mut(count) {
            diag.help(help);
        }
    }

    /// How many there are.
    pub(crate) fn count(&self) -> usize {
        self.list.len()
    }

    /// Changes what has been collected so far.
    pub(crate) fn retain_mut(&mut self, keep: impl FnMut(&mut Diag) -> bool) {
        self.list.retain_mut(keep);
    }

    /// Hands over every finding, in source order. Several instances of a file report the same finding: the first is kept.
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
            panic!("findings were dropped unread");
        }
    }
}
