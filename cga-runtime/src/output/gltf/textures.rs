//! The textures of a look: the image of each map of the format, and its set of coordinates.
//!
//! The format has five maps (*material attribute*): colour with opacity, roughness with metal, normals, occlusion and
//! emitted light. Two layers of CGA that share a map of the format also share a set and a placement: the ones of the
//! colour map, or of the roughness map, if there is one. Bump, dirt and specular maps are left out: the core of the
//! format has no such maps.

use std::fmt::Write as _;

use glam::Vec2;

use crate::material::layer::{self, Placement, SetMask};
use crate::material::{Layer, Material};
use crate::output::number_text::Short;
use crate::value::text::Text;

/// An image of the file, by its sources.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(super) enum ImageKey {
    /// An unchanged file.
    File(Text),
    /// A colour map without its alpha channel.
    Opaque(Text),
    /// A colour map, or white, with the opacity of another image.
    WithOpacity { color: Option<Text>, opacity: Text },
    /// Roughness in the green and metal in the blue channel. A missing image counts as 1.
    Metal { roughness: Option<Text>, metallic: Option<Text> },
}

impl ImageKey {
    /// The file that replaces the image if it cannot be made.
    pub(super) fn file(&self) -> Option<&Text> {
        match self {
            ImageKey::File(name) | ImageKey::Opaque(name) => Some(name),
            ImageKey::WithOpacity { color, .. } => color.as_ref(),
            ImageKey::Metal { roughness, metallic } => roughness.as_ref().or(metallic.as_ref()),
        }
    }
}

/// A map of the format.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum TextureRole {
    BaseColor,
    MetallicRoughness,
    Normal,
    Occlusion,
    Emissive,
}

impl TextureRole {
    /// The name of the member in a material.
    pub(super) fn name(self) -> &'static str {
        match self {
            TextureRole::BaseColor => "baseColorTexture",
            TextureRole::MetallicRoughness => "metallicRoughnessTexture",
            TextureRole::Normal => "normalTexture",
            TextureRole::Occlusion => "occlusionTexture",
            TextureRole::Emissive => "emissiveTexture",
        }
    }

    /// Returns true for the members of `pbrMetallicRoughness`.
    pub(super) fn is_pbr(self) -> bool {
        matches!(self, TextureRole::BaseColor | TextureRole::MetallicRoughness)
    }
}

/// One texture of a look.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(super) struct LookTexture {
    pub(super) role: TextureRole,
    /// The layer whose set and placement it has.
    pub(super) layer: Layer,
    pub(super) image: ImageKey,
    /// The number of its set among the sets of the primitive.
    coordinates: usize,
    /// Offset, rotation and scale of `KHR_texture_transform`, as bits; `None` for the identity.
    transform: Option<[u32; 5]>,
}

/// The opacity map of a material, if a mesh with the sets `sets` can show it.
pub(super) fn opacity(material: &Material, sets: SetMask) -> Option<&Text> {
    layer::image(material, Layer::Opacity).filter(|_| layer::set(Layer::Opacity, sets).is_some())
}

/// The textures of a material on a mesh with the sets `sets`, and the sets that the mesh needs for them. If
/// `is_opaque`, the opacity map is ignored. `metallic` is the factor of the metal map.
pub(super) fn textures(
    material: &Material,
    sets: SetMask,
    is_opaque: bool,
    metallic: f32,
) -> (Vec<LookTexture>, SetMask) {
    let shown = |layer: Layer| layer::image(material, layer).filter(|_| layer::set(layer, sets).is_some()).cloned();
    let opacity = opacity(material, sets).filter(|_| !is_opaque).cloned();
    let base = match (shown(Layer::Color), opacity) {
        (Some(color), None) if is_opaque => Some((Layer::Color, ImageKey::File(color))),
        (Some(color), None) => Some((Layer::Color, ImageKey::Opaque(color))),
        (Some(color), Some(opacity)) if color == opacity => Some((Layer::Color, ImageKey::File(color))),
        (Some(color), Some(opacity)) => Some((Layer::Color, ImageKey::WithOpacity { color: Some(color), opacity })),
        (None, Some(opacity)) => Some((Layer::Opacity, ImageKey::WithOpacity { color: None, opacity })),
        (None, None) => None,
    };
    let metal = match (shown(Layer::Roughness), shown(Layer::Metallic)) {
        (None, None) => None,
        (Some(rough), Some(metal)) if rough == metal => Some((Layer::Roughness, ImageKey::File(rough))),
        // A factor of 0 removes the metal channel.
        (Some(rough), None) if metallic == 0.0 => Some((Layer::Roughness, ImageKey::File(rough))),
        (roughness, metallic) => {
            let layer = if roughness.is_some() { Layer::Roughness } else { Layer::Metallic };
            Some((layer, ImageKey::Metal { roughness, metallic }))
        }
    };
    let single = |layer: Layer| shown(layer).map(|name| (layer, ImageKey::File(name)));
    let all = [
        (TextureRole::BaseColor, base),
        (TextureRole::MetallicRoughness, metal),
        (TextureRole::Normal, single(Layer::Normal)),
        (TextureRole::Occlusion, single(Layer::Occlusion)),
        (TextureRole::Emissive, single(Layer::Emissive)),
    ];
    let all: Vec<_> =
        all.into_iter().filter_map(|(role, map)| map.map(|(layer, image)| (role, layer, image))).collect();
    let used: Vec<usize> = all.iter().filter_map(|(_, layer, _)| layer::set(*layer, sets)).collect();
    // Set 0 is always written, as a program may add another texture.
    let written = SetMask::of(|set| sets.has(set) && (set == 0 || used.contains(&set)));
    let texture = |(role, layer, image)| LookTexture {
        role,
        layer,
        image,
        coordinates: layer::set(layer, sets).map_or(0, |set| written.rank(set)),
        transform: transform(&Placement::of(material, layer)),
    };
    (all.into_iter().map(texture).collect(), written)
}

/// A placement in the form of the extension: scaled, turned and moved in coordinates with v downwards.
fn transform(placement: &Placement) -> Option<[u32; 5]> {
    if *placement == Placement::PLAIN {
        return None;
    }
    let ((sin, cos), Placement { scale, offset, .. }) = (placement.sin_cos(), *placement);
    let offset = [offset.x - sin * scale.y, 1.0 - cos * scale.y - offset.y];
    let numbers = [offset[0], offset[1], placement.turn.to_radians(), scale.x, scale.y];
    // Adding 0 removes the sign of −0.
    Some(numbers.map(|number| (number as f32 + 0.0).to_bits()))
}

/// The coordinates of a normal map: a list of the primitive, and the linear part of the placement with v upwards.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct NormalSpace {
    pub(super) list: usize,
    pub(super) rows: [Vec2; 2],
}

impl LookTexture {
    /// The coordinates of a normal map.
    pub(super) fn normal_space(&self) -> Option<NormalSpace> {
        let turn = |bits: [u32; 5]| {
            let [_, _, turn, su, sv] = bits.map(f32::from_bits);
            let (sin, cos) = libm::sincosf(turn);
            [Vec2::new(cos * su, -sin * sv), Vec2::new(sin * su, cos * sv)]
        };
        let rows = self.transform.map_or([Vec2::X, Vec2::Y], turn);
        (self.role == TextureRole::Normal).then_some(NormalSpace { list: self.coordinates, rows })
    }

    /// Returns true if the texture needs `KHR_texture_transform`.
    pub(super) fn is_transformed(&self) -> bool {
        self.transform.is_some()
    }

    /// The texture as a member of a material, followed by a comma.
    pub(super) fn write(&self, json: &mut String, index: usize) {
        let _ = write!(json, "\"{}\":{{\"index\":{index}", self.role.name());
        if self.coordinates != 0 {
            let _ = write!(json, ",\"texCoord\":{}", self.coordinates);
        }
        if let Some(bits) = self.transform {
            let [x, y, turn, su, sv] = bits.map(|bits| Short(f32::from_bits(bits)));
            let _ = write!(json, ",\"extensions\":{{\"KHR_texture_transform\":{{\"offset\":[{x},{y}],");
            let _ = write!(json, "\"rotation\":{turn},\"scale\":[{su},{sv}]}}}}");
        }
        json.push_str("},");
    }
}

#[cfg(test)]
mod tests {
    use glam::DVec2;

    use super::*;

    #[test]
    fn the_extension_gives_the_same_place_in_the_image() {
        let placement = Placement { scale: DVec2::new(2.0, -0.5), turn: 30.0, offset: DVec2::new(0.25, 3.0) };
        let [x, y, turn, su, sv] =
            transform(&placement).expect("a transform").map(|bits| f64::from(f32::from_bits(bits)));
        for uv in [DVec2::ZERO, DVec2::new(1.0, 0.0), DVec2::new(0.0, 1.0), DVec2::new(-3.0, 0.7)] {
            // As in the extension's specification, with v downwards.
            let (u, v) = (su * uv.x, sv * (1.0 - uv.y));
            let (sin, cos) = libm::sincos(turn);
            let [u, v] = [cos * u + sin * v + x, cos * v - sin * u + y];
            assert!((DVec2::new(u, 1.0 - v) - placement.map().at(uv)).length() < 1e-5);
        }
        assert_eq!(transform(&Placement::PLAIN), None);
    }
}
