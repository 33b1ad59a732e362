//! The images of a picture, and their places on triangles.

use std::collections::HashMap;
use std::sync::Arc;

use glam::DVec2;

use super::texture::Texture;
use crate::asset::Assets;
use crate::geometry::each::Each;
use crate::material::layer::{self, Placement, PlacementMap, SetMask};
use crate::material::{Layer, Material, MaterialNumber, MaterialText};
use crate::output::number::share;
use crate::output::texture::source;
use crate::value::text::Text;

/// The images of a picture.
#[derive(Debug, Default)]
pub(super) struct Textures {
    assets: Option<Arc<Assets>>,
    pub(super) list: Vec<Texture>,
    /// The textures by name and use, colour or opacity. Only for look-ups, never iterated.
    by_name: HashMap<(Text, bool), Option<u32>>,
    /// The places of triangles' corners in images.
    pub(super) corners: Vec<[Option<CornerUvs>; 2]>,
}

/// The places of a triangle's corners in an image, moved near 0, as an image repeats.
pub(super) type CornerUvs = [[f32; 2]; 3];

/// The mark of a triangle without texture coordinates.
pub(super) const PLAIN: u32 = u32::MAX;

/// An image on a layer of a material.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Map {
    pub(super) texture: u32,
    layer: Layer,
    placement: PlacementMap,
}

/// The effect of an opacity map.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Alpha {
    Blend,
    /// Opaque from this opacity on, otherwise invisible.
    Mask(f32),
}

/// The images of a material in pictures.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Maps {
    pub(super) color: Option<Map>,
    pub(super) opacity: Option<(Map, Alpha)>,
}

impl Textures {
    pub(super) fn new(assets: Option<Arc<Assets>>) -> Self {
        Textures { assets, ..Textures::default() }
    }

    /// The images of a material.
    pub(super) fn maps(&mut self, material: &Material) -> Maps {
        let mut map = |layer: Layer| {
            let name = layer::image(material, layer)?;
            let texture = self.texture(name, layer == Layer::Opacity)?;
            Some(Map { texture, layer, placement: Placement::of(material, layer).map() })
        };
        let alpha = match material.text(MaterialText::OpacityMode).map(|mode| mode.as_str()) {
            Some("opaque") => None,
            Some("mask") => Some(Alpha::Mask(share(material.number(MaterialNumber::Cutoff), 0.5) as f32)),
            _ => Some(Alpha::Blend),
        };
        let color = map(Layer::Color);
        Maps { color, opacity: alpha.and_then(|alpha| Some((map(Layer::Opacity)?, alpha))) }
    }

    fn texture(&mut self, name: &Text, is_opacity: bool) -> Option<u32> {
        let key = (name.clone(), is_opacity);
        if let Some(known) = self.by_name.get(&key) {
            return *known;
        }
        let assets = self.assets.as_deref();
        let found = if is_opacity { source::pixels(assets, name) } else { source::shown(assets, name) };
        let texture = found.map(|mut pixels| {
            if is_opacity {
                let mut rgba = std::mem::take(&mut pixels.image.rgba);
                for pixel in rgba.as_chunks_mut::<4>().0 {
                    pixel[3] = pixels.opacity(*pixel);
                }
                pixels.image.rgba = rgba;
            }
            self.list.push(Texture::new(pixels.image));
            (self.list.len() - 1) as u32
        });
        self.by_name.insert(key, texture);
        texture
    }

    /// Keeps the places of a triangle's corners and returns their index. `uv` returns the coordinates of a corner in
    /// a set.
    pub(super) fn add(
        &mut self,
        maps: &Maps,
        sets: SetMask,
        corners: [usize; 3],
        uv: impl Fn(usize, usize) -> DVec2,
    ) -> u32 {
        let places = |map: &Map| {
            let set = layer::set(map.layer, sets)?;
            let places = corners.each(|corner| map.placement.at(uv(set, corner)));
            let near = places[0].floor();
            Some(places.each(|place| (place - near).as_vec2().to_array()))
        };
        let both = [maps.color.as_ref().and_then(places), maps.opacity.as_ref().and_then(|(map, _)| places(map))];
        if both == [None, None] {
            return PLAIN;
        }
        self.corners.push(both);
        (self.corners.len() - 1) as u32
    }
}
