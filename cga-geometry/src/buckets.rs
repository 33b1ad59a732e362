//! Items in lists by a key.

/// The numbers of items, sorted by keys. Items with the same key keep their order.
#[derive(Debug, Default)]
pub struct Buckets {
    /// The end of each key's items.
    ends: Vec<u32>,
    pub(crate) items: Vec<u32>,
}

impl Buckets {
    /// Items with the given keys, which are below `count`. The time is linear in `count` and in the number of items.
    ///
    /// # Panics
    /// Panics if a key is not below `count`.
    pub fn by(count: usize, keys: impl Iterator<Item = u32> + Clone) -> Self {
        let mut buckets = Buckets::default();
        buckets.fill(count, keys);
        buckets
    }

    /// The same as [`Buckets::by`], in place: a counting sort.
    pub(super) fn fill(&mut self, count: usize, keys: impl Iterator<Item = u32> + Clone) {
        let Buckets { ends, items } = self;
        ends.clear();
        ends.resize(count + 1, 0);
        keys.clone().for_each(|key| ends[key as usize + 1] += 1);
        (0..count).for_each(|key| ends[key + 1] += ends[key]);
        items.clear();
        items.resize(ends[count] as usize, 0);
        for (item, key) in (0..).zip(keys) {
            let end = &mut ends[key as usize];
            items[*end as usize] = item;
            *end += 1;
        }
        ends.truncate(count);
    }

    /// The number of keys.
    pub(super) fn len(&self) -> usize {
        self.ends.len()
    }

    /// The range of a key's items.
    pub(super) fn range(&self, key: usize) -> std::ops::Range<usize> {
        let start = if key == 0 { 0 } else { self.ends[key - 1] };
        start as usize..self.ends[key] as usize
    }

    /// The items with a key, in increasing order.
    ///
    /// # Panics
    /// Panics if the key is not below the count.
    pub fn of(&self, key: usize) -> &[u32] {
        &self.items[self.range(key)]
    }
}
