//! The rule file that a grammar was compiled from.

/// The rule file of a compiled grammar, for programs that load it again. Generated code has it with the feature `live`.
#[doc(hidden)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RuleSource {
    /// The folder of the package.
    pub folder: &'static str,
    /// The path of the rule file from there.
    pub path: &'static str,
    /// The paths of all rule files from there: this one, and the files that were imported.
    pub files: &'static [&'static str],
    /// The name of the grammar.
    pub name: &'static str,
    /// The levels of diagnostics in the header, by name: `allow`, `warn` or `deny`.
    pub levels: &'static [(&'static str, &'static str)],
}
