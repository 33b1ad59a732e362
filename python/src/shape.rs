//! Lots of Python programs.

use std::path::{Path, PathBuf};

use cga::{Assets, Shape as Initial};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyMapping};

use crate::call::items;
use crate::errors::{AttributeValueError, ShapeError};
use crate::geometry;
use crate::outline::{Origin, Outline};
use crate::run::guarded;
use crate::value::{from_python, to_python};

/// A lot: an initial shape with a name, values of attributes, a seed and a start rule.
///
/// `geometry` is a polygon in metres: a ring of corners, a list of rings (the outer ring, then holes), an array of NumPy with N × 2 or N × 3
/// numbers, WKB, GeoJSON as a dict or text, or an object with `__geo_interface__`, such as a geometry of shapely. Its x is to the east
/// and its y to the north; rules see (x, y, z) as (x, z, −y). The height of a polygon with z is the lowest z of its outer ring;
/// `height` sets another one.
/// `origin` is the place of the model's origin on the map.
#[pyclass(frozen, module = "pycga")]
#[derive(Debug)]
pub(crate) struct Shape {
    pub(crate) initial: Initial,
    pub(crate) own_seed: Option<u64>,
}

#[pymethods]
impl Shape {
    #[new]
    #[pyo3(signature = (geometry, *, name=None, attributes=None, seed=None, start=None, height=None, origin=None))]
    fn new(
        geometry: &Bound<'_, PyAny>,
        name: Option<String>,
        attributes: Option<&Bound<'_, PyMapping>>,
        seed: Option<u64>,
        start: Option<String>,
        height: Option<f64>,
        origin: Option<(f64, f64)>,
    ) -> PyResult<Self> {
        let outline = one(geometry::outlines(geometry).map_err(ShapeError::new_err)?)?;
        let initial = outline.shape(origin.unwrap_or_default().into(), height).map_err(ShapeError::new_err)?;
        Shape { initial, own_seed: None }.with(name, attributes, seed, start)
    }

    /// A rectangle on the ground with a corner at the origin: `width` along x and `depth` along z, in metres.
    #[staticmethod]
    #[pyo3(signature = (width, depth, *, name=None, attributes=None, seed=None, start=None))]
    fn rectangle(
        width: f64,
        depth: f64,
        name: Option<String>,
        attributes: Option<&Bound<'_, PyMapping>>,
        seed: Option<u64>,
        start: Option<String>,
    ) -> PyResult<Self> {
        if !(0.0 < width && 0.0 < depth && width.is_finite() && depth.is_finite()) {
            return Err(ShapeError::new_err(format!("{width} × {depth} metres is not a rectangle")));
        }
        Shape { initial: Initial::rectangle(width, depth), own_seed: None }.with(name, attributes, seed, start)
    }

    /// The mesh of an OBJ or GLB file, with y up.
    #[staticmethod]
    #[pyo3(signature = (path, *, name=None, attributes=None, seed=None, start=None))]
    fn from_mesh(
        py: Python<'_>,
        path: PathBuf,
        name: Option<String>,
        attributes: Option<&Bound<'_, PyMapping>>,
        seed: Option<u64>,
        start: Option<String>,
    ) -> PyResult<Self> {
        let initial = guarded(py, || mesh(&path))?.map_err(ShapeError::new_err)?;
        Shape { initial, own_seed: None }.with(name, attributes, seed, start)
    }

    /// The name; empty if it has none.
    #[getter]
    fn name(&self) -> &str {
        self.initial.name()
    }

    /// The values of attributes by name.
    #[getter]
    fn attributes<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let values = PyDict::new(py);
        for (name, value) in self.initial.attributes() {
            values.set_item(name, to_python(py, value)?)?;
        }
        Ok(values)
    }

    /// The seed of random numbers, if it has one of its own.
    #[getter]
    fn seed(&self) -> Option<u64> {
        self.own_seed
    }

    /// The start rule, if it has one of its own.
    #[getter]
    fn start(&self) -> Option<&str> {
        self.initial.start_name()
    }

    fn __repr__(&self) -> String {
        format!("<Shape {:?}>", self.initial.name())
    }
}

impl Shape {
    fn with(
        self,
        name: Option<String>,
        attributes: Option<&Bound<'_, PyMapping>>,
        seed: Option<u64>,
        start: Option<String>,
    ) -> PyResult<Self> {
        let mut initial = self.initial;
        if let Some(name) = name {
            initial = initial.named(name);
        }
        if let Some(start) = start {
            initial = initial.start(start);
        }
        for (name, value) in items(attributes)? {
            if value.is_none() {
                continue;
            }
            let value = from_python(&value, None);
            let value = value.map_err(|why| AttributeValueError::new_err(format!("attribute `{name}`: {why}")))?;
            initial = initial.attribute(name, value);
        }
        Ok(Shape { initial, own_seed: seed })
    }
}

/// The lots of a geometry: one for each polygon. Each has the name and the values; the seeds count on from `seed`.
///
/// The parameters have the meaning that they have for `Shape`.
#[pyfunction]
#[pyo3(signature = (geometry, *, name=None, attributes=None, seed=None, start=None, height=None, origin=None))]
pub(crate) fn shapes(
    geometry: &Bound<'_, PyAny>,
    name: Option<String>,
    attributes: Option<&Bound<'_, PyMapping>>,
    seed: Option<u64>,
    start: Option<String>,
    height: Option<f64>,
    origin: Option<(f64, f64)>,
) -> PyResult<Vec<Shape>> {
    let outlines = geometry::outlines(geometry).map_err(ShapeError::new_err)?;
    let shape = |(part, outline): (usize, Outline)| {
        let initial = outline.shape(origin.unwrap_or_default().into(), height).map_err(ShapeError::new_err)?;
        let seed = seed.map(|seed| seed.wrapping_add(part as u64));
        Shape { initial, own_seed: None }.with(name.clone(), attributes, seed, start.clone())
    };
    outlines.into_iter().enumerate().map(shape).collect()
}

/// The lot of an object: a `Shape`, or a geometry with one polygon.
pub(crate) fn lot(given: &Bound<'_, PyAny>, origin: Origin) -> PyResult<(Initial, Option<u64>)> {
    if let Ok(shape) = given.cast::<Shape>() {
        return Ok((shape.get().initial.clone(), shape.get().own_seed));
    }
    let outline = one(geometry::outlines(given).map_err(ShapeError::new_err)?)?;
    Ok((outline.shape(origin, None).map_err(ShapeError::new_err)?, None))
}

fn one(mut outlines: Vec<Outline>) -> PyResult<Outline> {
    match (outlines.pop(), outlines.len()) {
        (Some(outline), 0) => Ok(outline),
        (None, _) => Err(ShapeError::new_err("the geometry is empty")),
        (_, more) => Err(ShapeError::new_err(format!(
            "the geometry has {} polygons, each a lot; give it to `shapes` or `generate_all`",
            more + 1
        ))),
    }
}

/// The mesh of a file.
fn mesh(path: &Path) -> Result<Initial, String> {
    let refused = |why: String| format!("cannot read `{}`: {why}", path.display());
    let name = path.file_name().ok_or_else(|| refused("it is not a file".to_owned()))?.to_string_lossy();
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let mesh = Assets::below(folder).mesh(&name).map_err(|why| refused(why.to_string()))?;
    if mesh.face_count() == 0 {
        return Err(refused("it has no faces".to_owned()));
    }
    Ok(Initial::mesh(cga::Mesh::clone(&mesh)))
}
