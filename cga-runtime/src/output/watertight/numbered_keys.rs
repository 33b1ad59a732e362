//! Numbers for distinct keys, in the order in which they come.

use std::hash::{Hash, Hasher};

use crate::fixed_hash::FixedHasher;

/// NumberedKeys keys, each with a number. Its table has numbers alone, so it is much smaller than a map.
#[derive(Clone, Debug)]
pub(super) struct NumberedKeys<K> {
    keys: Vec<K>,
    /// The numbers of keys at their hashes, or at the next free slot. The length is a power of two, or 0.
    slots: Vec<u32>,
}

/// The mark of a free slot.
const FREE: u32 = u32::MAX;

/// The least number of slots.
const LEAST_SLOTS: usize = 16;

impl<K> Default for NumberedKeys<K> {
    fn default() -> Self {
        NumberedKeys { keys: Vec::new(), slots: Vec::new() }
    }
}

impl<K: Copy + Eq + Hash> NumberedKeys<K> {
    /// The keys by number.
    pub(super) fn keys(&self) -> &[K] {
        &self.keys
    }

    /// Removes all keys but keeps the memory.
    pub(super) fn clear(&mut self) {
        self.slots.fill(FREE);
        self.keys.clear();
    }

    /// The number of a key, if it is known.
    #[inline]
    pub(super) fn get(&self, key: K) -> Option<u32> {
        if self.slots.is_empty() {
            return None;
        }
        Some(self.slots[self.slot(key)]).filter(|number| *number != FREE)
    }

    /// The number of a key, which may be new.
    #[inline]
    pub(super) fn number(&mut self, key: K) -> u32 {
        // At most half of the slots are taken.
        if self.slots.len() <= 2 * self.keys.len() {
            self.grow();
        }
        let slot = self.slot(key);
        if self.slots[slot] == FREE {
            self.slots[slot] = self.keys.len() as u32;
            self.keys.push(key);
        }
        self.slots[slot]
    }

    /// The slot of a key, or the free slot where it would be.
    #[inline]
    fn slot(&self, key: K) -> usize {
        let mut hasher = FixedHasher::default();
        key.hash(&mut hasher);
        let last = self.slots.len() - 1;
        let mut slot = hasher.finish() as usize & last;
        while self.slots[slot] != FREE && self.keys[self.slots[slot] as usize] != key {
            slot = (slot + 1) & last;
        }
        slot
    }

    #[cold]
    fn grow(&mut self) {
        let count = LEAST_SLOTS.max(2 * self.slots.len());
        self.slots.clear();
        self.slots.resize(count, FREE);
        for number in 0..self.keys.len() {
            let slot = self.slot(self.keys[number]);
            self.slots[slot] = number as u32;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equal_keys_have_one_number() {
        let mut numbered = NumberedKeys::default();
        assert_eq!(numbered.get([7, 7]), None);
        // The second half comes again.
        let keys: Vec<[u32; 2]> = (0..3000).map(|at| [at % 1500, at % 1500 / 7]).collect();
        let numbers: Vec<u32> = keys.iter().map(|key| numbered.number(*key)).collect();
        assert!((0..3000).all(|at| numbers[at as usize] == at % 1500));
        assert_eq!(numbered.keys(), &keys[..1500]);
        assert!(keys.iter().zip(numbers).all(|(key, number)| numbered.get(*key) == Some(number)));
        assert_eq!(numbered.get([1, 2]), None);
        numbered.clear();
        assert_eq!((numbered.get(keys[0]), numbered.number(keys[5]), numbered.keys().len()), (None, 0, 1));
    }
}
