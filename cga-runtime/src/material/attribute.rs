//! The attributes of a material by name (*material attribute*, *material.map attribute*).

/// A channel of a colour.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Channel {
    /// Red.
    R,
    /// Green.
    G,
    /// Blue.
    B,
}

/// The constructor of a colour's channels: `MaterialNumber::Color` and so on.
pub type ColorOf = fn(Channel) -> MaterialNumber;

/// A texture layer. Its number is the number of its uv set.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Layer {
    /// `colormap`.
    Color,
    /// `bumpmap`.
    Bump,
    /// `dirtmap`.
    Dirt,
    /// `specularmap`.
    Specular,
    /// `opacitymap`.
    Opacity,
    /// `normalmap`.
    Normal,
    /// `emissivemap`.
    Emissive,
    /// `occlusionmap`.
    Occlusion,
    /// `roughnessmap`.
    Roughness,
    /// `metallicmap`.
    Metallic,
}

impl Layer {
    /// Returns true for the layers in which a checker pattern takes the place of an image that is missing.
    pub(crate) fn shows_checkers(self) -> bool {
        matches!(self, Layer::Color | Layer::Opacity | Layer::Emissive)
    }

    /// All layers, in the order of their uv sets.
    pub const ALL: [Layer; 10] = [
        Layer::Color,
        Layer::Bump,
        Layer::Dirt,
        Layer::Specular,
        Layer::Opacity,
        Layer::Normal,
        Layer::Emissive,
        Layer::Occlusion,
        Layer::Roughness,
        Layer::Metallic,
    ];

    /// The number of its uv set, 0 to 9.
    pub fn uv_set(self) -> usize {
        self as usize
    }
}

/// The placement of a texture on its layer: `su`, `sv` scale it, `tu`, `tv` move it, `rw` turns it, in degrees.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[allow(missing_docs, reason = "see above")]
pub enum LayerPart {
    Su,
    Sv,
    Tu,
    Tv,
    Rw,
}

/// A numeric attribute of a material.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum MaterialNumber {
    /// `color.r` and so on: the diffuse colour.
    Color(Channel),
    /// `ambient.r` and so on.
    Ambient(Channel),
    /// `specular.r` and so on.
    Specular(Channel),
    /// `emissive.r` and so on.
    Emissive(Channel),
    /// The opacity; 1 is opaque.
    Opacity,
    /// The reflectivity; 1 reflects everything.
    Reflectivity,
    /// Phong's exponent, up to 128.
    Shininess,
    /// The scale of the bump map.
    BumpValue,
    /// The metalness; 1 is a metal.
    Metallic,
    /// The roughness; 0 is smooth.
    Roughness,
    /// `opacitymap.cutoff`.
    Cutoff,
    /// `colormap.su` and so on.
    Map(Layer, LayerPart),
}

/// A textual attribute of a material.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum MaterialText {
    /// `name`.
    Name,
    /// `shader`.
    Shader,
    /// The path of a texture; empty text means "no texture".
    Map(Layer),
    /// `opacitymap.mode`: `blend`, `mask` or `opaque`.
    OpacityMode,
}

impl MaterialNumber {
    /// The value of an unset attribute.
    pub fn default_value(self) -> f64 {
        use LayerPart::{Su, Sv};
        match self {
            MaterialNumber::Color(_)
            | MaterialNumber::Opacity
            | MaterialNumber::Shininess
            | MaterialNumber::BumpValue
            | MaterialNumber::Roughness
            | MaterialNumber::Map(_, Su | Sv) => 1.0,
            MaterialNumber::Cutoff => 0.5,
            _ => 0.0,
        }
    }

    /// The number moved into the range of the attribute.
    pub(crate) fn clamp(self, value: f64) -> f64 {
        match self {
            MaterialNumber::BumpValue | MaterialNumber::Map(..) => value,
            MaterialNumber::Shininess => value.clamp(0.0, 128.0),
            _ => value.clamp(0.0, 1.0),
        }
    }
}

impl MaterialText {
    /// The value of an unset attribute.
    pub fn default_value(self) -> &'static str {
        match self {
            MaterialText::Shader => "CityEngineShader",
            MaterialText::OpacityMode => "blend",
            MaterialText::Name | MaterialText::Map(_) => "",
        }
    }

    /// Returns true if the attribute may have that value.
    pub(crate) fn accepts(self, value: &str) -> bool {
        self != MaterialText::OpacityMode || matches!(value, "blend" | "mask" | "opaque")
    }
}

impl MaterialNumber {
    /// The attribute with a name, without the prefix `material.`.
    pub(crate) fn named(name: &str) -> Option<Self> {
        MATERIAL_NUMBERS.iter().find(|(known, _)| *known == name).map(|(_, which)| *which)
    }
}

impl MaterialText {
    /// The attribute with a name, without the prefix `material.`.
    pub(crate) fn named(name: &str) -> Option<Self> {
        MATERIAL_TEXTS.iter().find(|(known, _)| *known == name).map(|(_, which)| *which)
    }
}

macro_rules! names {
    ($($function:ident $name:literal $which:expr;)*) => {
        &[$(($name, $which),)*]
    };
}

/// The names of numeric attributes, without the prefix `material.`.
pub(crate) const MATERIAL_NUMBERS: &[(&str, MaterialNumber)] = super::list::each_material_number!(names);
/// The names of textual attributes, without the prefix `material.`.
pub(crate) const MATERIAL_TEXTS: &[(&str, MaterialText)] = super::list::each_material_text!(names);

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_attribute_of_the_page_has_its_name() {
        let maps = ["color", "bump", "dirt", "specular", "opacity", "normal"];
        let maps = maps.into_iter().chain(["emissive", "occlusion", "roughness", "metallic"]);
        let parts = ["", ".su", ".sv", ".tu", ".tv", ".rw"];
        let maps = maps.flat_map(|map| parts.map(|part| format!("{map}map{part}")));
        let colors = ["color", "ambient", "specular", "emissive"];
        let colors = colors.iter().flat_map(|color| ["r", "g", "b"].map(|channel| format!("{color}.{channel}")));
        let others = "color.a opacity reflectivity shininess bumpValue metallic roughness name shader";
        let others = others.split(' ').chain(["opacitymap.mode", "opacitymap.cutoff"]).map(str::to_owned);
        let all: Vec<String> = maps.chain(colors).chain(others).collect();
        let is_named = |name: &str| MaterialNumber::named(name).is_some() || MaterialText::named(name).is_some();
        assert!(all.iter().all(|name| is_named(name)), "{all:?}");
        assert_eq!(all.len(), MATERIAL_NUMBERS.len() + MATERIAL_TEXTS.len());
        assert!(["", "Color.r", "material.name", "colormap.xu"].iter().all(|name| !is_named(name)));
    }

    #[test]
    fn names_and_what_they_mean_are_one_to_one() {
        for (at, (name, which)) in MATERIAL_NUMBERS.iter().enumerate() {
            let twin = MATERIAL_NUMBERS[..at].iter().find(|(_, other)| other == which);
            assert!(twin.is_none() || *which == MaterialNumber::Opacity, "{name}");
            if let MaterialNumber::Map(layer, part) = which {
                let (map, end) = name.split_once('.').unwrap();
                assert_eq!(format!("{layer:?}map").to_lowercase(), map);
                assert_eq!(format!("{part:?}").to_lowercase(), end);
            }
        }
    }
}
