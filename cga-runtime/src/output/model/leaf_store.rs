//! The leaves of a model in memory: parts that repeat are kept once, with their places.

use std::collections::HashMap;
use std::sync::Arc;

use glam::DVec3;

use super::Stored;
use crate::fixed_hash::FixedState;
use crate::output::leaf_numbers::Numbers;
use crate::output::near_origin::reach;
use crate::run::sink::Replay;
use crate::shape::axes::Axes;
use crate::shape::scope::Scope;

/// The leaves, in order.
#[derive(Clone, Debug, Default)]
pub(super) struct LeafStore {
    /// The leaves that belong to no part.
    own: Vec<ModelLeaf>,
    parts: Vec<Arc<[ModelLeaf]>>,
    /// The parts by template, segment and axes, once they have come a second time; `None` after the first. Only for look-ups, never iterated.
    known: HashMap<(u64, usize, [u64; 9]), Option<u32>, FixedState>,
    places: Vec<PartPlace>,
    len: usize,
}

/// A leaf. The origin of the scope is relative to its part, if it belongs to one.
#[derive(Clone, Copy, Debug)]
pub(super) struct ModelLeaf {
    pub(super) scope: Scope,
    pub(super) rule: u32,
    pub(super) material: u32,
    pub(super) stored: Stored,
}

/// A place of a part that repeats.
#[derive(Clone, Copy, Debug)]
struct PartPlace {
    /// The number of its first leaf.
    first: usize,
    /// The number of leaves before it that belong to no part.
    own: usize,
    part: u32,
    origin: DVec3,
}

impl LeafStore {
    /// The number of leaves.
    #[inline]
    pub(super) fn len(&self) -> usize {
        self.len
    }

    /// A number of metres that no coordinate of a scope exceeds; infinite if a coordinate is not a number.
    pub(super) fn reach(&self) -> f64 {
        let most = |leaves: &[ModelLeaf]| leaves.iter().map(|leaf| scope_reach(&leaf.scope)).fold(0.0, f64::max);
        let parts: Vec<f64> = self.parts.iter().map(|part| most(part)).collect();
        let place = |place: &PartPlace| reach(place.origin) + parts[place.part as usize];
        self.places.iter().map(place).fold(most(&self.own), f64::max)
    }

    /// Adds a leaf.
    #[inline]
    pub(super) fn push(&mut self, leaf: ModelLeaf) {
        self.own.push(leaf);
        self.len += 1;
    }

    /// Adds the leaves of a part that repeats.
    pub(super) fn replay(&mut self, replay: &Replay<'_>, numbers: &mut Numbers) {
        let (template, segment) = replay.number();
        let axes = replay.placement().matrix3.to_cols_array().map(f64::to_bits);
        let origin = replay.origin().truncate();
        let part = match self.known.get_mut(&(template, segment, axes)) {
            Some(Some(part)) => *part,
            Some(known) => {
                let part = self.parts.len() as u32;
                self.parts.push(leaves(replay, DVec3::ZERO, numbers).collect());
                *known = Some(part);
                part
            }
            None => {
                self.known.insert((template, segment, axes), None);
                let before = self.own.len();
                self.own.extend(leaves(replay, origin, numbers));
                self.len += self.own.len() - before;
                return;
            }
        };
        let count = self.parts[part as usize].len();
        if count != 0 {
            self.places.push(PartPlace { first: self.len, own: self.own.len(), part, origin });
            self.len += count;
        }
    }

    /// The number of places that begin at a leaf or before it.
    fn places_up_to(&self, leaf: usize) -> usize {
        self.places.partition_point(|place| place.first <= leaf)
    }

    /// The leaf with a number. `places` is the result for an earlier leaf, and becomes the result for this one.
    #[inline]
    fn at(&self, leaf: usize, places: &mut usize) -> ModelLeaf {
        let follows = |count: usize| self.places.get(count).is_none_or(|next| leaf < next.first);
        if !follows(*places) {
            // Most often the next place.
            *places = if follows(*places + 1) { *places + 1 } else { self.places_up_to(leaf) };
        }
        let Some(place) = places.checked_sub(1).map(|last| &self.places[last]) else { return self.own[leaf] };
        let (part, at) = (&self.parts[place.part as usize], leaf - place.first);
        match part.get(at) {
            Some(leaf) => {
                ModelLeaf { scope: Scope { origin: place.origin + leaf.scope.origin, ..leaf.scope }, ..*leaf }
            }
            None => self.own[place.own + at - part.len()],
        }
    }
}

/// A number that no coordinate of a scope exceeds, also after rounding.
fn scope_reach(scope: &Scope) -> f64 {
    (1.0 + 1e-12) * reach(scope.origin.abs() + scope.axes.abs() * scope.size.abs())
}

/// The leaves of a part at an origin.
fn leaves<'a>(replay: &'a Replay<'_>, origin: DVec3, numbers: &'a mut Numbers) -> impl Iterator<Item = ModelLeaf> + 'a {
    let mut first = 0;
    replay.marks().flat_map(move |(filled, mark)| {
        let (rule, material) = numbers.with_look(&filled, mark.look);
        let range = first..first + mark.leaves;
        first = range.end;
        replay.leaves(range).filter_map(move |(placed, record, axes)| {
            let origin = origin + placed.origin.truncate();
            let scope = Scope { origin, axes: *Axes::matrix(axes), size: record.size };
            Some(ModelLeaf { scope, rule, material, stored: Stored::filled(record.form, record.unit)? })
        })
    })
}

/// A way through the leaves.
#[derive(Clone, Debug)]
pub(super) struct LeafCursor<'a> {
    store: &'a LeafStore,
    places: usize,
}

impl<'a> LeafCursor<'a> {
    pub(super) fn new(store: &'a LeafStore) -> Self {
        LeafCursor { store, places: 0 }
    }

    /// The leaf with a number. In growing order it is found at once.
    #[inline]
    pub(super) fn at(&mut self, leaf: usize) -> ModelLeaf {
        if let Some(last) = self.places.checked_sub(1)
            && leaf < self.store.places[last].first
        {
            self.places = self.store.places_up_to(leaf);
        }
        self.store.at(leaf, &mut self.places)
    }
}
