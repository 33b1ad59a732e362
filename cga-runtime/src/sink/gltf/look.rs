//! Materials as glTF has them: what a face looks like, each look once.

use std::collections::HashMap;
use std::fmt::Write as _;

use super::json::quoted;
use crate::material::{Channel, Material, MaterialNumber, MaterialText};
use crate::sink::number::{Short, linear};
use crate::text::Text;

/// The numbers of a look, see [`Look`], as bits; its alpha mode, its sides and its texture.
type Key = ([u32; 9], Alpha, bool, Option<Text>);

/// glTF's alpha modes. The cutoff as bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
enum Alpha {
    Opaque,
    Blend,
    Mask(u32),
}

/// Looks in the order in which they are first asked for.
#[derive(Debug, Default)]
pub(super) struct Looks {
    list: Vec<Look>,
    /// Only ever asked, never walked.
    by_key: HashMap<Key, u32>,
    /// Looks by number of the material, without and with texture coordinates.
    by_material: Vec<[Option<u32>; 2]>,
}

#[derive(Debug)]
struct Look {
    name: String,
    /// Linear red, green, blue, opacity, metallic, roughness, emitted red, green, blue.
    numbers: [f32; 9],
    alpha: Alpha,
    double_sided: bool,
    texture: Option<Text>,
}

impl Looks {
    /// The look of a material, known by its number. Without texture coordinates there is no texture to show.
    pub(super) fn of(&mut self, id: u32, material: &Material, has_uvs: bool) -> u32 {
        if self.by_material.len() <= id as usize {
            self.by_material.resize(id as usize + 1, [None; 2]);
        }
        let known = &mut self.by_material[id as usize][usize::from(has_uvs)];
        if let Some(look) = *known {
            return look;
        }
        let color = material.color();
        let unit = |value: Option<f64>, default: f64| value.filter(|v| !v.is_nan()).unwrap_or(default).clamp(0.0, 1.0);
        let light = |channel| linear(unit(material.number(MaterialNumber::Emissive(channel)), 0.0));
        let numbers = [
            linear(color.r),
            linear(color.g),
            linear(color.b),
            unit(material.opacity, 1.0),
            unit(material.metallic, 0.0),
            unit(material.roughness, 1.0),
            light(Channel::R),
            light(Channel::G),
            light(Channel::B),
        ]
        // Adding 0 takes the sign off −0, which would be a look of its own.
        .map(|value| value as f32 + 0.0);
        let texture = material.texture.clone().filter(|path| has_uvs && !path.is_empty());
        let alpha = match material.text(MaterialText::OpacityMode).map(|mode| mode.as_str()) {
            Some("opaque") => Alpha::Opaque,
            Some("mask") => Alpha::Mask((unit(material.number(MaterialNumber::Cutoff), 0.5) as f32).to_bits()),
            _ if numbers[3] < 1.0 => Alpha::Blend,
            _ => Alpha::Opaque,
        };
        let double_sided = material.double_sided.unwrap_or(true);
        let list = &mut self.list;
        let key = (numbers.map(f32::to_bits), alpha, double_sided, texture.clone());
        let look = *self.by_key.entry(key).or_insert_with(|| {
            let byte = |channel: f64| libm::round(channel * 255.0) as u8;
            let hex = || format!("#{:02x}{:02x}{:02x}", byte(color.r), byte(color.g), byte(color.b));
            let name = material.name.as_ref().map_or_else(hex, |name| name.to_string());
            list.push(Look { name, numbers, alpha, double_sided, texture });
            (list.len() - 1) as u32
        });
        *known = Some(look);
        look
    }

    /// The members `materials`, `textures` and `images` of the file, each followed by a comma.
    pub(super) fn write(&self, json: &mut String) {
        if self.list.is_empty() {
            return;
        }
        let mut images: Vec<&Text> = Vec::new();
        let mut image_of: HashMap<&Text, usize> = HashMap::new();
        json.push_str("\"materials\":[");
        for (i, look) in self.list.iter().enumerate() {
            let comma = if i == 0 { "" } else { "," };
            let [r, g, b, opacity, metallic, roughness, light @ ..] = look.numbers.map(Short);
            let _ = write!(json, "{comma}{{\"name\":{},\"pbrMetallicRoughness\":{{", quoted(&look.name));
            let _ = write!(json, "\"baseColorFactor\":[{r},{g},{b},{opacity}],");
            if let Some(path) = &look.texture {
                let index = *image_of.entry(path).or_insert_with(|| {
                    images.push(path);
                    images.len() - 1
                });
                let _ = write!(json, "\"baseColorTexture\":{{\"index\":{index}}},");
            }
            let _ = write!(json, "\"metallicFactor\":{metallic},\"roughnessFactor\":{roughness}}},");
            if light.iter().any(|channel| channel.0 != 0.0) {
                let [r, g, b] = light;
                let _ = write!(json, "\"emissiveFactor\":[{r},{g},{b}],");
            }
            match look.alpha {
                Alpha::Opaque => {}
                Alpha::Blend => json.push_str("\"alphaMode\":\"BLEND\","),
                Alpha::Mask(bits) => {
                    let cutoff = Short(f32::from_bits(bits));
                    let _ = write!(json, "\"alphaMode\":\"MASK\",\"alphaCutoff\":{cutoff},");
                }
            }
            let _ = write!(json, "\"doubleSided\":{}}}", look.double_sided);
        }
        json.push_str("],");
        if images.is_empty() {
            return;
        }
        let member = |json: &mut String, name: &str, each: &dyn Fn(usize) -> String| {
            let entries: Vec<String> = (0..images.len()).map(each).collect();
            let _ = write!(json, "\"{name}\":[{}],", entries.join(","));
        };
        member(json, "textures", &|i| format!("{{\"source\":{i}}}"));
        member(json, "images", &|i| format!("{{\"uri\":{}}}", quoted(&uri(images[i]))));
    }
}

/// A path as a relative reference: forward slashes, everything but the unreserved characters escaped.
fn uri(path: &str) -> String {
    let mut text = String::new();
    for byte in path.bytes() {
        match byte {
            b'\\' => text.push('/'),
            b'a'..=b'z' | b'A'..=b'Z' | b'0'..=b'9' | b'-' | b'.' | b'_' | b'~' | b'/' => text.push(byte.into()),
            _ => text += &format!("%{byte:02X}"),
        }
    }
    text
}
