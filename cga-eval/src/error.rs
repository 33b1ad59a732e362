//! The error of rules that cannot be loaded.

use std::fmt;

use cga_source::FileList;

/// The reason why rules cannot be loaded: the errors that the compiler reports, each with its place and its line in the rules.
///
/// `Display` shows all of them, with an empty line between two.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RuleFileError {
    pub(crate) diagnostics: Vec<String>,
    pub(crate) files: FileList,
}

impl RuleFileError {
    pub(crate) fn one(message: String) -> Self {
        RuleFileError { diagnostics: vec![message], files: FileList::default() }
    }

    pub(crate) fn with_files(self, files: &FileList) -> Self {
        RuleFileError { files: files.clone(), ..self }
    }

    /// The errors and warnings, in the order of the rules.
    pub fn diagnostics(&self) -> &[String] {
        &self.diagnostics
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
