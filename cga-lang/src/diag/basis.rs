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
                vec![Note { text: format!("this holds wherever `{rule}` is called{start}").into(), related: None }]
            }
            Basis::Defaults(list) if list.is_empty() => {
                vec![Note { text: "this holds with the defaults of the attributes".into(), related: None }]
            }
            Basis::Defaults(list) => {
                let note = |(name, place): &(String, Span)| Note {
                    text: format!("this holds with the default of `{name}`").into(),
                    related: Some(*place),
                };
                list.iter().map(note).collect()
            }
        }
    }
}
