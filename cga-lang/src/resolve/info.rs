//! Annotations and doc comments of declarations. Annotations of attributes are in [`AttrInfo`](crate::ir::AttrInfo).

use crate::ir::AttrGroup;

/// The annotations and doc comment of a rule.
#[derive(Clone, Debug, Default)]
pub(crate) struct RuleInfo {
    pub(crate) doc: String,
    pub(crate) marked: bool,
    pub(crate) hidden: bool,
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
