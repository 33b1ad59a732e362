//! Annotations and doc comments of declarations.

use crate::ir::{ChoiceValues, Choices, Presentation, Range};

/// The annotations and doc comment of an attribute.
#[derive(Clone, Debug, Default)]
pub(crate) struct AttrInfo {
    pub(crate) range: Option<Range>,
    pub(crate) choices: Option<Choices>,
    pub(crate) presentation: Presentation,
    pub(crate) display_name: Option<String>,
    pub(crate) group: AttrGroup,
    pub(crate) doc: String,
    pub(crate) order: Option<f64>,
    pub(crate) hidden: bool,
}

impl AttrInfo {
    /// The range to which a run restricts the attribute.
    pub(crate) fn held_to_range(&self) -> Option<Range> {
        self.range.filter(|range| range.restricted)
    }

    /// The values to which a run restricts the attribute.
    pub(crate) fn held_to_choices(&self) -> Option<&ChoiceValues> {
        self.choices.as_ref().filter(|choices| choices.restricted).map(|choices| &choices.values)
    }
}

/// The annotations and doc comment of a rule.
#[derive(Clone, Debug, Default)]
pub(crate) struct RuleInfo {
    pub(crate) doc: String,
    pub(crate) marked: bool,
    pub(crate) hidden: bool,
}

/// The group of attributes. It continues from one `@Group` to the next, across imports.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct AttrGroup {
    /// From the outermost to the innermost name; empty without a group.
    pub(crate) names: Vec<String>,
    /// The position of the innermost group in the order of groups.
    pub(crate) order: Option<f64>,
}

/// The annotations of an import.
#[derive(Clone, Debug, Default)]
pub(crate) struct ImportInfo {
    /// The attributes of the import that user interfaces leave out.
    pub(crate) hidden: Hidden,
    /// The group of its attributes until they name another.
    pub(crate) group: AttrGroup,
}

/// The effect of `@Hidden`.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) enum Hidden {
    /// Nothing, because there is no such annotation.
    #[default]
    Nothing,
    /// The annotated item. For an import: all its attributes and all imports in it.
    All,
    /// `@Hidden(a, b)`: these attributes of an import.
    Names(Vec<String>),
}
