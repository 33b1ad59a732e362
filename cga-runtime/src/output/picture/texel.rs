//! The textures of what is seen: which image lies where on a triangle.
//!
//! A point that is seen is known in space, so its texture coordinates follow from its place in the triangle, and need no correction
//! for the perspective. The points that the neighbours of a sample would show on the same plane tell how much of the image it shows.

use std::collections::HashMap;
use std::sync::Arc;

use glam::{DVec2, DVec3};

use super::camera::View;
use super::scene::{Paint, Scene, Triangle};
use super::texture::Texture;
use crate::asset::Assets;
use crate::material::layer::{self, Placement, PlacementMap, SetMask};
use crate::material::{Layer, Material, MaterialNumber, MaterialText};
use crate::output::texture::source;
use crate::value::text::Text;

/// The images of a picture.
#[derive(Debug, Default)]
pub(super) struct Textures {
    assets: Option<Arc<Assets>>,
    list: Vec<Texture>,
    /// By name and use: as colour or as opacity. Only ever asked, never walked.
    by_name: HashMap<(Text, bool), Option<u32>>,
    /// Places in images of the corners of triangles.
    corners: Vec<[Option<Corners>; 2]>,
}

/// The places of the corners of a triangle in an image, near 0: an image repeats.
pub(super) type Corners = [[f32; 2]; 3];

/// No texture coordinates.
pub(super) const PLAIN: u32 = u32::MAX;

/// An image on a layer of a material.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Map {
    texture: u32,
    layer: Layer,
    placement: PlacementMap,
}

/// How an opacity map counts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Alpha {
    Blend,
    /// All or nothing, from this opacity on.
    Mask(f32),
}

/// The images of a material that pictures show.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Maps {
    color: Option<Map>,
    opacity: Option<(Map, Alpha)>,
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
        let cutoff = || material.number(MaterialNumber::Cutoff).filter(|cutoff| !cutoff.is_nan()).unwrap_or(0.5);
        let alpha = match material.text(MaterialText::OpacityMode).map(|mode| mode.as_str()) {
            Some("opaque") => None,
            Some("mask") => Some(Alpha::Mask(cutoff().clamp(0.0, 1.0) as f32)),
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
        let texture = source::pixels(self.assets.as_deref(), name).map(|mut pixels| {
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

    /// Keeps the places of the corners of a triangle; gives their number. `uv` gives the coordinates of a corner in a set.
    pub(super) fn add(
        &mut self,
        maps: &Maps,
        sets: SetMask,
        corners: [usize; 3],
        uv: impl Fn(usize, usize) -> DVec2,
    ) -> u32 {
        let places = |map: &Map| {
            let set = layer::set(map.layer, sets)?;
            let places = corners.map(|corner| map.placement.at(uv(set, corner)));
            let near = places[0].floor();
            Some(places.map(|place| (place - near).as_vec2().to_array()))
        };
        let both = [maps.color.as_ref().and_then(places), maps.opacity.as_ref().and_then(|(map, _)| places(map))];
        if both == [None, None] {
            return PLAIN;
        }
        self.corners.push(both);
        (self.corners.len() - 1) as u32
    }
}

impl Maps {
    /// True if an opacity map may make parts of a surface transparent.
    pub(super) fn has_opacity(&self) -> bool {
        self.opacity.is_some()
    }
}

/// The part of a surface that a sample shows.
#[derive(Clone, Copy, Debug)]
struct Footprint {
    /// The point as weights of the second and the third corner of its triangle.
    at: DVec2,
    /// Towards the samples to the right and below.
    sides: [DVec2; 2],
}

impl Footprint {
    fn of(triangle: &Triangle, view: &View, [x, y]: [f64; 2], point: DVec3) -> Self {
        let [a, b, c] = triangle.corners();
        let normal = triangle.normal();
        let (e, f) = (b - a, c - a);
        let (ee, ef, ff) = (e.dot(e), e.dot(f), f.dot(f));
        let area = ee * ff - ef * ef;
        let weights = |v: DVec3| {
            let (p, q) = (v.dot(e), v.dot(f));
            if area <= 0.0 { DVec2::ZERO } else { DVec2::new(ff * p - ef * q, ee * q - ef * p) / area }
        };
        let beside = |x: f64, y: f64| {
            let (start, along) = view.ray(x, y);
            let to = start + along * ((a - start).dot(normal) / along.dot(normal));
            if to.is_finite() { weights(to - point) } else { DVec2::ZERO }
        };
        Footprint { at: weights(point - a), sides: [beside(x + 1.0, y), beside(x, y + 1.0)] }
    }

    fn sample(&self, texture: &Texture, corners: &Corners) -> [f32; 4] {
        let [a, b, c] = corners.map(|[u, v]| DVec2::new(u.into(), v.into()));
        let (e, f) = (b - a, c - a);
        let along = |weights: DVec2| e * weights.x + f * weights.y;
        texture.sample(a + along(self.at), self.sides.map(along))
    }
}

impl Scene {
    /// The paint of a triangle at a point that a sample shows, with the images on it.
    pub(super) fn paint_at(&self, triangle: &Triangle, view: &View, sample: [f64; 2], point: DVec3) -> Paint {
        let mut paint = self.paints[triangle.paint as usize];
        let Some(corners) = self.textures.corners.get(triangle.uvs as usize) else { return paint };
        let footprint = Footprint::of(triangle, view, sample, point);
        if let (Some(map), Some(corners)) = (paint.maps.color, &corners[0]) {
            let [r, g, b, _] = footprint.sample(&self.textures.list[map.texture as usize], corners);
            paint.color = [paint.color[0] * r, paint.color[1] * g, paint.color[2] * b];
        }
        if let (Some((map, alpha)), Some(corners)) = (paint.maps.opacity, &corners[1]) {
            let [.., opacity] = footprint.sample(&self.textures.list[map.texture as usize], corners);
            paint.opacity = match alpha {
                Alpha::Blend => paint.opacity * opacity,
                Alpha::Mask(cutoff) if paint.opacity * opacity < cutoff => 0.0,
                Alpha::Mask(_) => 1.0,
            };
        }
        paint
    }

    /// The opacity of a triangle on the whole.
    pub(super) fn mean_opacity(&self, triangle: &Triangle) -> f32 {
        let paint = &self.paints[triangle.paint as usize];
        match paint.maps.opacity {
            Some((map, _)) if triangle.uvs != PLAIN => {
                paint.opacity * self.textures.list[map.texture as usize].mean()[3]
            }
            _ => paint.opacity,
        }
    }
}
