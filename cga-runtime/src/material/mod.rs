//! Materials and colours.

pub(crate) mod attribute;
pub(crate) mod layer;
pub(crate) mod list;

use std::hash::Hash;
use std::sync::Arc;

use crate::fixed_hash::FixedHasher;
use crate::geometry::each::Each;

pub use attribute::{Channel, ColorOf, Layer, LayerPart, MaterialNumber, MaterialText};
pub(crate) use attribute::{MATERIAL_NUMBERS, MATERIAL_TEXTS};

use crate::value::text::Text;

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

    /// The channel of an open colour, which no channel of a colour has.
    const OPEN_CHANNEL: f64 = -1e300;

    /// The colour of a template that each repetition paints.
    const OPEN: Color = Color { r: Color::OPEN_CHANNEL, g: Color::OPEN_CHANNEL, b: Color::OPEN_CHANNEL };

    /// A colour of three channels, clamped to 0..=1. NaN counts as 0.
    pub fn new(r: f64, g: f64, b: f64) -> Self {
        let clamp = |c: f64| if c.is_nan() { 0.0 } else { c.clamp(0.0, 1.0) };
        Color { r: clamp(r), g: clamp(g), b: clamp(b) }
    }
}

/// The material of a shape or of faces of a mesh. `None` means unset: a shape's unset attributes come from the mesh's
/// own material, and attributes unset in both have CGA's defaults (white, opaque, roughness 1, metallic 0).
///
/// Frequent attributes are fields. The rest of the *material attribute* page has access by name: [`Material::number`]
/// and [`Material::text`], which also cover the fields.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Material {
    /// `material.name`; for an imported mesh, the name in its file.
    pub name: Option<Text>,
    /// The diffuse colour, `material.color`.
    pub color: Option<Color>,
    /// The opacity, `material.opacity`; 1 is opaque.
    pub opacity: Option<f64>,
    /// The path of the colour map, `texture(…)`. Empty text means "no texture".
    pub texture: Option<Text>,
    /// `material.metallic`.
    pub metallic: Option<f64>,
    /// `material.roughness`.
    pub roughness: Option<f64>,
    /// `material.doubleSided`; true when unset.
    pub double_sided: Option<bool>,
    pub(crate) more: Option<Arc<More>>,
}

/// The set attributes that are not fields, in sorted lists. Materials are cloned often, and few have any.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct More {
    numbers: Vec<(MaterialNumber, f64)>,
    texts: Vec<(MaterialText, Text)>,
}

impl Material {
    /// The material without set attributes.
    pub const UNSET: Material = Material {
        name: None,
        color: None,
        opacity: None,
        texture: None,
        metallic: None,
        roughness: None,
        double_sided: None,
        more: None,
    };

    /// The material with the attributes that `change` sets.
    pub fn with(change: impl FnOnce(&mut Material)) -> Self {
        let mut material = Material::UNSET;
        change(&mut material);
        material
    }

    /// The material with an open colour in place of its own, if it has one.
    pub(crate) fn open(&self) -> Option<Material> {
        self.color.map(|_| Material { color: Some(Color::OPEN), ..self.clone() })
    }

    /// Returns true if both materials have a colour, and all else is equal.
    pub(crate) fn is_equal_except_color(&self, other: &Material) -> bool {
        let Material { name, color, opacity, texture, metallic, roughness, double_sided, more } = self;
        color.is_some()
            && other.color.is_some()
            && (opacity, metallic, roughness) == (&other.opacity, &other.metallic, &other.roughness)
            && (name, texture, more) == (&other.name, &other.texture, &other.more)
            && *double_sided == other.double_sided
    }

    /// The material with the channels of `color` in place of open ones, if it has some.
    pub(crate) fn painted(&self, color: Color) -> Option<Material> {
        let own = self.color.filter(|own| [own.r, own.g, own.b].contains(&Color::OPEN_CHANNEL))?;
        let channel = |own: f64, painted: f64| if own == Color::OPEN_CHANNEL { painted } else { own };
        let [r, g, b] = [channel(own.r, color.r), channel(own.g, color.g), channel(own.b, color.b)];
        Some(Material { color: Some(Color { r, g, b }), ..self.clone() })
    }

    /// Adds the set attributes to a hash.
    pub(crate) fn hash(&self, hasher: &mut FixedHasher) {
        let color = self.color.map(|Color { r, g, b }| [r, g, b].map(f64::to_bits));
        let numbers = [self.opacity, self.metallic, self.roughness].map(|number| number.map(f64::to_bits));
        (color, numbers, self.double_sided).hash(hasher);
        [&self.name, &self.texture].map(|text| text.as_ref().map(Text::as_str)).hash(hasher);
        self.more_numbers().iter().for_each(|(_, number)| number.to_bits().hash(hasher));
        self.more_texts().iter().for_each(|(_, text)| text.as_str().hash(hasher));
    }

    /// The bytes of the texts.
    pub(crate) fn text_bytes(&self) -> u64 {
        let own = [&self.name, &self.texture].into_iter().flatten();
        own.chain(self.more_texts().iter().map(|(_, text)| text)).map(|text| text.len() as u64).sum()
    }

    /// The diffuse colour; white if unset.
    pub fn color(&self) -> Color {
        self.color.unwrap_or(Color::WHITE)
    }

    /// The opacity; 1 if unset.
    pub fn opacity(&self) -> f64 {
        self.opacity.unwrap_or(1.0)
    }

    /// The value of a numeric attribute, if it is set.
    pub fn number(&self, which: MaterialNumber) -> Option<f64> {
        match which {
            MaterialNumber::Color(Channel::R) => self.color.map(|color| color.r),
            MaterialNumber::Color(Channel::G) => self.color.map(|color| color.g),
            MaterialNumber::Color(Channel::B) => self.color.map(|color| color.b),
            MaterialNumber::Opacity => self.opacity,
            MaterialNumber::Metallic => self.metallic,
            MaterialNumber::Roughness => self.roughness,
            _ => found(self.more_numbers(), which).copied(),
        }
    }

    /// Sets a numeric attribute, moved into its range. NaN is ignored. The first channel that is set of the diffuse
    /// colour sets the other two to white.
    pub fn set_number(&mut self, which: MaterialNumber, value: f64) {
        if value.is_nan() {
            return;
        }
        let value = which.clamp(value);
        match which {
            MaterialNumber::Color(channel) => {
                let color = self.color.get_or_insert(Color::WHITE);
                match channel {
                    Channel::R => color.r = value,
                    Channel::G => color.g = value,
                    Channel::B => color.b = value,
                }
            }
            MaterialNumber::Opacity => self.opacity = Some(value),
            MaterialNumber::Metallic => self.metallic = Some(value),
            MaterialNumber::Roughness => self.roughness = Some(value),
            _ => put(&mut Arc::make_mut(self.more.get_or_insert_default()).numbers, which, value),
        }
    }

    /// The value of a textual attribute, if it is set.
    pub fn text(&self, which: MaterialText) -> Option<&Text> {
        match which {
            MaterialText::Name => self.name.as_ref(),
            MaterialText::Map(Layer::Color) => self.texture.as_ref(),
            _ => found(self.more_texts(), which),
        }
    }

    /// Sets a textual attribute.
    pub fn set_text(&mut self, which: MaterialText, value: impl Into<Text>) {
        let value = value.into();
        match which {
            MaterialText::Name => self.name = Some(value),
            MaterialText::Map(Layer::Color) => self.texture = Some(value),
            _ => put(&mut Arc::make_mut(self.more.get_or_insert_default()).texts, which, value),
        }
    }

    /// The colour of three channels, if one of them is set. Unset channels have their defaults.
    pub fn channels(&self, which: ColorOf) -> Option<Color> {
        let set = [Channel::R, Channel::G, Channel::B].each(|channel| self.number(which(channel)));
        let value = |at: usize, channel| set[at].unwrap_or(which(channel).default_value());
        set.iter().any(Option::is_some).then(|| Color {
            r: value(0, Channel::R),
            g: value(1, Channel::G),
            b: value(2, Channel::B),
        })
    }

    /// This material with unset attributes taken from `base` (*i operation*: attributes set by rules override the
    /// attributes of the asset).
    pub fn over(&self, base: &Material) -> Material {
        let mut sum = Material {
            name: self.name.clone().or_else(|| base.name.clone()),
            color: self.color.or(base.color),
            opacity: self.opacity.or(base.opacity),
            texture: self.texture.clone().or_else(|| base.texture.clone()),
            metallic: self.metallic.or(base.metallic),
            roughness: self.roughness.or(base.roughness),
            double_sided: self.double_sided.or(base.double_sided),
            more: base.more.clone(),
        };
        if sum.more.is_none() {
            sum.more.clone_from(&self.more);
            return sum;
        }
        self.more_numbers().iter().for_each(|(which, value)| sum.set_number(*which, *value));
        self.more_texts().iter().for_each(|(which, value)| sum.set_text(*which, value.clone()));
        sum
    }

    /// The numeric attributes that are not fields, sorted.
    pub(crate) fn more_numbers(&self) -> &[(MaterialNumber, f64)] {
        self.more.as_ref().map_or(&[], |more| &more.numbers)
    }

    /// The textual attributes that are not fields, sorted.
    pub(crate) fn more_texts(&self) -> &[(MaterialText, Text)] {
        self.more.as_ref().map_or(&[], |more| &more.texts)
    }
}

fn found<K: Ord + Copy, V>(list: &[(K, V)], key: K) -> Option<&V> {
    list.binary_search_by_key(&key, |entry| entry.0).ok().map(|at| &list[at].1)
}

fn put<K: Ord + Copy, V>(list: &mut Vec<(K, V)>, key: K, value: V) {
    match list.binary_search_by_key(&key, |entry| entry.0) {
        Ok(at) => list[at].1 = value,
        Err(at) => list.insert(at, (key, value)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_material_stays_small() {
        assert!(size_of::<Material>() <= 144, "{}", size_of::<Material>());
    }

    #[test]
    fn what_is_set_is_read_and_the_rest_comes_from_below() {
        let (ambient, shininess) = (MaterialNumber::Ambient(Channel::G), MaterialNumber::Shininess);
        let dirt = MaterialText::Map(Layer::Dirt);
        let mut top = Material::UNSET;
        top.set_number(ambient, 7.0);
        top.set_number(shininess, f64::NAN);
        top.set_text(dirt, "a.png");
        assert_eq!((top.number(ambient), top.number(shininess)), (Some(1.0), None));
        let mut base = Material::UNSET;
        base.set_number(shininess, 500.0);
        base.set_number(ambient, 0.5);
        base.set_text(dirt, "b.png");
        base.set_text(MaterialText::Shader, "s");
        let sum = top.over(&base);
        assert_eq!((sum.number(ambient), sum.number(shininess)), (Some(1.0), Some(128.0)));
        assert_eq!(sum.text(dirt).map(|text| text.as_str()), Some("a.png"));
        assert_eq!(sum.text(MaterialText::Shader).map(|text| text.as_str()), Some("s"));
        assert_eq!((top.over(&Material::UNSET), Material::UNSET.over(&base)), (top.clone(), base));
        assert_eq!(sum.channels(MaterialNumber::Ambient), Some(Color { r: 0.0, g: 1.0, b: 0.0 }));
        assert_eq!(sum.channels(MaterialNumber::Emissive), None);
    }
}
