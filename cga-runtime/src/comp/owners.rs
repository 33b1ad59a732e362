//! The arms of components, and sets of connected components.

use std::collections::HashMap;

use super::source::ComponentSource;
use crate::geometry::disjoint::DisjointSets;
use crate::geometry::work;

/// The units of work of a component whose neighbours are found.
const BOND: usize = 32;

/// The arm of each component. Up to six components need no allocation: `comp` of a box is the façade path.
#[derive(Debug)]
pub(super) enum ArmOwners {
    Few([Option<u16>; 6], usize),
    Many(Vec<Option<u16>>),
}

impl ArmOwners {
    /// *comp operation*: arms are tried from left to right, and the first match takes the component.
    #[inline]
    pub(super) fn choose(count: usize, arm: impl FnMut(usize) -> Option<u16>) -> Self {
        let owners = (0..count).map(arm);
        if count <= 6 {
            let mut few = [None; 6];
            few.iter_mut().zip(owners).for_each(|(slot, owner)| *slot = owner);
            ArmOwners::Few(few, count)
        } else {
            ArmOwners::Many(owners.collect())
        }
    }

    fn list(&self) -> &[Option<u16>] {
        match self {
            ArmOwners::Few(list, count) => &list[..*count],
            ArmOwners::Many(list) => list,
        }
    }

    pub(super) fn len(&self) -> usize {
        self.list().len()
    }

    /// The components without an arm, by number.
    pub(super) fn left(&self) -> impl Iterator<Item = u32> + '_ {
        self.list().iter().zip(0..).filter(|(owner, _)| owner.is_none()).map(|(_, number)| number)
    }

    /// The components of an arm, by number.
    #[inline]
    pub(super) fn of(&self, arm: u16) -> impl Iterator<Item = u32> + Clone + '_ {
        let owned = self.list().iter().enumerate().filter(move |(_, owner)| **owner == Some(arm));
        owned.map(|(number, _)| number as u32)
    }
}

/// The sets of connected components, in the order of their first components (*comp operation*, `=:`). None if the work is to end.
pub(super) fn connected(source: &ComponentSource, components: impl Iterator<Item = u32>) -> Vec<Vec<u32>> {
    let components: Vec<u32> = components.collect();
    // The first component for each bond.
    let mut first: HashMap<u32, u32> = HashMap::new();
    let mut sets = DisjointSets::new(components.len());
    for (&component, index) in components.iter().zip(0..) {
        if !work::spend(BOND) {
            return Vec::new();
        }
        source.bonds(component as usize, |bond| sets.unite(*first.entry(bond).or_insert(index), index));
    }
    let members = |set: Vec<u32>| set.into_iter().map(|index| components[index as usize]).collect();
    sets.sets().into_iter().map(members).collect()
}
