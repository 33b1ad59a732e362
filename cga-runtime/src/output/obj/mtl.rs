//! The material library of an OBJ file.

use std::collections::BTreeSet;
use std::fmt::Write as _;
use std::sync::Arc;

use glam::DVec2;

use crate::material::layer::{self, Placement};
use crate::material::{ColorOf, Layer, Material, MaterialNumber};
use crate::output::number_text::Short;
use crate::value::text::Text;

/// The keywords of maps. The format has none for a dirt map.
const MAPS: [(&str, Layer); 9] = [
    ("map_Kd", Layer::Color),
    ("map_d", Layer::Opacity),
    ("map_Ks", Layer::Specular),
    ("map_Bump", Layer::Bump),
    ("norm", Layer::Normal),
    ("map_Ke", Layer::Emissive),
    ("map_Pr", Layer::Roughness),
    ("map_Pm", Layer::Metallic),
    ("map_ao", Layer::Occlusion),
];

/// Writes a material under a name.
pub(super) fn write(text: &mut String, name: &str, material: &Material) {
    let color = material.color();
    let _ = write!(text, "newmtl {name}\nKd {} {} {}\n", Short(color.r), Short(color.g), Short(color.b));
    let mut number = |key: &str, value: Option<f64>| {
        if let Some(value) = value {
            let _ = writeln!(text, "{key} {}", Short(value));
        }
    };
    number("d", material.opacity);
    number("Pm", material.metallic);
    number("Pr", material.roughness);
    number("Ns", material.number(MaterialNumber::Shininess));
    let colors: [(&str, ColorOf); 3] =
        [("Ka", MaterialNumber::Ambient), ("Ks", MaterialNumber::Specular), ("Ke", MaterialNumber::Emissive)];
    for (key, which) in colors {
        if let Some(color) = material.channels(which) {
            let _ = writeln!(text, "{key} {} {} {}", Short(color.r), Short(color.g), Short(color.b));
        }
    }
    for (key, layer) in MAPS {
        if let Some(path) = layer::image(material, layer) {
            write_map(text, material, key, layer, path);
        }
    }
    text.push_str("illum 1\n\n");
}

fn write_map(text: &mut String, material: &Material, key: &str, layer: Layer, path: &str) {
    let Placement { scale, offset, .. } = Placement::of(material, layer);
    text.push_str(key);
    if let (Layer::Bump, Some(value)) = (layer, material.number(MaterialNumber::BumpValue)) {
        let _ = write!(text, " -bm {}", Short(value));
    }
    for (option, value, default) in [("-s", scale, DVec2::ONE), ("-o", offset, DVec2::ZERO)] {
        if value != default {
            let _ = write!(text, " {option} {} {}", Short(value.x), Short(value.y));
        }
    }
    // The format has no escapes.
    let path = file_name(path).replace(ends_line, "_");
    // A path that begins as an option does.
    let here = if path.starts_with('-') { "./" } else { "" };
    let _ = writeln!(text, " {here}{path}");
}

/// Returns true for characters that some reader takes as the end of a line or a word. A space may be a part of a name.
pub(super) fn ends_line(c: char) -> bool {
    c.is_control() || (c.is_whitespace() && c != ' ')
}

/// The path of an image in a library, with forward slashes: relative to the asset folder, or beside the library for a
/// built-in texture.
pub(super) fn file_name(name: &str) -> String {
    if let Some(name) = name.strip_prefix("builtin:") {
        let end = if name.ends_with(".png") { "" } else { ".png" };
        return format!("builtin_{}{end}", name.replace(['/', '\\', ':'], "_"));
    }
    name.strip_prefix('/').unwrap_or(name).replace('\\', "/")
}

/// The built-in textures of materials.
pub(super) fn builtins(materials: &[Arc<Material>]) -> BTreeSet<Text> {
    let maps =
        materials.iter().flat_map(|material| MAPS.iter().filter_map(|(_, layer)| layer::image(material, *layer)));
    maps.filter(|name| name.starts_with("builtin:")).cloned().collect()
}
