//! Texture layers of a material: image, set of coordinates, and placement of the image.

use glam::DVec2;

use crate::material::{Layer, LayerPart, Material, MaterialNumber, MaterialText};
use crate::value::text::Text;

/// The placement of a texture on its layer (*material.map attribute*). Coordinates are scaled by `su`, `sv`, then
/// turned about (0, 0) by `rw`, anticlockwise as `rotateUV` turns them, then moved by `tu`, `tv`. The order and the
/// direction are inferred.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Placement {
    pub(crate) scale: DVec2,
    /// In degrees.
    pub(crate) turn: f64,
    pub(crate) offset: DVec2,
}

/// The affine form of a placement.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct PlacementMap {
    /// The coefficients of u and v in the first coordinate, and in the second.
    pub(crate) rows: [DVec2; 2],
    pub(crate) offset: DVec2,
}

impl Placement {
    /// The placement that does not change coordinates.
    #[cfg(feature = "gltf")]
    pub(crate) const PLAIN: Placement = Placement { scale: DVec2::ONE, turn: 0.0, offset: DVec2::ZERO };

    /// The placement of a layer of a material.
    pub(crate) fn of(material: &Material, layer: Layer) -> Self {
        let number = |part| {
            let which = MaterialNumber::Map(layer, part);
            // Beyond this, 32-bit floats would not be finite.
            material.number(which).filter(|number| number.abs() <= 1e30).unwrap_or(which.default_value())
        };
        Placement {
            scale: DVec2::new(number(LayerPart::Su), number(LayerPart::Sv)),
            turn: number(LayerPart::Rw) % 360.0,
            offset: DVec2::new(number(LayerPart::Tu), number(LayerPart::Tv)),
        }
    }

    /// The sine and the cosine of the turn; exact for multiples of 90 degrees.
    pub(crate) fn sin_cos(&self) -> (f64, f64) {
        match self.turn.rem_euclid(360.0) {
            0.0 => (0.0, 1.0),
            90.0 => (1.0, 0.0),
            180.0 => (0.0, -1.0),
            270.0 => (-1.0, 0.0),
            turn => libm::sincos(turn.to_radians()),
        }
    }

    /// The affine form.
    pub(crate) fn map(&self) -> PlacementMap {
        let ((sin, cos), scale) = (self.sin_cos(), self.scale);
        let rows = [DVec2::new(cos * scale.x, -sin * scale.y), DVec2::new(sin * scale.x, cos * scale.y)];
        PlacementMap { rows, offset: self.offset }
    }
}

impl PlacementMap {
    /// The image coordinates for coordinates of a surface.
    #[inline]
    pub(crate) fn at(&self, uv: DVec2) -> DVec2 {
        DVec2::new(self.rows[0].dot(uv), self.rows[1].dot(uv)) + self.offset
    }
}

/// The texture for a missing file (*CGA changelog*).
pub(crate) const UNKNOWN_TEXTURE: &str = "builtin:unknowntexture.png";

/// The image of a layer, if it has one that can be shown.
pub(crate) fn image(material: &Material, layer: Layer) -> Option<&Text> {
    let is_shown = |name: &Text| !name.is_empty() && (layer.shows_checkers() || name.as_str() != UNKNOWN_TEXTURE);
    material.text(MaterialText::Map(layer)).filter(|name| is_shown(name))
}

/// The set that a layer uses on a mesh with the sets `sets`: its own, otherwise set 0. `None` if both are missing
/// (*Texturing: essential knowledge*).
pub(crate) fn set(layer: Layer, sets: SetMask) -> Option<usize> {
    [layer.uv_set(), 0].into_iter().find(|&set| sets.has(set))
}

/// The sets of a mesh or a leaf.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub(crate) struct SetMask(pub(crate) u16);

impl SetMask {
    /// The sets for which a condition holds. Each layer has a set.
    pub(crate) fn of(has: impl Fn(usize) -> bool) -> Self {
        SetMask((0..Layer::ALL.len()).filter(|&set| has(set)).fold(0, |mask, set| mask | 1 << set))
    }

    pub(crate) fn has(self, set: usize) -> bool {
        self.0 >> set & 1 == 1
    }

    /// The number of sets below `set`.
    #[cfg(feature = "gltf")]
    pub(crate) fn rank(self, set: usize) -> usize {
        (self.0 & ((1 << set) - 1)).count_ones() as usize
    }

    /// The sets, in order.
    pub(crate) fn sets(self) -> impl Iterator<Item = usize> {
        (0..Layer::ALL.len()).filter(move |&set| self.has(set))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_layer_uses_its_own_set_or_set_0() {
        let mask = |sets: &[usize]| SetMask::of(|set| sets.contains(&set));
        assert_eq!(set(Layer::Color, mask(&[0, 2])), Some(0));
        assert_eq!(set(Layer::Dirt, mask(&[0, 2])), Some(2));
        assert_eq!(set(Layer::Metallic, mask(&[0, 9])), Some(9));
        assert_eq!(set(Layer::Normal, mask(&[0, 2])), Some(0));
        assert_eq!(set(Layer::Normal, mask(&[2])), None);
    }

    #[test]
    fn coordinates_are_scaled_then_turned_then_moved() {
        let mut material = Material::UNSET;
        assert_eq!(Placement::of(&material, Layer::Color).map().at(DVec2::new(3.0, 4.0)), DVec2::new(3.0, 4.0));
        let parts = [
            (LayerPart::Su, 2.0),
            (LayerPart::Sv, 3.0),
            (LayerPart::Rw, 90.0),
            (LayerPart::Tu, 0.5),
            (LayerPart::Tv, 1.0),
        ];
        for (part, value) in parts {
            material.set_number(MaterialNumber::Map(Layer::Dirt, part), value);
        }
        let map = Placement::of(&material, Layer::Dirt).map();
        assert_eq!(map.at(DVec2::new(1.0, 0.0)), DVec2::new(0.5, 3.0));
        assert_eq!(map.at(DVec2::new(0.0, 1.0)), DVec2::new(-2.5, 1.0));
    }
}
