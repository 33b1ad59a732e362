//! Reported values as dicts and as columns.

use std::collections::BTreeMap;

use cga::{Collection, Reports, Summary, ValueType};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::{IntoPyDict as _, PyDict};

use crate::errors::RunError;

/// The reports of a model: a dict for each key. Under a key with values of several types, further types follow as `key (type)`.
pub(crate) fn dict<'py>(py: Python<'py>, reports: &Reports) -> PyResult<Bound<'py, PyDict>> {
    let all = PyDict::new(py);
    for collection in reports {
        let key = collection.key();
        let key = match all.contains(key)? {
            true => format!("{key} ({})", collection.ty().name()),
            false => key.to_owned(),
        };
        let summary = collection.summary();
        let row = PyDict::new(py);
        row.set_item("count", summary.count)?;
        row.set_item("nans", summary.nans)?;
        row.set_item("sum", summary.sum)?;
        row.set_item("average", summary.average())?;
        row.set_item("min", summary.min())?;
        row.set_item("max", summary.max())?;
        row.set_item("texts", collection.texts().collect::<Vec<_>>().into_py_dict(py)?)?;
        all.set_item(key, row)?;
    }
    Ok(all)
}

/// The number of a summary that a column has.
#[derive(Clone, Copy)]
pub(crate) enum Statistic {
    Sum,
    Average,
    Min,
    Max,
    Count,
}

impl Statistic {
    /// # Errors
    /// Another word.
    pub(crate) fn new(name: &str) -> PyResult<Self> {
        match name {
            "sum" => Ok(Statistic::Sum),
            "average" => Ok(Statistic::Average),
            "min" => Ok(Statistic::Min),
            "max" => Ok(Statistic::Max),
            "count" => Ok(Statistic::Count),
            _ => Err(PyValueError::new_err(format!(
                "`statistic` is \"sum\", \"average\", \"min\", \"max\" or \"count\", not {name:?}"
            ))),
        }
    }

    fn of(self, summary: &Summary) -> Option<f64> {
        match self {
            Statistic::Sum => Some(summary.sum),
            Statistic::Average => summary.average(),
            Statistic::Min => summary.min(),
            Statistic::Max => summary.max(),
            Statistic::Count => Some(summary.count as f64),
        }
    }
}

/// A column of reported values.
pub(crate) enum Column {
    Numbers(Vec<Option<f64>>),
    /// The different texts of each model.
    Texts(Vec<Option<String>>),
}

/// The most cells of all columns.
const MOST_CELLS: usize = 50_000_000;

/// A column for each key that a model reports, sorted by key. `None` is a lot without a model.
///
/// # Errors
/// A `RunError` if there are too many keys.
pub(crate) fn columns(models: &[Option<&Reports>], statistic: Statistic) -> PyResult<Vec<(String, Column)>> {
    let is_text = |collection: &Collection| collection.ty() == ValueType::Text;
    let mut columns: BTreeMap<(&str, bool), Column> = BTreeMap::new();
    for (at, reports) in models.iter().enumerate() {
        for collection in reports.iter().copied().flatten() {
            let id = (collection.key(), is_text(collection));
            if !columns.contains_key(&id) && MOST_CELLS < (columns.len() + 1).saturating_mul(models.len()) {
                let why = format!("the table of reports has more than {MOST_CELLS} cells; report under fewer keys");
                return Err(RunError::new_err(why));
            }
            let column = columns.entry(id).or_insert_with(|| match id.1 {
                true => Column::Texts(vec![None; models.len()]),
                false => Column::Numbers(vec![None; models.len()]),
            });
            match column {
                Column::Texts(cells) => {
                    let texts: Vec<&str> = collection.texts().map(|(text, _)| text).collect();
                    cells[at] = Some(texts.join(", "));
                }
                // Numbers come before truth values.
                Column::Numbers(cells) => cells[at] = cells[at].or(statistic.of(collection.summary())),
            }
        }
    }
    let numbers: Vec<String> =
        columns.keys().filter(|(_, is_text)| !is_text).map(|(key, _)| (*key).to_owned()).collect();
    let title = |key: &str, is_text: bool| match is_text && numbers.iter().any(|number| number == key) {
        true => format!("{key} (string)"),
        false => key.to_owned(),
    };
    Ok(columns.into_iter().map(|((key, is_text), column)| (title(key, is_text), column)).collect())
}
