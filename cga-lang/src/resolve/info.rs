//! What annotations and comments say about declarations.

use crate::ir::{ChoiceValues, Choices, Presentation, Range};

/// What annotations and comments say about an attribute.
#[derive(Clone, Debug, Default)]
pub(crate) struct AttrInfo {
    pub(crate) range: Option<Range>,
    pub(crate) choices: Option<Choices>,
    pub(crate) presentation: Presentation,
    pub(crate) display_name: Option<String>,
    pub(crate) group: Group,
    pub(crate) doc: String,
    pub(crate) order: Option<f64>,
    pub(crate) hidden: bool,
}

impl AttrInfo {
    /// The range that a run holds the attribute to.
    pub(crate) fn held_to_range(&self) -> Option<Range> {
        self.range.filter(|range| range.restricted)
    }

    /// The values that a run holds the attribute to.
    pub(crate) fn held_to_choices(&self) -> Option<&ChoiceValues> {
        self.choices.as_ref().filter(|choices| choices.restricted).map(|choices| &choices.values)
    }
}

/// What annotations and comments say about a rule.
#[derive(Clone, Debug, Default)]
pub(crate) struct RuleInfo {
    pub(crate) doc: String,
    pub(crate) marked: bool,
    pub(crate) hidden: bool,
}

/// The group that attributes belong to, from one `@Group` to the next, across imports.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Group {
    /// From the outermost to the innermost; empty when they belong to none.
    pub(crate) names: Vec<String>,
    /// Where the innermost is shown.
    pub(crate) order: Option<f64>,
}

/// What annotations say about an import.
#[derive(Clone, Debug, Default)]
pub(crate) struct ImportInfo {
    /// Which of its attributes user interfaces leave out.
    pub(crate) hidden: Hidden,
    /// The group its attributes belong to as long as they name none.
    pub(crate) group: Group,
}

/// What `@Hidden` hides.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) enum Hidden {
    /// Nothing: there is none.
    #[default]
    Nothing,
    /// What it stands before; of an import every attribute, and every import in it.
    All,
    /// `@Hidden(a, b)`: these attributes of an import.
    Names(Vec<String>),
}
