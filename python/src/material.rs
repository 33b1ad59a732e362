//! Materials of meshes.

use cga::Material as Row;
use pyo3::prelude::*;

/// The material of a mesh.
#[pyclass(frozen, get_all, module = "pycga")]
#[derive(Clone, Debug)]
pub(crate) struct Material {
    /// The name; empty if it has none.
    name: String,
    /// Red, green and blue from 0 to 1, in sRGB.
    color: (f64, f64, f64),
    /// 1 is opaque.
    opacity: f64,
    /// From 0 to 1.
    metallic: f64,
    /// From 0 to 1.
    roughness: f64,
    /// The path of the colour map; empty without one.
    texture: String,
    /// True if both sides are shown.
    double_sided: bool,
}

#[pymethods]
impl Material {
    fn __repr__(&self) -> String {
        let (r, g, b) = self.color;
        format!("<Material {:?} ({r:.3}, {g:.3}, {b:.3})>", self.name)
    }
}

impl From<&Row> for Material {
    fn from(row: &Row) -> Self {
        let color = row.color();
        let text = |text: &Option<cga::Text>| text.as_ref().map_or_else(String::new, ToString::to_string);
        Material {
            name: text(&row.name),
            color: (color.r, color.g, color.b),
            opacity: row.opacity(),
            metallic: row.metallic.unwrap_or(0.0),
            roughness: row.roughness.unwrap_or(1.0),
            texture: text(&row.texture),
            double_sided: row.double_sided.unwrap_or(true),
        }
    }
}
