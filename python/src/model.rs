//! Models.

use std::path::PathBuf;
use std::sync::Arc;

use cga::sink::picture::Picture;
use cga::{Model as Made, WriteError as Unwritten};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::{IntoPyDict as _, PyBytes, PyDict};

use crate::errors::WriteError;
use crate::fault::Fault;
use crate::mesh::{Mesh, granularity};
use crate::reports;
use crate::run::guarded;
use crate::value::to_python;

/// The most pixels of a side of a picture.
const MOST_PIXELS: usize = 1 << 14;

/// The result of a run: geometry with materials, reports, printed lines and faults.
#[pyclass(frozen, module = "pycga")]
#[derive(Debug)]
pub(crate) struct Model {
    pub(crate) made: Arc<Made>,
    /// The number of the row of its lot, from 0.
    #[pyo3(get)]
    pub(crate) row: usize,
    /// The number of its lot among all lots, from 0.
    #[pyo3(get)]
    pub(crate) lot: usize,
}

#[pymethods]
impl Model {
    /// The bytes of a GLB file.
    fn to_glb<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyBytes>> {
        let bytes = guarded(py, || self.made.to_glb())?.map_err(unwritten)?;
        Ok(PyBytes::new(py, &bytes))
    }

    /// Writes a GLB file.
    fn write_glb(&self, py: Python<'_>, path: PathBuf) -> PyResult<()> {
        guarded(py, || self.made.write_glb(path))?.map_err(unwritten)
    }

    /// Writes a file by the ending of its name: .glb, .obj with its .mtl, .png or .svg. A PNG picture has the given pixels.
    #[pyo3(signature = (path, *, width=1200, height=800))]
    fn write(&self, py: Python<'_>, path: PathBuf, width: usize, height: usize) -> PyResult<()> {
        if !(1..=MOST_PIXELS).contains(&width) || !(1..=MOST_PIXELS).contains(&height) {
            return Err(PyValueError::new_err(format!("a picture has from 1 to {MOST_PIXELS} pixels a side")));
        }
        let ending = path.extension().map(|ending| ending.to_string_lossy().to_lowercase()).unwrap_or_default();
        let write = || match ending.as_str() {
            "glb" => Some(self.made.write_glb(&path)),
            "obj" => Some(self.made.write_obj(&path)),
            "png" => Some(Picture::new(width, height).render(&self.made).write_png(&path)),
            "svg" => Some(self.made.write_svg(&path)),
            _ => None,
        };
        let wrong = || PyValueError::new_err(format!("`{}` ends in none of .glb, .obj, .png and .svg", path.display()));
        guarded(py, write)?.ok_or_else(wrong)?.map_err(unwritten)
    }

    /// The geometry as arrays of NumPy: a mesh for each material, and for each rule (`by="rule"`), building, leaf, or nothing else
    /// (`by="material"`).
    #[pyo3(signature = (*, by="rule"))]
    fn meshes(&self, py: Python<'_>, by: &str) -> PyResult<Vec<Mesh>> {
        let granularity = granularity(by)?;
        let meshes = guarded(py, || self.made.meshes(granularity))?;
        let origin = meshes.origin.into();
        meshes.into_iter().map(|mesh| Mesh::new(py, mesh, origin)).collect()
    }

    /// The name of the lot; empty if it has none.
    #[getter]
    pub(crate) fn name(&self) -> String {
        self.made.buildings().next().map_or_else(String::new, |(building, _)| building.name.to_string())
    }

    /// The seed of the lot.
    #[getter]
    fn seed(&self) -> u64 {
        self.made.buildings().next().map_or(0, |(building, _)| building.seed)
    }

    /// The values of the attributes that the run has used.
    #[getter]
    fn attributes<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let values = PyDict::new(py);
        for (name, value) in self.made.buildings().next().into_iter().flat_map(|(building, _)| &building.attributes) {
            values.set_item(name.as_str(), to_python(py, value)?)?;
        }
        Ok(values)
    }

    /// The reported values: for each key a dict with `count`, `sum`, `average`, `min`, `max`, `nans`, and `texts` with the number of each text.
    #[getter]
    fn reports<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        reports::dict(py, self.made.reports())
    }

    /// The printed lines.
    #[getter]
    fn prints(&self) -> Vec<String> {
        self.made.prints().iter().map(ToString::to_string).collect()
    }

    /// Problems with single shapes, the first thousand.
    #[getter]
    fn faults(&self) -> Vec<Fault> {
        self.made.faults().iter().map(Fault::from).collect()
    }

    /// The number of parts of each rule, in the order of the run.
    #[getter]
    fn counts<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        self.made.counts().into_py_dict(py)
    }

    /// The sum of all surfaces, in square metres.
    #[getter]
    fn area(&self) -> f64 {
        self.made.area()
    }

    /// The sum of all volumes, in cubic metres. Parts that overlap count twice.
    #[getter]
    fn volume(&self) -> f64 {
        self.made.volume()
    }

    /// The lowest and the highest x, y and z; `None` without geometry.
    #[getter]
    fn bounds(&self) -> Option<([f64; 3], [f64; 3])> {
        let bounds = self.made.bounds();
        (bounds.low.x <= bounds.high.x).then(|| (bounds.low.into(), bounds.high.into()))
    }

    /// The number of triangles that a file has.
    #[getter]
    fn triangle_count(&self) -> usize {
        self.made.triangle_count()
    }

    /// The number of parts.
    fn __len__(&self) -> usize {
        self.made.len()
    }

    fn __bool__(&self) -> bool {
        true
    }

    fn __repr__(&self) -> String {
        format!("<Model {:?}: {} parts>", self.name(), self.made.len())
    }
}

impl Model {
    pub(crate) fn new(made: Made, row: usize, lot: usize) -> Self {
        Model { made: Arc::new(made), row, lot }
    }
}

/// The exception for a file.
pub(crate) fn unwritten(why: Unwritten) -> PyErr {
    WriteError::new_err(why.to_string())
}
