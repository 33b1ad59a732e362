//! The numbers of a run's materials.
//!
//! Slim shapes and sinks have numbers in place of materials: a colour that is a constant is one comparison, and a sink looks
//! a material up only where the number changes. Random colours must not let the table grow without limit, so few materials
//! have a number; others are those of their base.

use std::sync::Arc;

use super::Material;
use crate::state::UNSET;

/// The number of a material among those of the run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct MaterialId(pub(crate) u32);

impl MaterialId {
    /// A material without a number: that of the base.
    pub(crate) const OF_BASE: MaterialId = MaterialId(u32::MAX);
}

/// Materials that have a number in a run. More than rules can make with constant colours, in any sensible use.
const MOST: usize = 1 << 16;

/// Materials that a session keeps for its next run.
const MANY: usize = 1024;

/// Materials added last that are compared with one that has no number yet.
const COMPARED: usize = 64;

/// The materials of a run by number, and the results of the material operations with constant arguments.
#[derive(Clone, Debug)]
pub(crate) struct MaterialIds {
    list: Vec<Arc<Material>>,
    /// By place in the rules: the material before the operation and the one after it, as it was found last.
    paints: Vec<Option<(MaterialId, MaterialId)>>,
}

impl Default for MaterialIds {
    fn default() -> Self {
        MaterialIds { list: vec![UNSET.clone()], paints: Vec::new() }
    }
}

impl MaterialIds {
    /// Returns true if the table is so large that another run should begin with an empty one.
    pub(crate) fn is_full(&self) -> bool {
        MANY <= self.list.len()
    }

    /// The material with a number; nothing for that of the base.
    #[inline]
    pub(crate) fn get(&self, id: MaterialId) -> Option<&Arc<Material>> {
        self.list.get(id.0 as usize)
    }

    /// The number of a material, if it has one: the materials added last are looked at, and the first.
    #[inline]
    pub(crate) fn id(&self, material: &Arc<Material>) -> MaterialId {
        if Arc::ptr_eq(&self.list[0], material) {
            return MaterialId(0);
        }
        let recent = self.list.iter().enumerate().rev().take(COMPARED);
        let found = recent.into_iter().find(|(_, known)| Arc::ptr_eq(known, material));
        found.map_or(MaterialId::OF_BASE, |(at, _)| MaterialId(at as u32))
    }

    /// The number of a material, which gets one if there is room.
    pub(crate) fn intern(&mut self, material: &Arc<Material>) -> MaterialId {
        let recent = self.list.iter().enumerate().rev().take(COMPARED);
        if let Some((at, _)) = recent.into_iter().find(|(_, known)| *known == material) {
            return MaterialId(at as u32);
        }
        if self.list.len() == MOST {
            return MaterialId::OF_BASE;
        }
        self.list.push(material.clone());
        MaterialId((self.list.len() - 1) as u32)
    }

    /// The result of the material operation at a place in the rules, if it is known for that material.
    #[inline]
    pub(crate) fn painted(&self, place: u32, before: MaterialId) -> Option<MaterialId> {
        match self.paints.get(place as usize) {
            Some(&Some((known, after))) if known == before => Some(after),
            _ => None,
        }
    }

    /// Keeps such a result, if both materials have a number.
    pub(crate) fn keep_paint(&mut self, place: u32, before: MaterialId, after: MaterialId) -> bool {
        let has_numbers = before != MaterialId::OF_BASE && after != MaterialId::OF_BASE;
        if has_numbers {
            let place = place as usize;
            self.paints.resize(self.paints.len().max(place + 1), None);
            self.paints[place] = Some((before, after));
        }
        has_numbers
    }
}
