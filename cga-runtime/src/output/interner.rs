//! Equal values, stored once.

use std::collections::HashMap;
use std::hash::{BuildHasher, BuildHasherDefault, DefaultHasher, Hash};

/// Different values in the order of their first use.
#[derive(Debug)]
pub(super) struct Interner<T> {
    pub(super) list: Vec<T>,
    /// The indices of values by their hash. Only for look-ups, never iterated.
    by_hash: HashMap<u64, Vec<usize>>,
}

impl<T> Default for Interner<T> {
    fn default() -> Self {
        Interner { list: Vec::new(), by_hash: HashMap::new() }
    }
}

impl<T: Hash + PartialEq> Interner<T> {
    /// The index of a value, which is added unless the list has an equal one.
    pub(super) fn index(&mut self, value: T) -> usize {
        // The hash is the same in every run of a program.
        let hash = BuildHasherDefault::<DefaultHasher>::default().hash_one(&value);
        let alike = self.by_hash.entry(hash).or_default();
        if let Some(&known) = alike.iter().find(|&&at| self.list[at] == value) {
            return known;
        }
        alike.push(self.list.len());
        self.list.push(value);
        self.list.len() - 1
    }
}
