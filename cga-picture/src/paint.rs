//! The look of surfaces.

use glam::Vec3;

/// An image of a scene; see [`Scene::add_image`](crate::Scene::add_image).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct ImageId(pub(crate) u32);

/// A paint of a scene; see [`Scene::add_paint`](crate::Scene::add_paint).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct PaintId(pub(crate) u32);

/// The effect of an image for opacity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Alpha {
    /// The surface is mixed with the surface behind it.
    Blend,
    /// The surface is opaque from this opacity on, from 0 to 1, and otherwise invisible.
    Mask(f32),
}

/// The look of a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Paint {
    /// Red, green and blue in linear light, from 0 to 1. [`linear`](crate::linear) converts sRGB.
    pub color: Vec3,
    /// The opacity, from 0 to 1.
    pub opacity: f32,
    /// The share of a metal, 0 or 1 as a rule.
    pub metallic: f32,
    /// The strength of reflections, from 0 (matte) to 1 (polished).
    pub gloss: f32,
    /// The image by which the colour is multiplied, on faces with [`Face::color_uvs`](crate::Face::color_uvs).
    pub color_image: Option<ImageId>,
    /// The image whose alpha channel is multiplied by the opacity, on faces with
    /// [`Face::opacity_uvs`](crate::Face::opacity_uvs), and its effect.
    pub opacity_image: Option<(ImageId, Alpha)>,
    /// The normal map, an image of [`Scene::add_normal_map`](crate::Scene::add_normal_map), on faces with
    /// [`Face::normal_uvs`](crate::Face::normal_uvs).
    pub normal_image: Option<ImageId>,
}

impl Default for Paint {
    /// White, opaque and matte.
    fn default() -> Self {
        Paint {
            color: Vec3::ONE,
            opacity: 1.0,
            metallic: 0.0,
            gloss: 0.0,
            color_image: None,
            opacity_image: None,
            normal_image: None,
        }
    }
}
