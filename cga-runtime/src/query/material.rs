//! `getMaterial`.

use crate::func::{bool_to_text, float_to_text};
use crate::material::{MATERIAL_NUMBERS, MATERIAL_TEXTS, Material};
use crate::run::env::Env;
use crate::shape::Shape;
use crate::value::array::Array;
use crate::value::text::Text;

/// The material that `getMaterial` reads.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MaterialSource {
    /// The visible material: attributes set by rules over the attributes of the geometry.
    Used,
    /// The attributes set by rules.
    Shape,
    /// The material of the geometry; if there are several, the first.
    Geometry,
}

/// The attributes that `getMaterial` reads.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MaterialMode {
    /// The attributes that are set.
    Changed,
    /// All attributes, with their defaults.
    All,
}

/// `getMaterial(used | shape | geometry, changed | all)`: a row with name and value for each attribute, sorted by
/// name (*getMaterial function*). `setMaterial` takes this array.
pub fn get_material(env: &mut Env, shape: &Shape, source: MaterialSource, mode: MaterialMode) -> Array<Text> {
    let own = || shape.own_material().unwrap_or(&Material::UNSET);
    let material = match source {
        MaterialSource::Shape => shape.material().clone(),
        MaterialSource::Geometry => own().clone(),
        MaterialSource::Used => shape.material().over(own()),
    };
    let all = mode == MaterialMode::All;
    let mut rows: Vec<[Text; 2]> = Vec::new();
    // The deprecated name is a synonym of `opacity`.
    for (name, which) in MATERIAL_NUMBERS.iter().filter(|(name, _)| *name != "color.a") {
        let value = material.number(*which).or_else(|| all.then(|| which.default_value()));
        rows.extend(value.map(|value| [Text::fixed(name), float_to_text(value)]));
    }
    for (name, which) in MATERIAL_TEXTS {
        let value = material.text(*which).cloned().or_else(|| all.then(|| Text::fixed(which.default_value())));
        rows.extend(value.map(|value| [Text::fixed(name), value]));
    }
    let sides = material.double_sided.or_else(|| all.then_some(true));
    rows.extend(sides.map(|sides| [Text::fixed("doubleSided"), bool_to_text(sides)]));
    rows.sort();
    if !env.may_hold(2 * rows.len()) {
        return Array::default();
    }
    Array::from(rows.into_iter().map(Vec::from).collect::<Vec<_>>())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::op;
    use crate::shape::Shape;

    #[test]
    fn a_material_is_read_as_the_reference_shows_it() {
        // *getMaterial function*, example 1.
        let (env, shape) = (&mut Env::for_tests(), &mut Shape::cuboid(1.0, 1.0, 1.0));
        op::color_rgb(env, shape, 0.5, 0.6, 0.7);
        let changed = get_material(env, shape, MaterialSource::Used, MaterialMode::Changed);
        assert_eq!(changed.to_string(), "(3x2)\n   color.b   0.7\n   color.g   0.6\n   color.r   0.5");
        assert!(get_material(env, shape, MaterialSource::Geometry, MaterialMode::Changed).is_empty());
    }

    #[test]
    fn what_is_read_can_be_set() {
        let (env, shape) = (&mut Env::for_tests(), &mut Shape::cuboid(1.0, 1.0, 1.0));
        let all = get_material(env, shape, MaterialSource::Shape, MaterialMode::All);
        assert_eq!((all.rows(), all.columns()), (12 + 7 + 50 + 13 + 1, 2));
        op::set_material(env, shape, all.clone());
        assert_eq!(env.take_faults().0.len(), 0);
        assert_eq!(get_material(env, shape, MaterialSource::Shape, MaterialMode::Changed), all);
        op::reset_material(env, shape, op::MaterialTarget::Shape);
        assert!(get_material(env, shape, MaterialSource::Shape, MaterialMode::Changed).is_empty());
    }
}
