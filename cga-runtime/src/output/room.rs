//! A list whose next items are written in place.

/// The number of default items that are made at once.
const AHEAD: usize = 1 << 10;

/// Used items, followed by default items: a writer gets a slice of the next items and fills it. This is faster than
/// to build items elsewhere and copy them.
#[derive(Clone, Debug, Default)]
pub(super) struct Room<T> {
    items: Vec<T>,
    used: usize,
}

impl<T: Copy + Default> Room<T> {
    /// A list with room for `count` items.
    pub(super) fn with_capacity(count: usize) -> Self {
        Room { items: Vec::with_capacity(count), used: 0 }
    }

    /// The items.
    #[inline]
    pub(super) fn items(&self) -> &[T] {
        &self.items[..self.used]
    }

    /// The number of items.
    #[inline]
    pub(super) fn len(&self) -> usize {
        self.used
    }

    /// Removes the items but keeps the memory.
    pub(super) fn clear(&mut self) {
        self.used = 0;
    }

    /// Returns true if `count` further items need no memory.
    #[inline(always)]
    pub(super) fn has(&self, count: usize) -> bool {
        count <= self.items.len() - self.used
    }

    /// Makes room for `count` further items.
    pub(super) fn reserve(&mut self, count: usize) {
        if !self.has(count) {
            self.grow(count);
        }
    }

    /// Adds `count` items and returns the slice to fill.
    #[inline]
    pub(super) fn take(&mut self, count: usize) -> &mut [T] {
        if !self.has(count) {
            self.grow(count);
        }
        let start = self.used;
        self.used += count;
        &mut self.items[start..start + count]
    }

    /// Adds items.
    pub(super) fn extend(&mut self, items: impl ExactSizeIterator<Item = T>) {
        self.take(items.len()).iter_mut().zip(items).for_each(|(to, item)| *to = item);
    }

    /// Makes room for exactly `count` items in all.
    pub(super) fn reserve_exact(&mut self, count: usize) {
        self.items.reserve_exact(count.saturating_sub(self.items.len()));
    }

    /// The number of items that fit in the reserved memory.
    pub(super) fn capacity(&self) -> usize {
        self.items.capacity()
    }

    /// Makes room for at least `count` further items. Default items are made shortly before they are written, while they stay in the nearest
    /// cache; the rest of the reserved memory is not touched.
    #[cold]
    #[inline(never)]
    fn grow(&mut self, count: usize) {
        self.items.reserve((self.used + count).saturating_sub(self.items.len()));
        let wanted = (self.used + count.max(AHEAD)).min(self.items.capacity());
        self.items.resize(wanted, T::default());
    }
}
