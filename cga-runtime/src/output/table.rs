//! Numbers for rule names and materials, in the order of first use.
//!
//! A leaf usually has the rule or the material of a recent leaf, at the same address. So addresses are looked up
//! first, and text or values only for new addresses. An address is valid only while the table itself keeps the value
//! at it alive.

use std::fmt;
use std::sync::Arc;

use crate::material::{Color, Material, MaterialNumber};
use crate::value::text::Text;

/// Interned rule names and materials. Equal leaves in equal order give equal numbers.
#[derive(Clone, Default)]
pub struct Table {
    rules: Vec<&'static str>,
    /// The address, length and number of every name so far: names are static, so an address keeps its meaning.
    rule_places: Slots<(usize, usize, u32)>,
    last_rule: (usize, usize, u32),
    materials: Vec<Arc<Material>>,
    /// The hash and number of every material.
    material_values: Slots<(u64, u32)>,
    /// Recently used materials, by address. Holding them keeps their addresses from being reused.
    recent: Vec<Option<(Arc<Material>, u32)>>,
    faces: FaceMaterials,
}

/// The materials of a mesh's faces under a shape's material, from the last look-up.
#[derive(Clone, Debug, Default)]
struct FaceMaterials {
    shape: u32,
    of: Option<Arc<[Material]>>,
    ids: Vec<u32>,
}

/// The mark of a number that is not known yet.
const UNKNOWN: u32 = u32::MAX;

/// The number of recent materials. Leaves of a façade alternate between a few.
const RECENT: usize = 16;

/// The index of a material among the recent ones.
#[inline]
fn recent_place(material: &Arc<Material>) -> usize {
    let address = Arc::as_ptr(material).addr() as u64;
    (address.wrapping_mul(0x9e37_79b9_7f4a_7c15) >> 60) as usize
}

impl fmt::Debug for Table {
    /// Writes the contents, without the look-up tables, which differ between equal tables.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Table { rules, materials, .. } = self;
        f.debug_struct("Table").field("rules", rules).field("materials", materials).finish_non_exhaustive()
    }
}

impl Table {
    /// An empty table.
    pub fn new() -> Self {
        Table::default()
    }

    /// The rule names by number.
    pub fn rules(&self) -> &[&'static str] {
        &self.rules
    }

    /// The materials by number.
    pub fn materials(&self) -> &[Arc<Material>] {
        &self.materials
    }

    /// Removes all entries but keeps the memory.
    pub fn clear(&mut self) {
        self.rules.clear();
        self.rule_places.clear();
        self.last_rule = (0, 0, 0);
        self.materials.clear();
        self.material_values.clear();
        self.recent.clear();
        self.faces = FaceMaterials::default();
    }

    /// The number of a rule name.
    #[inline]
    pub fn rule(&mut self, name: &'static str) -> u32 {
        let (address, length, id) = self.last_rule;
        if address == name.as_ptr().addr() && length == name.len() {
            return id;
        }
        self.other_rule(name)
    }

    /// The number of a material.
    #[inline]
    pub fn material(&mut self, material: &Arc<Material>) -> u32 {
        if let Some(Some((known, id))) = self.recent.get(recent_place(material))
            && Arc::ptr_eq(known, material)
        {
            return *id;
        }
        self.other_material(material)
    }

    /// The number of a face's visible material: the shape's material over the mesh's material of the face. `index`
    /// refers to `materials`; an index out of range means the shape's own material.
    pub fn face_material(&mut self, shape: u32, materials: &Arc<[Material]>, index: u32) -> u32 {
        let Some(base) = materials.get(index as usize) else { return shape };
        let same = self.faces.shape == shape && self.faces.of.as_ref().is_some_and(|of| Arc::ptr_eq(of, materials));
        if !same {
            self.faces.shape = shape;
            self.faces.of = Some(materials.clone());
            self.faces.ids.clear();
            self.faces.ids.resize(materials.len(), UNKNOWN);
        }
        if self.faces.ids[index as usize] == UNKNOWN {
            let resolved = self.materials[shape as usize].over(base);
            let id = self.intern(&resolved, || Arc::new(resolved.clone()));
            self.faces.ids[index as usize] = id;
        }
        self.faces.ids[index as usize]
    }

    #[inline(never)]
    fn other_rule(&mut self, name: &'static str) -> u32 {
        let (address, length) = (name.as_ptr().addr(), name.len());
        let hash = mix(address as u64 ^ (length as u64).rotate_left(48));
        let found = self.rule_places.find(hash, |&(a, l, _)| a == address && l == length);
        let id = match found {
            Some(&(_, _, id)) => id,
            None => {
                // The same name at another address is rare (two grammars, two crates), so a scan for each new address
                // is enough.
                let id = match self.rules.iter().position(|&known| known == name) {
                    Some(id) => id as u32,
                    None => {
                        self.rules.push(name);
                        (self.rules.len() - 1) as u32
                    }
                };
                let place = |&(a, l, _): &(usize, usize, u32)| mix(a as u64 ^ (l as u64).rotate_left(48));
                self.rule_places.insert(hash, (address, length, id), place);
                id
            }
        };
        self.last_rule = (address, length, id);
        id
    }

    #[inline(never)]
    fn other_material(&mut self, material: &Arc<Material>) -> u32 {
        let id = self.intern(material, || material.clone());
        self.recent.resize(RECENT, None);
        self.recent[recent_place(material)] = Some((material.clone(), id));
        id
    }

    fn intern(&mut self, material: &Material, shared: impl FnOnce() -> Arc<Material>) -> u32 {
        let hash = material_hash(material);
        let materials = &self.materials;
        let found =
            self.material_values.find(hash, |&(h, id)| h == hash && same_bits(&materials[id as usize], material));
        if let Some(&(_, id)) = found {
            return id;
        }
        let id = self.materials.len() as u32;
        self.materials.push(shared());
        self.material_values.insert(hash, (hash, id), |&(h, _)| h);
        id
    }
}

/// A hash table with open addressing over a power of two of places, at most half of them used. It is never iterated,
/// so its order has no effect.
#[derive(Clone, Debug)]
struct Slots<T> {
    places: Vec<Option<T>>,
    taken: usize,
}

impl<T> Default for Slots<T> {
    fn default() -> Self {
        Slots { places: Vec::new(), taken: 0 }
    }
}

impl<T: Copy> Slots<T> {
    fn clear(&mut self) {
        self.places.fill(None);
        self.taken = 0;
    }

    fn find(&self, hash: u64, is: impl Fn(&T) -> bool) -> Option<&T> {
        if self.places.is_empty() {
            return None;
        }
        let mut at = hash as usize & (self.places.len() - 1);
        while let Some(entry) = &self.places[at] {
            if is(entry) {
                return Some(entry);
            }
            at = (at + 1) & (self.places.len() - 1);
        }
        None
    }

    fn insert(&mut self, hash: u64, entry: T, hash_of: impl Fn(&T) -> u64) {
        if self.places.len() < 2 * (self.taken + 1) {
            let old = std::mem::take(&mut self.places);
            self.places = vec![None; (2 * old.len()).max(32)];
            for entry in old.into_iter().flatten() {
                self.put(hash_of(&entry), entry);
            }
        }
        self.put(hash, entry);
        self.taken += 1;
    }

    fn put(&mut self, hash: u64, entry: T) {
        let mut at = hash as usize & (self.places.len() - 1);
        while self.places[at].is_some() {
            at = (at + 1) & (self.places.len() - 1);
        }
        self.places[at] = Some(entry);
    }
}

/// The numbers of a material for comparison. An unset attribute is a bit pattern that no value has.
fn number_bits(material: &Material) -> [u64; 6] {
    const UNSET: u64 = 0x7ff4_dead_beef_0000;
    let bits = |value: Option<f64>| value.map_or(UNSET, f64::to_bits);
    let channel = |of: fn(&Color) -> f64| bits(material.color.as_ref().map(of));
    [
        channel(|c| c.r),
        channel(|c| c.g),
        channel(|c| c.b),
        bits(material.opacity),
        bits(material.metallic),
        bits(material.roughness),
    ]
}

/// Equality by bits. Unlike `==`, it also recognises a material that contains NaN.
fn same_bits(a: &Material, b: &Material) -> bool {
    let more = |material: &Material| (material.more_numbers().len(), material.more_texts().len());
    let same = |a: &(MaterialNumber, f64), b: &(MaterialNumber, f64)| a.0 == b.0 && a.1.to_bits() == b.1.to_bits();
    number_bits(a) == number_bits(b)
        && a.name == b.name
        && a.texture == b.texture
        && a.double_sided == b.double_sided
        && more(a) == more(b)
        && a.more_numbers().iter().zip(b.more_numbers()).all(|(a, b)| same(a, b))
        && a.more_texts() == b.more_texts()
}

fn material_hash(material: &Material) -> u64 {
    let mut hash = material.double_sided.map_or(2, u64::from);
    for bits in number_bits(material) {
        hash = mix(hash ^ bits);
    }
    for text in [&material.name, &material.texture] {
        hash = mix(hash ^ text.as_ref().map_or(1, text_hash));
    }
    // The hash omits the attribute; the comparison checks it.
    for (_, value) in material.more_numbers() {
        hash = mix(hash ^ value.to_bits());
    }
    for (_, text) in material.more_texts() {
        hash = mix(hash ^ text_hash(text));
    }
    hash
}

fn text_hash(text: &Text) -> u64 {
    text.bytes().fold(0xcbf2_9ce4_8422_2325, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3))
}

/// A bijection in which every bit affects all others.
fn mix(mut bits: u64) -> u64 {
    bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    bits ^ (bits >> 31)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rules_are_numbered_as_first_seen_and_equal_text_is_one_rule() {
        let mut table = Table::new();
        let copy: &'static str = Box::leak(String::from("Wall").into_boxed_str());
        assert_eq!(["Wall", "Roof", copy, "Roof", "Wall"].map(|name| table.rule(name)), [0, 1, 0, 1, 0]);
        assert_eq!(table.rules(), ["Wall", "Roof"]);
    }

    #[test]
    fn materials_are_told_apart_by_value() {
        let mut table = Table::new();
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
        let mut table = Table::new();
        for i in 0..1000 {
            let material = Arc::new(Material { opacity: Some(f64::from(i)), ..Material::UNSET });
            assert_eq!(table.material(&material), i as u32);
        }
    }

    #[test]
    fn many_colours_stay_fast_and_distinct() {
        let mut table = Table::new();
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
        let mut table = Table::new();
        let shape = table.material(&Arc::new(Material { opacity: Some(0.5), ..Material::UNSET }));
        let own: Arc<[Material]> = Arc::new([Material { roughness: Some(0.1), ..Material::UNSET }]);
        let id = table.face_material(shape, &own, 0);
        assert_eq!(id, table.face_material(shape, &own, 0));
        assert_eq!(
            (table.materials()[id as usize].opacity, table.materials()[id as usize].roughness),
            (Some(0.5), Some(0.1))
        );
        assert_eq!(table.face_material(shape, &own, u32::MAX), shape);
    }
}
