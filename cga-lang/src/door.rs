//! How strict to be with rules.

/// How strict to be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Door {
    /// Rules among Rust: a call without a rule is an error.
    Inline,
    /// CGA text: a call without a rule is a leaf and a warning, as CGA documents.
    Text,
}
