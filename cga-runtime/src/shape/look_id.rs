//! The numbers of a run's looks.
//!
//! Slim shapes and sinks have numbers in place of looks. So a constant colour costs one comparison, and a sink looks
//! a material up only where the number changes. Random colours must not let the table grow without limit, so few
//! looks have a number; a shape with another look takes the look of its base.
//!
//! Templates are kept by number. So the looks with a number follow from the rules alone, independently of earlier
//! runs of the session.

use std::collections::BTreeMap;
use std::sync::Arc;

use super::look::Look;
use crate::shape::state::UNSET;

/// The number of a look in the run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct LookId(pub(crate) u32);

impl LookId {
    /// A look without a number: the look of the base.
    pub(crate) const OF_BASE: LookId = LookId(u32::MAX);

    /// The flag of looks with implicit texture coordinates.
    const COORDINATES: u32 = 1 << 31;

    /// The index in the list.
    #[inline]
    pub(crate) fn index(self) -> u32 {
        self.0 & !LookId::COORDINATES
    }

    /// Returns true if the look may have implicit texture coordinates, as every look without a number may.
    #[inline]
    pub(crate) fn may_have_coordinates(self) -> bool {
        self.0 & LookId::COORDINATES != 0
    }
}

/// The largest number of looks with a number in a run: more than rules make with constant colours in any sensible
/// use.
const MOST: usize = 1 << 16;

/// The number of looks that a session keeps for its next run.
const MANY: usize = 1024;

/// The number of recent looks that a new one is compared with. A look that equals an older one gets a second number.
const COMPARED: usize = 64;

/// The looks of a run by number, and the results of material operations with constant arguments.
#[derive(Clone, Debug)]
pub(crate) struct LookIds {
    list: Vec<Arc<Look>>,
    /// The numbers by the address of the look.
    by_address: BTreeMap<u64, u32>,
    /// By place in the rules: the look before the operation and the look after it, as found last.
    last_changes: Vec<Option<(LookId, LookId)>>,
    /// All such results: the look after an operation, by its place and the look before.
    all_changes: BTreeMap<(u32, u32), LookId>,
}

impl Default for LookIds {
    fn default() -> Self {
        LookIds {
            list: vec![UNSET.clone()],
            by_address: BTreeMap::new(),
            last_changes: Vec::new(),
            all_changes: BTreeMap::new(),
        }
    }
}

impl LookIds {
    /// Returns true if the table is so large that another run should begin with an empty one.
    pub(crate) fn is_full(&self) -> bool {
        MANY <= self.list.len()
    }

    /// The look with a number; `None` for the look of the base.
    #[inline]
    pub(crate) fn get(&self, id: LookId) -> Option<&Arc<Look>> {
        self.list.get(id.index() as usize)
    }

    /// The number of a look, or `OF_BASE`.
    #[inline]
    pub(crate) fn id(&self, look: &Arc<Look>) -> LookId {
        if Arc::ptr_eq(&self.list[0], look) {
            return LookId(0);
        }
        self.by_address.get(&address(look)).map_or(LookId::OF_BASE, |number| LookId(*number))
    }

    /// The number of a look, which gets one if there is room. A look whose coordinates belong to one place gets none.
    pub(crate) fn intern(&mut self, look: &Arc<Look>) -> LookId {
        let bit = if look.coordinates.is_empty() { 0 } else { LookId::COORDINATES };
        let recent = self.list.iter().enumerate().rev().take(COMPARED);
        if let Some((at, _)) = recent.into_iter().find(|(_, known)| *known == look) {
            return LookId(at as u32 | bit);
        }
        if self.list.len() == MOST || look.coordinates.is_placed() {
            return LookId::OF_BASE;
        }
        let number = self.list.len() as u32 | bit;
        self.list.push(look.clone());
        self.by_address.insert(address(look), number);
        LookId(number)
    }

    /// The result of the material operation at a place in the rules, if its last use there began with the look
    /// `before`.
    #[inline]
    pub(crate) fn changed(&self, place: u32, before: LookId) -> Option<LookId> {
        match self.last_changes.get(place as usize) {
            Some(&Some((known, after))) if known == before => Some(after),
            _ => None,
        }
    }

    /// The result of the material operation at a place, if an earlier use there began with the look `before`.
    pub(crate) fn changed_before(&mut self, place: u32, before: LookId) -> Option<LookId> {
        let after = *self.all_changes.get(&(place, before.0))?;
        self.last_changes[place as usize] = Some((before, after));
        Some(after)
    }

    /// Keeps the result of a material operation, if both looks have a number. Returns true if it was kept.
    pub(crate) fn keep_change(&mut self, place: u32, before: LookId, after: LookId) -> bool {
        let has_numbers = before != LookId::OF_BASE && after != LookId::OF_BASE;
        if has_numbers {
            self.all_changes.insert((place, before.0), after);
            let place = place as usize;
            self.last_changes.resize(self.last_changes.len().max(place + 1), None);
            self.last_changes[place] = Some((before, after));
        }
        has_numbers
    }
}

fn address(look: &Arc<Look>) -> u64 {
    Arc::as_ptr(look).addr() as u64
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::material::Material;

    fn named(number: usize) -> Arc<Look> {
        let name = Some(number.to_string().as_str().into());
        Arc::new(Look { material: Arc::new(Material { name, ..Material::default() }), ..Look::default() })
    }

    #[test]
    fn a_number_is_found_however_many_materials_come_after() {
        let mut ids = LookIds::default();
        let materials: Vec<_> = (0..300).map(named).collect();
        let numbers: Vec<_> = materials.iter().map(|material| ids.intern(material)).collect();
        let found: Vec<_> = materials.iter().map(|material| ids.id(material)).collect();
        assert_eq!(found, numbers);
        assert_eq!(ids.id(&named(7)), LookId::OF_BASE);
    }

    #[test]
    fn a_place_that_changes_many_materials_in_turn_adds_each_once() {
        let mut ids = LookIds::default();
        let before: Vec<_> = (0..200).map(|number| ids.intern(&named(number))).collect();
        for _ in 0..3 {
            for &before in &before {
                if ids.changed(0, before).or_else(|| ids.changed_before(0, before)).is_none() {
                    let after = ids.intern(&named(1000 + before.0 as usize));
                    assert!(ids.keep_change(0, before, after));
                }
            }
        }
        assert_eq!(ids.list.len(), 1 + 2 * 200);
        assert_eq!(ids.changed_before(1, before[0]), None);
    }
}
