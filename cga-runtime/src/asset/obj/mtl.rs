//! Material libraries of OBJ files, through `tobj`.
//!
//! Statements for which `tobj` would refuse the whole library, or panic, are removed first.

use std::borrow::Cow;
use std::fmt;

use crate::geometry::each::Each;
use crate::geometry::obj::lines;
use crate::material::{Channel, Color, ColorOf, Layer, Material, MaterialNumber, MaterialText};
use crate::value::text::Text;

/// A material library.
pub(super) struct MaterialLibrary {
    /// Names and materials, in the order of the file.
    pub(super) materials: Vec<(String, Material)>,
    /// The number of the first line that is invalid, and the number of further ones.
    pub(super) left_out: Option<(usize, usize)>,
}

/// Reads a library and skips invalid lines.
pub(super) fn read_mtl(bytes: &[u8]) -> Result<MaterialLibrary, tobj::LoadError> {
    let mut left_out: Option<(usize, usize)> = None;
    let mut text = String::with_capacity(bytes.len());
    for (number, line) in lines(&String::from_utf8_lossy(bytes)) {
        match readable(line) {
            Some(line) => text.push_str(&line),
            None => left_out = Some(left_out.map_or((number, 0), |(first, more)| (first, more + 1))),
        }
        text.push('\n');
    }
    let (materials, _) = tobj::load_mtl_buf(&mut text.as_bytes())?;
    let materials = materials.into_iter().map(|material| {
        let look = look(&material);
        (material.name, look)
    });
    Ok(MaterialLibrary { materials: materials.collect(), left_out })
}

/// Keywords that are matched without regard to case.
const KEYWORDS: [&str; 20] = [
    "newmtl", "Ka", "Kd", "Ks", "Ke", "Ns", "Ni", "d", "Tr", "illum", "Pm", "Pr", "map_Ka", "map_Kd", "map_Ks",
    "map_Ns", "map_d", "map_Bump", "map_bump", "bump",
];

/// A statement in the form that `tobj` reads: a colour with one number becomes a grey. `None` if it is invalid.
fn readable(line: &str) -> Option<Cow<'_, str>> {
    let mut words = line.split_whitespace();
    let keyword = words.next().unwrap_or_default();
    if !KEYWORDS.contains(&keyword)
        && let Some(known) = KEYWORDS.iter().find(|known| known.eq_ignore_ascii_case(keyword))
    {
        let line = format!("{known}{}", &line[keyword.len()..]);
        return readable(&line).map(|line| line.into_owned().into());
    }
    let values = words.clone().take(3).take_while(|word| word.parse::<f32>().is_ok_and(f32::is_finite)).count();
    let known = match keyword {
        "Ka" | "Kd" | "Ks" | "Ke" if values == 1 => {
            let grey = words.next()?;
            return Some(format!("{keyword} {grey} {grey} {grey}").into());
        }
        "Ka" | "Kd" | "Ks" | "Ke" => values == 3,
        "Ns" | "Ni" | "d" => 1 <= values,
        "illum" => words.next().is_some_and(|word| word.parse::<u8>().is_ok()),
        "newmtl" | "bump" => words.next().is_some(),
        map if map.starts_with("map_") => words.next().is_some(),
        _ => true,
    };
    known.then(|| line.into())
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
        (material.ambient.map(|c| c.each(exact)), MaterialNumber::Ambient),
        (material.specular.map(|c| c.each(exact)), MaterialNumber::Specular),
        (material.emissive.map(|c| c.each(exact)), MaterialNumber::Emissive),
    ];
    for (color, which) in colors {
        let channels = [Channel::R, Channel::G, Channel::B];
        // Black is the default.
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

/// The file name of a map, after its options.
fn file(map: &str) -> Option<Text> {
    let name = if map.starts_with('-') { map.rsplit(' ').next().unwrap_or(map) } else { map };
    (!name.is_empty()).then(|| Text::from(name))
}

/// The number as written in the file: its shortest decimal form, parsed again as f64.
fn exact(value: impl fmt::Display) -> f64 {
    value.to_string().parse().unwrap_or(f64::NAN)
}
