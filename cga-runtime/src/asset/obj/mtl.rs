//! Material libraries of OBJ files, through `tobj`.

use std::fmt;

use crate::material::{Channel, Color, ColorOf, Layer, Material, MaterialNumber, MaterialText};
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
    let mut look = Material {
        color: material.diffuse.map(|c| Color::new(exact(c[0]), exact(c[1]), exact(c[2]))),
        opacity: material.dissolve.map(exact).or_else(|| extra("Tr").map(|tr: f64| 1.0 - tr)).and_then(unit),
        texture: material.diffuse_texture.as_deref().and_then(file),
        metallic: extra("Pm").and_then(unit),
        roughness: extra("Pr").and_then(unit),
        ..Material::UNSET
    };
    let colors: [(_, ColorOf); 3] = [
        (material.ambient.map(|c| c.map(exact)), MaterialNumber::Ambient),
        (material.specular.map(|c| c.map(exact)), MaterialNumber::Specular),
        (material.emissive.map(|c| c.map(exact)), MaterialNumber::Emissive),
    ];
    for (color, which) in colors {
        let channels = [Channel::R, Channel::G, Channel::B];
        // Black is what they are anyway.
        for (channel, value) in channels.into_iter().zip(color.unwrap_or_default()) {
            if value != 0.0 {
                look.set_number(which(channel), value);
            }
        }
    }
    if let Some(shininess) = material.shininess.map(exact) {
        look.set_number(MaterialNumber::Shininess, shininess);
    }
    let maps = [
        (&material.dissolve_texture, Layer::Opacity),
        (&material.specular_texture, Layer::Specular),
        (&material.normal_texture, Layer::Bump),
    ];
    for (path, layer) in maps {
        if let Some(path) = path.as_deref().and_then(file) {
            look.set_text(MaterialText::Map(layer), path);
        }
    }
    look
}

/// The file of a map; options stand before the name.
fn file(map: &str) -> Option<Text> {
    let name = if map.starts_with('-') { map.rsplit(' ').next().unwrap_or(map) } else { map };
    (!name.is_empty()).then(|| Text::from(name))
}

/// The number as it was written: its shortest decimal form, read again with all digits.
fn exact(value: impl fmt::Display) -> f64 {
    value.to_string().parse().unwrap_or(f64::NAN)
}
