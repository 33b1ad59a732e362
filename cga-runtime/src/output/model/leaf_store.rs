//! The leaves of a model in memory: parts that repeat are kept once, with their places.

use std::collections::HashMap;
use std::ops::Range;
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

impl ModelLeaf {
    /// The leaf of a part at a place.
    #[inline]
    pub(super) fn at(&self, place: DVec3) -> Self {
        ModelLeaf { scope: Scope { origin: place + self.scope.origin, ..self.scope }, ..*self }
    }
}

/// Consecutive leaves that are next to each other in memory.
#[derive(Clone, Copy, Debug)]
pub(super) struct LeafRun<'a> {
    /// The number of the first one.
    pub(super) first: usize,
    pub(super) leaves: &'a [ModelLeaf],
    /// The place of the part that they belong to.
    pub(super) place: Option<DVec3>,
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
        // Sums are rounded.
        (1.0 + 1e-12) * self.places.iter().map(place).fold(most(&self.own), f64::max)
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

    /// The leaves with numbers in a range.
    pub(super) fn runs(&self, range: Range<usize>) -> impl Iterator<Item = LeafRun<'_>> {
        // Each place begins a part; leaves of their own follow it.
        let of_place = move |places: usize| {
            let place = places.checked_sub(1).map(|last| &self.places[last]);
            let part = place.map_or(&[][..], |place| &self.parts[place.part as usize][..]);
            let (first, own) = place.map_or((0, 0), |place| (place.first, place.own));
            let own = &self.own[own..self.places.get(places).map_or(self.own.len(), |next| next.own)];
            let follows = LeafRun { first: first + part.len(), leaves: own, place: None };
            [LeafRun { first, leaves: part, place: place.map(|place| place.origin) }, follows]
        };
        let places = self.places_up_to(range.start)..=self.places.len();
        let within = move |run: &LeafRun<'_>| run.first < range.end;
        let start = range.start;
        let (all, end) = (places.flat_map(of_place).take_while(within), range.end);
        all.map(move |run| {
            let cut = |number: usize| number.saturating_sub(run.first).min(run.leaves.len());
            LeafRun { first: run.first.max(start), leaves: &run.leaves[cut(start)..cut(end)], ..run }
        })
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
            Some(leaf) => leaf.at(place.origin),
            None => self.own[place.own + at - part.len()],
        }
    }
}

/// A number that no coordinate of a scope exceeds, if nothing is rounded.
fn scope_reach(scope: &Scope) -> f64 {
    reach(scope.origin.abs() + scope.axes.abs() * scope.size.abs())
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

#[cfg(test)]
mod tests {
    use super::*;

    /// A leaf whose rule is `number`, at the place of that number.
    fn leaf(number: u32) -> ModelLeaf {
        let scope = Scope { origin: DVec3::X * f64::from(number), ..Scope::new(DVec3::ONE) };
        ModelLeaf { scope, rule: number, material: 0, stored: Stored::Placement }
    }

    /// Leaves of their own before, between and after places of two parts, one of which follows another at once.
    fn store() -> LeafStore {
        let place = |first, own, part| PartPlace { first, own, part, origin: DVec3::Y * first as f64 };
        LeafStore {
            own: (0..6).map(leaf).collect(),
            parts: [10..13, 20..21].map(|numbers| numbers.map(leaf).collect()).into(),
            places: vec![place(2, 2, 0), place(5, 2, 1), place(6, 2, 0), place(12, 5, 1)],
            len: 14,
            ..LeafStore::default()
        }
    }

    #[test]
    fn runs_of_every_range_have_its_leaves_in_order() {
        let store = store();
        for range in (0..=store.len()).flat_map(|end| (0..=end).map(move |start| start..end)) {
            let mut cursor = LeafCursor::new(&store);
            let expected: Vec<_> = range.clone().map(|number| (number, cursor.at(number))).collect();
            let found = store.runs(range.clone()).flat_map(|run| {
                let leaf = move |leaf: &ModelLeaf| run.place.map_or(*leaf, |place| leaf.at(place));
                (run.first..).zip(run.leaves.iter().map(leaf))
            });
            let seen = |list: Vec<(usize, ModelLeaf)>| {
                list.into_iter().map(|(number, leaf)| (number, leaf.rule, leaf.scope.origin)).collect::<Vec<_>>()
            };
            assert_eq!(seen(found.collect()), seen(expected), "{range:?}");
        }
    }

    #[test]
    fn no_coordinate_exceeds_the_reach() {
        let mut store = store();
        let mut cursor = LeafCursor::new(&store);
        let corners = (0..store.len()).flat_map(|number| cursor.at(number).scope.corners());
        let most = corners.map(|corner| corner.abs().max_element()).fold(0.0, f64::max);
        assert!(most <= store.reach() && store.reach() < 4.0 * most, "{most}, {}", store.reach());
        store.parts[1] = [ModelLeaf { scope: Scope::new(DVec3::NAN), ..leaf(0) }].into();
        assert_eq!(store.reach(), f64::INFINITY);
    }
}
