//! The dialect of rules.

/// The dialect of rules, which decides how strict the checks are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Door {
    /// Rules in Rust code: a call without a rule is an error.
    Inline,
    /// CGA text: a call without a rule is a leaf and a warning, as CGA documents.
    Text,
}
