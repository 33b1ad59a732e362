//! A small hash table from pairs of indices to a number: edges.
//!
//! Open addressing, never walked in hash order for output, so nothing depends on the hash.

/// Edge → number.
#[derive(Clone, Debug, Default)]
pub(crate) struct PairTable {
    slots: Vec<(u64, u32)>,
    len: usize,
}

/// Never a pair: an edge has two different ends.
const EMPTY: u64 = u64::MAX;

impl PairTable {
    pub(crate) fn with_capacity(pairs: usize) -> Self {
        let mut table = PairTable::default();
        table.reset(pairs);
        table
    }

    /// Forgets everything and makes room for some pairs.
    pub(crate) fn reset(&mut self, pairs: usize) {
        let size = (pairs.max(8) * 2).next_power_of_two();
        self.slots.clear();
        self.slots.resize(size, (EMPTY, 0));
        self.len = 0;
    }

    /// Forgets everything, keeping a table that is not much too large.
    pub(crate) fn clear(&mut self) {
        if self.len * 64 + 1024 < self.slots.len() {
            self.slots = Vec::new();
        }
        self.slots.fill((EMPTY, 0));
        self.len = 0;
    }

    /// The number of a pair, put in as `initial` when it is new, and whether it was.
    #[inline]
    pub(crate) fn entry(&mut self, a: u32, b: u32, initial: u32) -> (&mut u32, bool) {
        if self.slots.len() <= self.len * 2 {
            self.grow();
        }
        let key = u64::from(a) << 32 | u64::from(b);
        let at = self.find(key);
        let new = self.slots[at].0 == EMPTY;
        if new {
            self.slots[at] = (key, initial);
            self.len += 1;
        }
        (&mut self.slots[at].1, new)
    }

    /// The number of a pair, when it is in.
    pub(crate) fn get(&self, a: u32, b: u32) -> Option<u32> {
        if self.slots.is_empty() {
            return None;
        }
        let slot = self.slots[self.find(u64::from(a) << 32 | u64::from(b))];
        (slot.0 != EMPTY).then_some(slot.1)
    }

    /// All pairs with their numbers, in no useful order.
    pub(crate) fn pairs(&self) -> impl Iterator<Item = ([u32; 2], u32)> + '_ {
        let pair = |key: u64| [(key >> 32) as u32, key as u32];
        self.slots.iter().filter(|slot| slot.0 != EMPTY).map(move |slot| (pair(slot.0), slot.1))
    }

    /// All numbers, in no useful order.
    pub(crate) fn values(&self) -> impl Iterator<Item = u32> + '_ {
        self.slots.iter().filter(|slot| slot.0 != EMPTY).map(|slot| slot.1)
    }

    #[inline]
    fn find(&self, key: u64) -> usize {
        let mask = self.slots.len() - 1;
        let hash = key.wrapping_mul(0x9E37_79B9_7F4A_7C15);
        let mut at = (hash ^ (hash >> 32)) as usize & mask;
        while self.slots[at].0 != key && self.slots[at].0 != EMPTY {
            at = (at + 1) & mask;
        }
        at
    }

    #[cold]
    fn grow(&mut self) {
        let old = std::mem::take(&mut self.slots);
        let size = (old.len() * 2).max(16);
        self.slots.resize(size, (EMPTY, 0));
        for slot in old {
            if slot.0 != EMPTY {
                let at = self.find(slot.0);
                self.slots[at] = slot;
            }
        }
    }
}
