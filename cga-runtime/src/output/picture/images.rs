//! The images that the materials of a picture name, and the places of corners in them.

use std::collections::HashMap;
use std::sync::Arc;

use cga_picture::{Alpha, Bitmap, ImageId, Scene};
use glam::DVec2;

use crate::asset::Assets;
use crate::asset::image::Image;
use crate::material::layer::{self, Placement, PlacementMap, SetMask};
use crate::material::{Layer, Material, MaterialNumber, MaterialText};
use crate::output::number_text::share;
use crate::output::texture::source;
use crate::value::text::Text;

/// The images of a picture.
#[derive(Debug, Default)]
pub(super) struct Images {
    assets: Option<Arc<Assets>>,
    /// The images by name and use. Only for look-ups, never iterated.
    by_name: HashMap<(Text, Layer), Option<ImageId>>,
}

/// An image on a layer of a material.
#[derive(Clone, Copy, Debug)]
pub(super) struct Map {
    pub(super) image: ImageId,
    layer: Layer,
    placement: PlacementMap,
}

/// The images of a material in pictures.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Maps {
    pub(super) color: Option<Map>,
    pub(super) opacity: Option<(Map, Alpha)>,
    pub(super) normal: Option<Map>,
}

impl Images {
    pub(super) fn new(assets: Option<Arc<Assets>>) -> Self {
        Images { assets, by_name: HashMap::new() }
    }

    /// The images of a material, which are added to a scene.
    pub(super) fn maps(&mut self, material: &Material, scene: &mut Scene) -> Maps {
        let mut map = |layer: Layer| {
            let name = layer::image(material, layer)?;
            let image = self.image(name, layer, scene)?;
            Some(Map { image, layer, placement: Placement::of(material, layer).map() })
        };
        let alpha = match material.text(MaterialText::OpacityMode).map(|mode| mode.as_str()) {
            Some("opaque") => None,
            Some("mask") => Some(Alpha::Mask(share(material.number(MaterialNumber::Cutoff), 0.5) as f32)),
            _ => Some(Alpha::Blend),
        };
        let (color, normal) = (map(Layer::Color), map(Layer::Normal));
        Maps { color, opacity: alpha.and_then(|alpha| Some((map(Layer::Opacity)?, alpha))), normal }
    }

    fn image(&mut self, name: &Text, layer: Layer, scene: &mut Scene) -> Option<ImageId> {
        let key = (name.clone(), layer);
        if let Some(known) = self.by_name.get(&key) {
            return *known;
        }
        let assets = self.assets.as_deref();
        let found = match layer {
            Layer::Opacity => source::pixels(assets, name),
            Layer::Normal => source::file_pixels(assets, name),
            _ => source::shown(assets, name),
        };
        let image = found.map(|mut pixels| {
            if layer == Layer::Opacity {
                let mut rgba = std::mem::take(&mut pixels.image.rgba);
                for pixel in rgba.as_chunks_mut::<4>().0 {
                    pixel[3] = pixels.opacity(*pixel);
                }
                pixels.image.rgba = rgba;
            }
            let Image { width, height, rgba } = pixels.image;
            let image = Bitmap { width, height, rgba };
            if layer == Layer::Normal { scene.add_normal_map(image) } else { scene.add_image(image) }
        });
        self.by_name.insert(key, image);
        image
    }
}

impl Map {
    /// The places of the corners of a face in the image, in the memory of `places`. `None` if the face has no coordinates for
    /// the layer. `uv` returns the coordinates of a corner in one of the sets `sets`.
    pub(super) fn places<'p>(
        &self,
        sets: SetMask,
        corners: usize,
        uv: impl Fn(usize, usize) -> DVec2,
        places: &'p mut Vec<DVec2>,
    ) -> Option<&'p [DVec2]> {
        let set = layer::set(self.layer, sets)?;
        places.clear();
        places.extend((0..corners).map(|corner| self.placement.at(uv(set, corner))));
        Some(places)
    }
}
