//! Triangle meshes as arrays of NumPy.

use cga::sink::meshes::{Granularity, TriangleMesh};
use numpy::{Element, PyArray1, PyArray2, PyArray3, PyArrayMethods as _};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use crate::material::Material;

/// Triangles with one material, as arrays of NumPy. Faces share no vertices; seen from outside, corners run counter-clockwise.
#[pyclass(frozen, get_all, module = "pycga")]
#[derive(Debug)]
pub(crate) struct Mesh {
    /// The rule of all triangles; `None` if they have several.
    rule: Option<String>,
    /// The number of the building in the model; `None` if they belong to several.
    building: Option<usize>,
    /// The material of all triangles.
    material: Material,
    /// N × 3 of float32: x, y up and z, in metres from `origin`.
    positions: Py<PyArray2<f32>>,
    /// N × 3 of float32.
    normals: Py<PyArray2<f32>>,
    /// N × 2 of float32, v upwards; `None` without texture coordinates.
    uvs: Option<Py<PyArray2<f32>>>,
    /// M × 3 of uint32.
    indices: Py<PyArray2<u32>>,
    /// K × 4 × 4 of float64: matrices of the places of a mesh that is shown several times. Without any, it is in its place.
    places: Py<PyArray3<f64>>,
    /// The point that positions and places are relative to. It is the origin, unless the model is far from it.
    origin: (f64, f64, f64),
}

#[pymethods]
impl Mesh {
    fn __repr__(&self, py: Python<'_>) -> String {
        let triangles = self.indices.bind(py).len().unwrap_or_default();
        format!("<Mesh {}: {triangles} triangles>", self.rule.as_deref().unwrap_or("of several rules"))
    }
}

/// The division of a model into meshes.
///
/// # Errors
/// Another word.
pub(crate) fn granularity(by: &str) -> PyResult<Granularity> {
    match by {
        "material" => Ok(Granularity::Material),
        "building" => Ok(Granularity::Building),
        "rule" => Ok(Granularity::Rule),
        "leaf" => Ok(Granularity::Leaf),
        _ => {
            Err(PyValueError::new_err(format!("`by` is \"material\", \"building\", \"rule\" or \"leaf\", not {by:?}")))
        }
    }
}

impl Mesh {
    pub(crate) fn new(py: Python<'_>, mesh: TriangleMesh, origin: (f64, f64, f64)) -> PyResult<Self> {
        let [uvs, ..] = mesh.uvs;
        let triangles = mesh.indices.len() / 3;
        let places: Vec<f64> = mesh.places.iter().flat_map(matrix).collect();
        Ok(Mesh {
            rule: mesh.rule.map(|rule| rule.to_string()),
            building: mesh.building,
            material: Material::from(&*mesh.material),
            positions: rows(py, mesh.positions)?,
            normals: rows(py, mesh.normals)?,
            uvs: if uvs.is_empty() { None } else { Some(rows(py, uvs)?) },
            indices: PyArray1::from_vec(py, mesh.indices).reshape([triangles, 3])?.unbind(),
            places: PyArray1::from_vec(py, places).reshape([mesh.places.len(), 4, 4])?.unbind(),
            origin,
        })
    }
}

/// The rows of a matrix that moves points to their place.
fn matrix(place: &cga::glam::DAffine3) -> [f64; 16] {
    cga::glam::DMat4::from(*place).transpose().to_cols_array()
}

fn rows<T: Element, const N: usize>(py: Python<'_>, rows: Vec<[T; N]>) -> PyResult<Py<PyArray2<T>>> {
    let count = rows.len();
    Ok(PyArray1::from_vec(py, rows.into_flattened()).reshape([count, N])?.unbind())
}
