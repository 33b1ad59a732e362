//! Material libraries of OBJ files, through `tobj`.

use std::fmt;

use crate::material::{Color, Material};
use crate::text::Text;

/// Names and looks, in the order of the file.
pub(super) fn read_mtl(bytes: &[u8]) -> Result<Vec<(String, Material)>, tobj::LoadError> {
    let text = String::from_utf8_lossy(bytes);
    let (materials, _) = tobj::load_mtl_buf(&mut text.as_bytes())?;
    Ok(materials
        .into_iter()
        .map(|material| {
            let look = look(&material);
            (material.name, look)
        })
        .collect())
}

fn look(material: &tobj::Material) -> Material {
    let extra = |key: &str| material.unknown_param.get(key).and_then(|text| text.trim().parse().ok());
    let unit = |value: f64| value.is_finite().then(|| value.clamp(0.0, 1.0));
    Material {
        name: None,
        color: material.diffuse.map(|c| Color::new(exact(c[0]), exact(c[1]), exact(c[2]))),
        opacity: material.dissolve.map(exact).or_else(|| extra("Tr").map(|tr: f64| 1.0 - tr)).and_then(unit),
        // Options stand before the name.
        texture: material
            .diffuse_texture
            .as_deref()
            .filter(|name| !name.is_empty())
            .map(|name| Text::from(if name.starts_with('-') { name.rsplit(' ').next().unwrap_or(name) } else { name })),
        metallic: extra("Pm").and_then(unit),
        roughness: extra("Pr").and_then(unit),
    }
}

/// The number as it was written: its shortest decimal form, read again with all digits.
fn exact(value: impl fmt::Display) -> f64 {
    value.to_string().parse().unwrap_or(f64::NAN)
}
