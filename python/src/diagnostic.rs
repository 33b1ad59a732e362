//! Diagnostics of rules.

use cga::{RuleDiagnostic, RuleFileError};
use pyo3::prelude::*;

use crate::errors::RuleError;

/// An error or a warning about rules. `str(diagnostic)` is the text with the line of the rules. A diagnostic can be pickled, as the exceptions that have it.
#[pyclass(frozen, get_all, module = "pycga")]
#[derive(Clone, Debug)]
pub(crate) struct Diagnostic {
    /// `"error"` or `"warning"`.
    level: String,
    /// The name of the diagnostic, as `@Allow` takes it; empty for a file that cannot be read.
    code: String,
    /// The problem in one sentence.
    message: String,
    /// The corrections that the compiler proposes.
    help: Vec<String>,
    /// The rule file; empty for a file that cannot be read.
    file: String,
    /// The line of the first character, from 1.
    line: usize,
    /// The column of the first character, from 1.
    column: usize,
    /// The line of the end.
    end_line: usize,
    /// The column after the last character.
    end_column: usize,
    /// The diagnostic as the compiler shows it.
    text: String,
}

/// The texts of a diagnostic in the order of its fields, and its places.
type Parts = (String, String, String, Vec<String>, String, [usize; 4], String);

#[pymethods]
impl Diagnostic {
    /// Loads a diagnostic that was pickled.
    #[staticmethod]
    #[pyo3(name = "_rebuild")]
    fn rebuild(parts: Parts) -> Self {
        let (level, code, message, help, file, [line, column, end_line, end_column], text) = parts;
        Diagnostic { level, code, message, help, file, line, column, end_line, end_column, text }
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyAny>, (Parts,))> {
        let own = self.clone();
        let places = [own.line, own.column, own.end_line, own.end_column];
        let parts = (own.level, own.code, own.message, own.help, own.file, places, own.text);
        Ok((py.get_type::<Diagnostic>().getattr("_rebuild")?, (parts,)))
    }

    fn __str__(&self) -> &str {
        &self.text
    }

    fn __repr__(&self) -> String {
        format!("<Diagnostic {}[{}] {}:{}:{}>", self.level, self.code, self.file, self.line, self.column)
    }
}

impl From<&RuleDiagnostic> for Diagnostic {
    fn from(diagnostic: &RuleDiagnostic) -> Self {
        Diagnostic {
            level: if diagnostic.is_error { "error" } else { "warning" }.to_owned(),
            code: diagnostic.code.to_owned(),
            message: diagnostic.message.clone(),
            help: diagnostic.help.clone(),
            file: diagnostic.file.clone(),
            line: diagnostic.line,
            column: diagnostic.column,
            end_line: diagnostic.end_line,
            end_column: diagnostic.end_column,
            text: diagnostic.text.clone(),
        }
    }
}

/// The exception for rules that cannot be loaded.
pub(crate) fn rule_error(py: Python<'_>, error: &RuleFileError) -> PyErr {
    let unread = |message: &String| Diagnostic {
        level: "error".to_owned(),
        code: String::new(),
        message: message.clone(),
        help: Vec::new(),
        file: String::new(),
        line: 1,
        column: 1,
        end_line: 1,
        end_column: 1,
        text: message.clone(),
    };
    let diagnostics: Vec<Diagnostic> = match error.details() {
        [] => error.diagnostics().iter().map(unread).collect(),
        details => details.iter().map(Diagnostic::from).collect(),
    };
    let raised = RuleError::new_err(error.to_string());
    match raised.value(py).setattr("diagnostics", diagnostics) {
        Ok(()) => raised,
        Err(other) => other,
    }
}
