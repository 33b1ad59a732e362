//! A small hash table from pairs of indices to numbers, for edges.
//!
//! It uses open addressing, and output never depends on the hash order. The hash function is fixed, so an attacker
//! could choose pairs with equal hashes. Pairs far from their own slot are therefore stored in a tree.

use std::collections::BTreeMap;
use std::collections::btree_map::Entry;

/// A map from edges to numbers.
#[derive(Clone, Debug, Default)]
pub(crate) struct PairTable {
    slots: Vec<(u64, u32)>,
    /// The number of pairs in the slots.
    len: usize,
    /// The pairs without a free slot near their own.
    crowd: BTreeMap<u64, u32>,
}

/// A key that is not a pair, because an edge has two different ends.
const EMPTY: u64 = u64::MAX;

/// The search distance from a pair's own slot. With usual pairs and a half-full table, no pair is that far away.
const NEAR: usize = 256;

impl PairTable {
    pub(crate) fn with_capacity(pairs: usize) -> Self {
        let mut table = PairTable::default();
        table.reset(pairs);
        table
    }

    /// Clears the table and makes room for some pairs.
    pub(crate) fn reset(&mut self, pairs: usize) {
        let size = (pairs.max(8) * 2).next_power_of_two();
        self.slots.clear();
        self.slots.resize(size, (EMPTY, 0));
        self.len = 0;
        self.crowd.clear();
    }

    /// Clears the table. The memory is kept unless it is much too large.
    pub(crate) fn clear(&mut self) {
        if self.len * 64 + 1024 < self.slots.len() {
            self.slots = Vec::new();
        }
        self.slots.fill((EMPTY, 0));
        self.len = 0;
        self.crowd.clear();
    }

    /// The number of a pair, and whether the pair is new. A new pair gets the number `initial`.
    #[inline]
    pub(crate) fn entry(&mut self, a: u32, b: u32, initial: u32) -> (&mut u32, bool) {
        if self.slots.len() <= self.len * 2 {
            self.grow();
        }
        let key = u64::from(a) << 32 | u64::from(b);
        let Some(at) = self.find(key) else { return self.entry_in_crowd(key, initial) };
        let new = self.slots[at].0 == EMPTY;
        if new {
            self.slots[at] = (key, initial);
            self.len += 1;
        }
        (&mut self.slots[at].1, new)
    }

    #[cold]
    fn entry_in_crowd(&mut self, key: u64, initial: u32) -> (&mut u32, bool) {
        match self.crowd.entry(key) {
            Entry::Occupied(entry) => (entry.into_mut(), false),
            Entry::Vacant(entry) => (entry.insert(initial), true),
        }
    }

    /// The number of a pair, if it is in the table.
    pub(crate) fn get(&self, a: u32, b: u32) -> Option<u32> {
        if self.slots.is_empty() {
            return None;
        }
        let key = u64::from(a) << 32 | u64::from(b);
        let Some(at) = self.find(key) else { return self.crowd.get(&key).copied() };
        let slot = self.slots[at];
        (slot.0 != EMPTY).then_some(slot.1)
    }

    /// All pairs with their numbers, in unspecified order.
    pub(crate) fn pairs(&self) -> impl Iterator<Item = ([u32; 2], u32)> + '_ {
        self.entries().map(|(key, number)| ([(key >> 32) as u32, key as u32], number))
    }

    fn entries(&self) -> impl Iterator<Item = (u64, u32)> + '_ {
        let slots = self.slots.iter().copied().filter(|slot| slot.0 != EMPTY);
        slots.chain(self.crowd.iter().map(|(&key, &number)| (key, number)))
    }

    /// The slot where a pair is or would be stored. `None` if all slots near its own are taken.
    #[inline]
    fn find(&self, key: u64) -> Option<usize> {
        let mask = self.slots.len() - 1;
        let hash = key.wrapping_mul(0x9E37_79B9_7F4A_7C15);
        let own = (hash ^ (hash >> 32)) as usize;
        let mut at = own & mask;
        while self.slots[at].0 != key && self.slots[at].0 != EMPTY {
            at = (at + 1) & mask;
            if at == own.wrapping_add(NEAR) & mask {
                return None;
            }
        }
        Some(at)
    }

    #[cold]
    fn grow(&mut self) {
        let old = std::mem::take(self);
        self.reset(old.slots.len().max(8));
        for (key, number) in old.entries() {
            match self.find(key) {
                Some(at) => {
                    self.slots[at] = (key, number);
                    self.len += 1;
                }
                None => drop(self.crowd.insert(key, number)),
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pairs_made_to_crowd_are_all_found() {
        // Pairs that fall into few slots of a table of any size.
        let crowded = |a: u32, b: u32| {
            let hash = (u64::from(a) << 32 | u64::from(b)).wrapping_mul(0x9E37_79B9_7F4A_7C15);
            (hash ^ (hash >> 32)) & 0xffff < 16
        };
        let all = (0..4000).flat_map(|a| (a + 1..4000).map(move |b| (a, b)));
        let pairs: Vec<(u32, u32)> = all.filter(|&(a, b)| crowded(a, b)).collect();
        assert!(pairs.len() > 1500);
        let mut table = PairTable::default();
        for (number, &(a, b)) in pairs.iter().enumerate() {
            assert_eq!(table.entry(a, b, number as u32), (&mut (number as u32), true));
        }
        assert!(!table.crowd.is_empty());
        for (number, &(a, b)) in pairs.iter().enumerate() {
            assert_eq!(table.entry(a, b, 0), (&mut (number as u32), false));
            assert_eq!(table.get(a, b), Some(number as u32));
            assert_eq!(table.get(b, a), None);
        }
        let mut found: Vec<_> = table.pairs().collect();
        found.sort_by_key(|pair| pair.1);
        assert!(found.into_iter().map(|pair| pair.0).eq(pairs.iter().map(|&(a, b)| [a, b])));
        table.clear();
        assert_eq!(table.get(pairs[1500].0, pairs[1500].1), None);
    }
}
