//! Materials and colours.

use crate::text::Text;

/// An sRGB colour, each channel in 0..=1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Color {
    /// Red.
    pub r: f64,
    /// Green.
    pub g: f64,
    /// Blue.
    pub b: f64,
}

impl Color {
    /// CGA's default colour.
    pub const WHITE: Color = Color { r: 1.0, g: 1.0, b: 1.0 };

    /// From three channels, clamped to 0..=1; a channel that is not a number counts as 0.
    pub fn new(r: f64, g: f64, b: f64) -> Self {
        let clamp = |c: f64| if c.is_nan() { 0.0 } else { c.clamp(0.0, 1.0) };
        Color { r: clamp(r), g: clamp(g), b: clamp(b) }
    }
}

/// The look of a shape or of faces of a mesh. What is `None` is not set: a shape's unset attribute lets the mesh's own
/// material through, and what neither sets has CGA's default (white, opaque, roughness 1, metallic 0).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Material {
    /// `material.name`; of an imported mesh, the name in its file.
    pub name: Option<Text>,
    /// Diffuse colour, `material.color`.
    pub color: Option<Color>,
    /// 1 is opaque, `material.opacity`.
    pub opacity: Option<f64>,
    /// Path of the colour map, `texture(…)`. Empty text means "no texture".
    pub texture: Option<Text>,
    /// `material.metallic`.
    pub metallic: Option<f64>,
    /// `material.roughness`.
    pub roughness: Option<f64>,
}

impl Material {
    /// Nothing set.
    pub const UNSET: Material =
        Material { name: None, color: None, opacity: None, texture: None, metallic: None, roughness: None };

    /// The diffuse colour, white when unset.
    pub fn color(&self) -> Color {
        self.color.unwrap_or(Color::WHITE)
    }

    /// The opacity, 1 when unset.
    pub fn opacity(&self) -> f64 {
        self.opacity.unwrap_or(1.0)
    }

    /// This material with everything it leaves unset taken from `base` (*i*: attributes set in rules win over the asset's).
    pub fn over(&self, base: &Material) -> Material {
        Material {
            name: self.name.clone().or_else(|| base.name.clone()),
            color: self.color.or(base.color),
            opacity: self.opacity.or(base.opacity),
            texture: self.texture.clone().or_else(|| base.texture.clone()),
            metallic: self.metallic.or(base.metallic),
            roughness: self.roughness.or(base.roughness),
        }
    }
}
