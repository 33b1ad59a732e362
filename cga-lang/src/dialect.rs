//! The dialect of rules: inline in Rust, or CGA text.

/// The dialect of a file: how strict the checks are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Dialect {
    /// Rules inline in Rust: a call without a rule is an error.
    Inline,
    /// CGA text: a call without a rule is a leaf and a warning, as CGA documents.
    Text,
}
