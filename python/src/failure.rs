//! Lots without a model.

use cga::Error;
use pyo3::prelude::*;

/// A row or a lot that has no model.
#[pyclass(frozen, get_all, module = "pycga")]
#[derive(Clone, Debug)]
pub(crate) struct Failure {
    /// The number of the row, from 0.
    row: usize,
    /// The number of the lot among all lots, from 0; for a row without lots, of the lot that would be next.
    lot: usize,
    /// The name of the lot; empty if it has none.
    name: String,
    /// `"shape"`, `"attribute"`, `"run"` or `"deadline"`.
    kind: &'static str,
    /// The reason.
    reason: String,
}

#[pymethods]
impl Failure {
    fn __repr__(&self) -> String {
        format!("<Failure row {}: {}>", self.row, self.reason)
    }
}

impl Failure {
    pub(crate) fn new(row: usize, lot: usize, name: String, (kind, reason): (&'static str, String)) -> Self {
        Failure { row, lot, name, kind, reason }
    }

    /// The numbers of the lot and of the row, the name and the reason.
    pub(crate) fn in_table(&self) -> (usize, usize, &str, &str) {
        (self.lot, self.row, &self.name, &self.reason)
    }
}

/// The kind and the reason of an error of a run.
pub(crate) fn reason(error: &Error) -> (&'static str, String) {
    let kind = match error {
        Error::Shape(_) => "shape",
        Error::Attribute { .. } | Error::Lot { .. } => "attribute",
        _ => "run",
    };
    (kind, error.to_string())
}
