//! Numbers for rule names and materials, in the order of first use.
//!
//! A leaf usually has the rule or the material of a recent leaf, at the same address. So addresses are compared
//! first, and text or values are looked up only for other addresses. An address is valid only while the table itself
//! keeps the value at it alive.

use std::collections::HashMap;
use std::fmt;
use std::hash::{Hash, Hasher};
use std::sync::Arc;

use crate::geometry::each::Each;
use crate::geometry::mesh::{FaceTag, Materials};
use crate::material::{Material, MaterialNumber};
use crate::value::text::Text;

/// Interned rule names and materials. Equal leaves in equal order give equal numbers.
#[derive(Clone, Default)]
pub struct SinkTable {
    rules: Vec<Text>,
    /// Only for look-ups, never iterated.
    rule_numbers: HashMap<Text, u32>,
    /// Recently used rules, by address. Holding them keeps their addresses from being reused.
    recent_rules: [Option<(Text, u32)>; RECENT],
    materials: Vec<Arc<Material>>,
    /// Only for look-ups, never iterated.
    material_numbers: HashMap<ByBits, u32>,
    /// Recently used materials, by address. Holding them keeps their addresses from being reused.
    recent_materials: [Option<(Arc<Material>, u32)>; RECENT],
    faces: FaceMaterials,
}

/// The materials of a mesh's faces under a shape's material, from the last look-up.
#[derive(Clone, Debug, Default)]
struct FaceMaterials {
    shape: u32,
    of: Materials,
    ids: Vec<Option<u32>>,
}

/// The number of recent rules and materials. Leaves of a façade alternate between a few.
const RECENT: usize = 16;

/// The index of a value among the recent ones, by its address.
#[inline]
fn recent_place<T>(address: *const T) -> usize {
    ((address.addr() as u64).wrapping_mul(0x9e37_79b9_7f4a_7c15) >> 60) as usize
}

impl fmt::Debug for SinkTable {
    /// Writes the contents, without the look-up tables, which differ between equal tables.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let SinkTable { rules, materials, .. } = self;
        f.debug_struct("SinkTable").field("rules", rules).field("materials", materials).finish_non_exhaustive()
    }
}

impl SinkTable {
    /// An empty table.
    pub fn new() -> Self {
        SinkTable::default()
    }

    /// The rule names by number.
    pub fn rules(&self) -> &[Text] {
        &self.rules
    }

    /// The materials by number.
    pub fn materials(&self) -> &[Arc<Material>] {
        &self.materials
    }

    /// Removes all entries but keeps the memory.
    pub fn clear(&mut self) {
        self.rules.clear();
        self.rule_numbers.clear();
        self.recent_rules = Default::default();
        self.materials.clear();
        self.material_numbers.clear();
        self.recent_materials = Default::default();
        self.faces = FaceMaterials::default();
    }

    /// The number of a rule name.
    #[inline]
    pub fn rule(&mut self, name: &Text) -> u32 {
        match &self.recent_rules[recent_place(name.as_ptr())] {
            Some((known, id)) if std::ptr::eq(known.as_str(), name.as_str()) => *id,
            _ => self.other_rule(name),
        }
    }

    /// The number of a material.
    #[inline]
    pub fn material(&mut self, material: &Arc<Material>) -> u32 {
        match &self.recent_materials[recent_place(Arc::as_ptr(material))] {
            Some((known, id)) if Arc::ptr_eq(known, material) => *id,
            _ => self.other_material(material),
        }
    }

    /// The number of a face's visible material: the shape's material over the mesh's material of the face. `index`
    /// refers to `materials`; an index out of range means the shape's own material.
    pub fn face_material(&mut self, shape: u32, materials: &Materials, index: u32) -> u32 {
        if index == FaceTag::NONE {
            return shape;
        }
        if self.faces.shape != shape || !self.faces.of.is_same_list(materials) {
            let ids = vec![None; materials.list::<Material>().len()];
            self.faces = FaceMaterials { shape, of: materials.clone(), ids };
        }
        match self.faces.ids.get(index as usize) {
            Some(None) => {}
            Some(Some(id)) => return *id,
            None => return shape,
        }
        let base = &materials.list::<Material>()[index as usize];
        let id = self.intern(Arc::new(self.materials[shape as usize].over(base)));
        self.faces.ids[index as usize] = Some(id);
        id
    }

    #[inline(never)]
    fn other_rule(&mut self, name: &Text) -> u32 {
        let rules = &mut self.rules;
        let id = *self.rule_numbers.entry(name.clone()).or_insert_with(|| {
            rules.push(name.clone());
            (rules.len() - 1) as u32
        });
        self.recent_rules[recent_place(name.as_ptr())] = Some((name.clone(), id));
        id
    }

    #[inline(never)]
    fn other_material(&mut self, material: &Arc<Material>) -> u32 {
        let id = self.intern(material.clone());
        self.recent_materials[recent_place(Arc::as_ptr(material))] = Some((material.clone(), id));
        id
    }

    fn intern(&mut self, material: Arc<Material>) -> u32 {
        let materials = &mut self.materials;
        *self.material_numbers.entry(ByBits(material)).or_insert_with_key(|key| {
            materials.push(key.0.clone());
            (materials.len() - 1) as u32
        })
    }
}

/// A material, compared by the bits of its numbers. Unlike with `==`, a material that contains NaN equals itself.
#[derive(Clone)]
struct ByBits(Arc<Material>);

impl ByBits {
    /// The numbers that are fields.
    fn fields(&self) -> [Option<u64>; 6] {
        let Material { color, opacity, metallic, roughness, .. } = &*self.0;
        let [r, g, b] = color.as_ref().map_or([None; 3], |color| [color.r, color.g, color.b].each(Some));
        [r, g, b, *opacity, *metallic, *roughness].map(|number| number.map(f64::to_bits))
    }

    /// The other numbers, with their attributes.
    fn more(&self) -> impl Iterator<Item = (MaterialNumber, u64)> {
        self.0.more_numbers().iter().map(|(attribute, number)| (*attribute, number.to_bits()))
    }

    /// One bit for each part that is set, and the numbers of other attributes.
    fn set(&self) -> u64 {
        let Material { name, texture, double_sided, .. } = &*self.0;
        let [r, _, _, opacity, metallic, roughness] = self.fields();
        let numbers = [r, opacity, metallic, roughness].map(|number| number.is_some());
        let others = [name.is_some(), texture.is_some(), double_sided.is_some(), *double_sided == Some(true)];
        let flags = numbers.into_iter().chain(others).fold(0, |flags, is_set| flags << 1 | u64::from(is_set));
        let more = |count: usize| count as u64 & 0xffff;
        flags << 32 | more(self.0.more_numbers().len()) << 16 | more(self.0.more_texts().len())
    }

    /// Everything but the numbers.
    fn rest(&self) -> impl Eq {
        let Material { name, texture, double_sided, .. } = &*self.0;
        (name, texture, double_sided, self.0.more_texts())
    }
}

impl PartialEq for ByBits {
    fn eq(&self, other: &Self) -> bool {
        self.fields() == other.fields() && self.more().eq(other.more()) && self.rest() == other.rest()
    }
}

impl Eq for ByBits {}

impl Hash for ByBits {
    fn hash<H: Hasher>(&self, state: &mut H) {
        // Random colours make many materials, so only the parts that are set are hashed.
        state.write_u64(self.set());
        self.fields().into_iter().flatten().for_each(|number| state.write_u64(number));
        self.more().for_each(|number| number.hash(state));
        [&self.0.name, &self.0.texture].into_iter().flatten().for_each(|text| text.hash(state));
        self.0.more_texts().iter().for_each(|text| text.hash(state));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::material::Color;

    #[test]
    fn rules_are_numbered_as_first_seen_and_equal_text_is_one_rule() {
        let mut table = SinkTable::new();
        let [wall, roof] = ["Wall", "Roof"].map(Text::fixed);
        assert_eq!([&wall, &roof, &Text::from("Wall"), &roof, &wall].map(|name| table.rule(name)), [0, 1, 0, 1, 0]);
        assert_eq!(table.rules(), ["Wall", "Roof"]);
    }

    #[test]
    fn materials_are_told_apart_by_value() {
        let mut table = SinkTable::new();
        let red = || Arc::new(Material { color: Some(Color::new(1.0, 0.0, 0.0)), ..Material::UNSET });
        let odd = || Arc::new(Material { opacity: Some(f64::NAN), ..Material::UNSET });
        let shiny = |value| {
            let mut material = Material::UNSET;
            material.set_number(MaterialNumber::Shininess, value);
            Arc::new(material)
        };
        let list = [red(), Arc::default(), red(), odd(), odd(), shiny(2.0), shiny(3.0), shiny(2.0)];
        assert_eq!(list.map(|material| table.material(&material)), [0, 1, 0, 2, 2, 3, 4, 3]);
    }

    #[test]
    fn a_freed_address_is_not_taken_for_the_old_material() {
        let mut table = SinkTable::new();
        for i in 0..1000 {
            let material = Arc::new(Material { opacity: Some(f64::from(i)), ..Material::UNSET });
            assert_eq!(table.material(&material), i as u32);
        }
    }

    #[test]
    fn many_colours_stay_fast_and_distinct() {
        let mut table = SinkTable::new();
        for round in 0..2 {
            for i in 0..100_000u32 {
                let color = Color::new(f64::from(i % 1000) / 1000.0, f64::from(i / 1000) / 1000.0, 0.5);
                let id = table.material(&Arc::new(Material { color: Some(color), ..Material::UNSET }));
                assert_eq!((id, round < 2), (i, true));
            }
        }
        assert_eq!(table.materials().len(), 100_000);
    }

    #[test]
    fn a_face_shows_the_shapes_material_over_its_own() {
        let mut table = SinkTable::new();
        let shape = table.material(&Arc::new(Material { opacity: Some(0.5), ..Material::UNSET }));
        let own = Materials::from([Material { roughness: Some(0.1), ..Material::UNSET }]);
        let id = table.face_material(shape, &own, 0);
        assert_eq!(id, table.face_material(shape, &own, 0));
        assert_eq!(
            (table.materials()[id as usize].opacity, table.materials()[id as usize].roughness),
            (Some(0.5), Some(0.1))
        );
        assert_eq!(table.face_material(shape, &own, u32::MAX), shape);
    }
}
