//! The error of rules that cannot be loaded.

use std::fmt;

use cga_source::FileList;

use crate::diagnostic::RuleDiagnostic;

/// The reason why rules cannot be loaded: the errors that the compiler reports, each with its place and its line in the rules.
///
/// `Display` shows all of them, with an empty line between two.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RuleFileError {
    pub(crate) diagnostics: Vec<String>,
    pub(crate) details: Vec<RuleDiagnostic>,
    pub(crate) files: FileList,
}

impl RuleFileError {
    pub(crate) fn one(message: String) -> Self {
        RuleFileError { diagnostics: vec![message], details: Vec::new(), files: FileList::default() }
    }

    pub(crate) fn with_files(self, files: &FileList) -> Self {
        RuleFileError { files: files.clone(), ..self }
    }

    /// The errors and warnings, in the order of the rules.
    pub fn diagnostics(&self) -> &[String] {
        &self.diagnostics
    }

    /// The errors and warnings as data, in the same order. The list is empty if a file cannot be read.
    ///
    /// ```
    /// # use cga_eval::facade as cga;
    /// let error = cga::RuleFile::from_text("Lot --> extrude(3) Wal(1").unwrap_err();
    /// let first = &error.details()[0];
    /// assert_eq!((first.code, first.line, first.column), ("unclosed_bracket", 1, 23));
    /// assert_eq!((first.is_error, first.end_column), (true, 24));
    /// ```
    pub fn details(&self) -> &[RuleDiagnostic] {
        &self.details
    }

    /// The files that were read before the error, and the files that are missing. A change of one can mend the rules.
    pub fn files(&self) -> &FileList {
        &self.files
    }
}

impl fmt::Display for RuleFileError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.diagnostics.join("\n\n"))
    }
}

impl std::error::Error for RuleFileError {}
