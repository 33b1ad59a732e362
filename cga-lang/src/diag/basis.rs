//! The reasons for claims about runs.

use super::Note;
use crate::span::Span;

/// The reason why the claim of a diagnostic holds.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub enum Basis {
    /// The rules alone: it holds in every run.
    #[default]
    Rules,
    /// The calls of a rule: it holds wherever the rule is called.
    Calls {
        /// The name of the rule.
        rule: String,
        /// True if a run may begin with the rule, and differ.
        begins: bool,
    },
    /// The defaults of attributes, with the names of their declarations: it holds where the host program sets no other values.
    Defaults(Vec<(String, Span)>),
    /// A run from the start rule on a level footprint. With names it holds for the defaults of these attributes alone.
    Lot(Option<Vec<(String, Span)>>),
    /// The rule that runs begin with: a run that begins with another one may differ.
    Start,
    /// The extent of the shape: a shape without one may differ.
    Extent,
}

impl Basis {
    /// The notes about the basis. A basis that other notes explain has none.
    pub(super) fn notes(&self) -> Vec<Note> {
        match self {
            Basis::Rules | Basis::Start | Basis::Extent => Vec::new(),
            Basis::Calls { rule, begins } => {
                let start = if *begins { "; a run that begins with it may differ" } else { "" };
                vec![note(format!("this holds wherever `{rule}` is called{start}"), None)]
            }
            Basis::Defaults(list) => defaults(list),
            Basis::Lot(list) => {
                let mut notes = vec![note("this holds for runs from the start rule on a level footprint".into(), None)];
                notes.extend(list.iter().flat_map(|list| defaults(list)));
                notes
            }
        }
    }
}

fn note(text: String, related: Option<Span>) -> Note {
    Note { text: text.into(), related }
}

fn defaults(list: &[(String, Span)]) -> Vec<Note> {
    if list.is_empty() {
        return vec![note("this holds with the defaults of the attributes".into(), None)];
    }
    let holds = |name| format!("this holds with the default of `{name}`");
    list.iter().map(|(name, place)| note(holds(name), Some(*place))).collect()
}
