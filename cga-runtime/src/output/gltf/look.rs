//! glTF materials: the looks of faces, each once.

use std::collections::HashMap;
use std::fmt::Write as _;

use cga_picture::linear;

use super::images::Images;
use super::json::quoted;
use super::textures::{LookTexture, NormalSpace, opacity, textures};
use crate::material::layer::SetMask;
use crate::material::{Channel, Material, MaterialNumber, MaterialText};
use crate::output::interner::Interner;
use crate::output::number_text::{Short, hex, share};

/// The alpha modes of glTF. The cutoff is stored as bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
enum AlphaMode {
    Opaque,
    Blend,
    Mask(u32),
}

/// The looks in the order of their first use.
#[derive(Debug, Default)]
pub(super) struct Looks {
    looks: Interner<MaterialKey>,
    /// The names of the looks.
    names: Vec<String>,
    /// The looks by material number and sets of texture coordinates, with the sets that are needed. Only for
    /// look-ups, never iterated.
    by_material: HashMap<(u32, SetMask), (u32, SetMask)>,
}

/// The properties that make a look different.
#[derive(Debug, PartialEq, Hash)]
struct MaterialKey {
    /// The bits of linear red, green, blue, opacity, metallic, roughness, emissive red, green, blue.
    numbers: [u32; 9],
    alpha: AlphaMode,
    double_sided: bool,
    textures: Vec<LookTexture>,
}

impl Looks {
    /// The look of a material with the number `id` on a mesh with the sets `sets`, and those sets that the file
    /// needs. A map without coordinates is left out.
    pub(super) fn of(&mut self, id: u32, material: &Material, sets: SetMask) -> (u32, SetMask) {
        if let Some(&known) = self.by_material.get(&(id, sets)) {
            return known;
        }
        let color = material.color();
        let light = |channel| linear(share(material.number(MaterialNumber::Emissive(channel)), 0.0));
        let numbers = [
            linear(color.r),
            linear(color.g),
            linear(color.b),
            share(material.opacity, 1.0),
            share(material.metallic, 0.0),
            share(material.roughness, 1.0),
            light(Channel::R),
            light(Channel::G),
            light(Channel::B),
        ]
        // Adding 0 removes the sign of −0, which would make another look.
        .map(|value| value as f32 + 0.0);
        let alpha = match material.text(MaterialText::OpacityMode).map(|mode| mode.as_str()) {
            Some("opaque") => AlphaMode::Opaque,
            Some("mask") => AlphaMode::Mask((share(material.number(MaterialNumber::Cutoff), 0.5) as f32).to_bits()),
            _ if numbers[3] < 1.0 || opacity(material, sets).is_some() => AlphaMode::Blend,
            _ => AlphaMode::Opaque,
        };
        let (textures, written) = textures(material, sets, alpha == AlphaMode::Opaque, numbers[4]);
        let double_sided = material.double_sided.unwrap_or(true);
        let look = self.looks.index(MaterialKey { numbers: numbers.map(f32::to_bits), alpha, double_sided, textures });
        if look == self.names.len() {
            let name = material.name.as_ref().map_or_else(|| format!("#{}", hex(&color)), |name| name.to_string());
            self.names.push(name);
        }
        let look = look as u32;
        self.by_material.insert((id, sets), (look, written));
        (look, written)
    }

    /// The textures of all looks.
    pub(super) fn textures(&self) -> impl Iterator<Item = &LookTexture> {
        self.looks.list.iter().flat_map(|look| &look.textures)
    }

    /// The coordinates of the normal map of a look, if it has one.
    pub(super) fn normal_space(&self, look: u32, images: &Images<'_>) -> Option<NormalSpace> {
        let textures = &self.looks.list.get(look as usize)?.textures;
        let shown = textures.iter().filter(|texture| images.number(&texture.image).is_some());
        shown.filter_map(LookTexture::normal_space).next()
    }

    /// The member `materials` of the file, followed by a comma.
    pub(super) fn write(&self, json: &mut String, images: &Images<'_>) {
        if self.names.is_empty() {
            return;
        }
        json.push_str("\"materials\":[");
        for (i, (look, name)) in self.looks.list.iter().zip(&self.names).enumerate() {
            let comma = if i == 0 { "" } else { "," };
            let [r, g, b, opacity, metallic, roughness, light @ ..] =
                look.numbers.map(|bits| Short(f32::from_bits(bits)));
            let textures = |json: &mut String, is_pbr: bool| {
                for texture in look.textures.iter().filter(|texture| texture.role.is_pbr() == is_pbr) {
                    if let Some(index) = images.number(&texture.image) {
                        texture.write(json, index);
                    }
                }
            };
            let _ = write!(json, "{comma}{{\"name\":{},\"pbrMetallicRoughness\":{{", quoted(name));
            let _ = write!(json, "\"baseColorFactor\":[{r},{g},{b},{opacity}],");
            textures(json, true);
            let _ = write!(json, "\"metallicFactor\":{metallic},\"roughnessFactor\":{roughness}}},");
            textures(json, false);
            if light.iter().any(|channel| channel.0 != 0.0) {
                let [r, g, b] = light;
                let _ = write!(json, "\"emissiveFactor\":[{r},{g},{b}],");
            }
            match look.alpha {
                AlphaMode::Opaque => {}
                AlphaMode::Blend => json.push_str("\"alphaMode\":\"BLEND\","),
                AlphaMode::Mask(bits) => {
                    let cutoff = Short(f32::from_bits(bits));
                    let _ = write!(json, "\"alphaMode\":\"MASK\",\"alphaCutoff\":{cutoff},");
                }
            }
            let _ = write!(json, "\"doubleSided\":{}}}", look.double_sided);
        }
        json.push_str("],");
    }
}
