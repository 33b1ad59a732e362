//! The results of changes of looks, kept by the place of the change in the rules.
//!
//! A change depends on the look before it, and on nothing else, or on a few values besides: the parameters that it reads. Most places
//! see few values. A place that sees many, such as random colours, keeps the first.

use std::collections::{BTreeMap, HashMap};
use std::hash::Hasher;

use super::look_id::LookId;
use crate::fixed_hash::{FixedHasher, FixedState};
use crate::value::read::{KeptRead, Read, are};

/// The largest numbers of results with values, for a place and for all: values that differ each time must not use up the numbers of looks.
const MOST_OF_PLACE: u32 = 64;
const MOST_WITH_VALUES: usize = 512;

/// A change of the look in the rules.
#[derive(Clone, Copy, Debug)]
pub struct ChangePlace {
    pub(super) number: u32,
    pub(super) is_of_run: bool,
}

impl ChangePlace {
    /// A change that is the same in all runs of a session.
    pub const fn lasting(number: u32) -> Self {
        ChangePlace { number, is_of_run: false }
    }

    /// A change that is the same in one run.
    pub const fn of_run(number: u32) -> Self {
        ChangePlace { number, is_of_run: true }
    }
}

/// The results of changes.
#[derive(Clone, Debug, Default)]
pub(super) struct Changes {
    /// By place in the rules: the look before the operation and the look after it, as found last.
    last: Vec<Option<(LookId, LookId)>>,
    /// All results: the look after an operation, by its place and the look before.
    all: BTreeMap<(u32, u32), LookId>,
    /// The results that depend on values, too, by the hash of all that they depend on.
    with_values: HashMap<u64, ChangeWithValues, FixedState>,
    /// By place, the number of its results with values.
    counts: Vec<u32>,
}

#[derive(Clone, Debug)]
struct ChangeWithValues {
    place: u32,
    before: LookId,
    reads: Box<[KeptRead]>,
    after: LookId,
}

/// The hash of all that a result depends on.
fn hash(place: u32, before: LookId, reads: &[Read<'_>]) -> u64 {
    let mut hasher = FixedHasher::default();
    hasher.write_u64(u64::from(place) << 32 | u64::from(before.0));
    reads.iter().for_each(|read| read.hash(&mut hasher));
    hasher.finish()
}

impl Changes {
    /// The result of a change that began with the look `before` and read these values.
    #[inline]
    pub(super) fn after(&mut self, place: u32, before: LookId, reads: &[Read<'_>]) -> Option<LookId> {
        if !reads.is_empty() {
            return self.after_values(place, before, reads);
        }
        match self.last.get(place as usize) {
            Some(&Some((known, after))) if known == before => Some(after),
            _ => self.found_before(place, before),
        }
    }

    #[cold]
    #[inline(never)]
    fn found_before(&mut self, place: u32, before: LookId) -> Option<LookId> {
        let after = *self.all.get(&(place, before.0))?;
        self.last[place as usize] = Some((before, after));
        Some(after)
    }

    fn after_values(&self, place: u32, before: LookId, reads: &[Read<'_>]) -> Option<LookId> {
        let known = self.with_values.get(&hash(place, before, reads))?;
        let is_same = known.place == place && known.before == before && are(&known.reads, reads);
        is_same.then_some(known.after)
    }

    /// Returns true if a place keeps more results with values.
    pub(super) fn has_room(&self, place: u32) -> bool {
        let own = self.counts.get(place as usize).copied().unwrap_or_default();
        own < MOST_OF_PLACE && self.with_values.len() < MOST_WITH_VALUES
    }

    /// Keeps a result.
    pub(super) fn keep(&mut self, place: u32, before: LookId, reads: &[Read<'_>], after: LookId) {
        let at = place as usize;
        if reads.is_empty() {
            self.all.insert((place, before.0), after);
            self.last.resize(self.last.len().max(at + 1), None);
            self.last[at] = Some((before, after));
            return;
        }
        self.counts.resize(self.counts.len().max(at + 1), 0);
        self.counts[at] += 1;
        let hash = hash(place, before, reads);
        let reads = reads.iter().map(Read::kept).collect();
        // The first result with a hash stays.
        self.with_values.entry(hash).or_insert(ChangeWithValues { place, before, reads, after });
    }
}
