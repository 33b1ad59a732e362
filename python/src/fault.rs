//! Faults of a model.

use cga::{Fault as Row, FaultKind};
use pyo3::prelude::*;

/// A problem with one shape of a run, which went on. `str(fault)` is a line with the rules that led there.
#[pyclass(frozen, get_all, module = "pycga")]
#[derive(Clone, Debug)]
pub(crate) struct Fault {
    /// `"value"`, `"asset"`, `"geometry"`, `"limit"`, `"host"` or `"other"`.
    kind: &'static str,
    /// The problem, and the value that was used instead.
    message: String,
    /// The number of occurrences.
    count: u64,
    /// The rules that led to the first occurrence, from the start rule down.
    trail: Vec<String>,
    /// The whole line.
    text: String,
}

#[pymethods]
impl Fault {
    fn __str__(&self) -> &str {
        &self.text
    }

    fn __repr__(&self) -> String {
        format!("<Fault {}: {}>", self.kind, self.message)
    }
}

impl From<&Row> for Fault {
    fn from(row: &Row) -> Self {
        let kind = match row.kind {
            FaultKind::Value => "value",
            FaultKind::Asset => "asset",
            FaultKind::Geometry => "geometry",
            FaultKind::Limit => "limit",
            FaultKind::Host => "host",
            _ => "other",
        };
        Fault {
            kind,
            message: row.message.clone(),
            count: row.count,
            trail: row.trail.iter().map(ToString::to_string).collect(),
            text: row.to_string(),
        }
    }
}
