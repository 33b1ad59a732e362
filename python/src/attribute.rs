//! Attributes and start rules of a rule file.

use cga::{Attribute as Row, RuleFile, StartRule as StartRow};
use pyo3::prelude::*;
use pyo3::types::PyList;

use crate::value::to_python;

/// An attribute of a rule file.
#[pyclass(frozen, get_all, module = "pycga")]
#[derive(Debug)]
pub(crate) struct Attribute {
    /// The name in the rules.
    name: String,
    /// The type of its values: `"float"`, `"bool"`, `"string"`, `"float[]"`, `"bool[]"` or `"string[]"`.
    r#type: &'static str,
    /// The default; `None` if it is computed for each lot.
    default: Py<PyAny>,
    /// The smallest and the largest value, by `@Range`.
    range: Option<(f64, f64)>,
    /// The step of a slider; 0 for any value.
    step: f64,
    /// The values to choose from, by `@Enum`.
    choices: Option<Py<PyList>>,
    /// True if values outside of `range` or `choices` are refused.
    restricted: bool,
    /// The meaning of the value: `"plain"`, `"angle"`, `"percent"`, `"distance"`, `"color"`, `"file"`, `"directory"` or `"material_file"`.
    kind: &'static str,
    /// The name in user interfaces; empty for `name`.
    display_name: String,
    /// The groups that it is in, the outermost first.
    group: Vec<String>,
    /// The description.
    about: String,
    /// True if user interfaces leave it out.
    hidden: bool,
}

#[pymethods]
impl Attribute {
    fn __repr__(&self) -> String {
        format!("<Attribute {}: {} = {}>", self.name, self.r#type, self.default)
    }
}

impl Attribute {
    pub(crate) fn new(py: Python<'_>, rules: &RuleFile, row: &Row) -> PyResult<Self> {
        let default = match &row.default {
            Some(value) => to_python(py, value)?.unbind(),
            None => py.None(),
        };
        let choices = match row.choices.as_ref().and_then(|choices| choices.of(rules)) {
            Some(values) => {
                let values: Vec<_> = values.iter().map(|value| to_python(py, value)).collect::<PyResult<_>>()?;
                Some(PyList::new(py, values)?.unbind())
            }
            None => None,
        };
        let restricted = row.range.is_some_and(|range| range.restricted)
            || row.choices.as_ref().is_some_and(|choices| choices.restricted);
        Ok(Attribute {
            name: row.name.to_string(),
            r#type: row.ty.name(),
            default,
            range: row.range.map(|range| (range.min, range.max)),
            step: row.range.map_or(0.0, |range| range.step),
            choices,
            restricted,
            kind: row.kind.name(),
            display_name: row.display_name.to_string(),
            group: row.group.iter().map(ToString::to_string).collect(),
            about: row.about.to_string(),
            hidden: row.hidden,
        })
    }
}

/// A rule that a run can start with.
#[pyclass(frozen, get_all, module = "pycga")]
#[derive(Clone, Debug)]
pub(crate) struct StartRule {
    /// The name, as the parameter `start` takes it.
    name: String,
    /// The description.
    about: String,
    /// True with `@StartRule`.
    marked: bool,
    /// True if user interfaces leave it out.
    hidden: bool,
}

#[pymethods]
impl StartRule {
    fn __repr__(&self) -> String {
        format!("<StartRule {}>", self.name)
    }
}

impl From<&StartRow> for StartRule {
    fn from(row: &StartRow) -> Self {
        StartRule { name: row.name.to_string(), about: row.about.to_string(), marked: row.marked, hidden: row.hidden }
    }
}
