//! Models of many lots.

use std::sync::Arc;

use cga::{Model as Made, Reports};
use numpy::PyArray1;
use pyo3::exceptions::PyIndexError;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyIterator, PyList};
use rayon::prelude::*;

use crate::errors::RunError;
use crate::failure::Failure;
use crate::jobs::{Done, in_pool};
use crate::model::{Model, unwritten};
use crate::report_table::{Fixed, ReportTable};
use crate::reports::{Column, Statistic, columns};
use crate::run::guarded;

/// A line of a table: the numbers of lot and row, and a failure or a model.
type Line<'f> = (usize, usize, Option<&'f Failure>, Option<Arc<Made>>);

/// The models of many lots, in their order, and the lots without one: `for model in models`, `models[0]`, `len(models)`.
#[pyclass(frozen, module = "pycga")]
#[derive(Debug)]
pub(crate) struct Models {
    models: Vec<Py<Model>>,
    failures: Vec<Py<Failure>>,
}

#[pymethods]
impl Models {
    /// The rows and lots that have no model.
    #[getter]
    fn failures<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyList>> {
        PyList::new(py, self.failures.iter().map(|failure| failure.clone_ref(py)))
    }

    /// All models as one, as a file of a town needs it.
    fn to_model(&self, py: Python<'_>) -> PyResult<Model> {
        let models = self.made();
        let joined = guarded(py, || {
            let mut joined = Made::new();
            models.iter().for_each(|model| joined.append(model));
            joined
        })?;
        Ok(Model::new(joined, 0, 0))
    }

    /// The reported values as columns: a list of names, and an array of NumPy for `row` and for each key. `statistic` is the number of each
    /// key: `"sum"`, `"average"`, `"min"`, `"max"` or `"count"`. A model without the key has NaN. Keys with texts have lists.
    #[pyo3(signature = (statistic="sum"))]
    fn reports<'py>(&self, py: Python<'py>, statistic: &str) -> PyResult<Bound<'py, PyDict>> {
        let models = self.made();
        let reports: Vec<Option<&Reports>> = models.iter().map(|model| Some(model.reports())).collect();
        let all = PyDict::new(py);
        let rows: Vec<u64> = self.models.iter().map(|model| model.get().row as u64).collect();
        all.set_item("row", PyArray1::from_vec(py, rows))?;
        all.set_item("name", self.models.iter().map(|model| model.get().name()).collect::<Vec<_>>())?;
        for (key, column) in columns(&reports, Statistic::new(statistic)?)? {
            let key = if all.contains(&key)? { format!("{key} (report)") } else { key };
            match column {
                Column::Numbers(cells) => {
                    let cells: Vec<f64> = cells.into_iter().map(|cell| cell.unwrap_or(f64::NAN)).collect();
                    all.set_item(key, PyArray1::from_vec(py, cells))?;
                }
                Column::Texts(cells) => all.set_item(key, cells)?,
            }
        }
        Ok(all)
    }

    /// A table of Arrow with a line for each lot, also for lots without a model: `row`, `name`, `error`, with `glb=True` the file of the model,
    /// and the reported values.
    #[pyo3(signature = (*, glb=false, statistic="sum"))]
    fn table(&self, py: Python<'_>, glb: bool, statistic: &str) -> PyResult<ReportTable> {
        let mut lines: Vec<Line<'_>> = Vec::new();
        for model in self.models.iter().map(Py::get) {
            lines.push((model.lot, model.row, None, Some(model.made.clone())));
        }
        for failure in self.failures.iter().map(Py::get) {
            let (lot, row, ..) = failure.in_table();
            lines.push((lot, row, Some(failure), None));
        }
        lines.sort_by_key(|(lot, row, ..)| (*row, *lot));
        let mut fixed = Fixed::default();
        for (_, row, failure, made) in &lines {
            fixed.rows.push(*row as u64);
            let own = made.as_ref().and_then(|made| made.buildings().next());
            let (name, error) = match failure.map(Failure::in_table) {
                Some((_, _, name, reason)) => (name.to_owned(), Some(reason.to_owned())),
                None => (own.map_or_else(String::new, |(building, _)| building.name.to_string()), None),
            };
            fixed.names.push(name);
            fixed.errors.push(error);
        }
        let made: Vec<Option<Arc<Made>>> = lines.into_iter().map(|(_, _, _, made)| made).collect();
        if glb {
            let write = |made: &Option<Arc<Made>>| made.as_ref().map(|made| made.to_glb()).transpose();
            let write_all = || in_pool(0, || made.par_iter().map(write).collect::<Result<Vec<_>, _>>());
            let glbs = guarded(py, write_all)?.map_err(RunError::new_err)?.map_err(unwritten)?;
            fixed.glbs = Some(glbs);
        }
        let reports: Vec<Option<&Reports>> = made.iter().map(|made| made.as_ref().map(|made| made.reports())).collect();
        ReportTable::new(fixed, columns(&reports, Statistic::new(statistic)?)?)
    }

    fn __len__(&self) -> usize {
        self.models.len()
    }

    fn __getitem__(&self, py: Python<'_>, index: isize) -> PyResult<Py<Model>> {
        let count = self.models.len();
        let at = if index < 0 { count.checked_add_signed(index) } else { usize::try_from(index).ok() };
        let found = at.and_then(|at| self.models.get(at));
        found.map(|model| model.clone_ref(py)).ok_or_else(|| PyIndexError::new_err(format!("there are {count} models")))
    }

    fn __iter__<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyIterator>> {
        PyList::new(py, self.models.iter().map(|model| model.clone_ref(py)))?.try_iter()
    }

    fn __repr__(&self) -> String {
        format!("<Models: {} models, {} failures>", self.models.len(), self.failures.len())
    }
}

impl Models {
    pub(crate) fn new(py: Python<'_>, done: Vec<Done>) -> PyResult<Self> {
        let (mut models, mut failures) = (Vec::new(), Vec::new());
        for Done { job, model } in done {
            match model {
                Ok(model) => models.push(Py::new(py, Model::new(model, job.row, job.lot))?),
                Err(reason) => failures.push(Py::new(py, Failure::new(job.row, job.lot, job.name, reason))?),
            }
        }
        Ok(Models { models, failures })
    }

    fn made(&self) -> Vec<Arc<Made>> {
        self.models.iter().map(|model| model.get().made.clone()).collect()
    }
}
