//! The arms of components, and sets of connected components.

use std::collections::HashMap;

use super::source::ComponentSource;
use crate::geometry::disjoint::DisjointSets;

/// The arm of each component (*comp operation*: arms are tried from left to right, and the first match takes the
/// component).
#[derive(Debug)]
pub(super) struct Owners(pub(super) Vec<Option<u16>>);

impl Owners {
    /// The components of an arm, by number.
    #[inline]
    pub(super) fn of(&self, arm: u16) -> impl Iterator<Item = u32> + Clone + '_ {
        let owned = self.0.iter().enumerate().filter(move |(_, owner)| **owner == Some(arm));
        owned.map(|(number, _)| number as u32)
    }
}

/// The sets of connected components, in the order of their first components (*comp operation*, `=:`).
pub(super) fn connected(source: &ComponentSource, components: impl Iterator<Item = u32>) -> Vec<Vec<u32>> {
    let components: Vec<u32> = components.collect();
    // The first component for each bond.
    let mut first: HashMap<u32, u32> = HashMap::new();
    let mut sets = DisjointSets::new(components.len());
    for (&component, index) in components.iter().zip(0..) {
        source.bonds(component as usize, |bond| sets.unite(*first.entry(bond).or_insert(index), index));
    }
    let members = |set: Vec<u32>| set.into_iter().map(|index| components[index as usize]).collect();
    sets.sets().into_iter().map(members).collect()
}
