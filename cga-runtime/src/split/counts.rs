//! Repetitions by group, on the stack while there are few groups.

/// Groups that need no allocation.
const INLINE: usize = 4;

/// A list that lives on the stack while it is short.
#[derive(Clone, Debug)]
pub(super) struct Inline<T> {
    short: [T; INLINE],
    len: usize,
    long: Vec<T>,
}

impl<T: Copy + Default> Default for Inline<T> {
    fn default() -> Self {
        Inline { short: [T::default(); INLINE], len: 0, long: Vec::new() }
    }
}

impl<T: Copy + Default> Inline<T> {
    pub(super) fn push(&mut self, value: T) {
        if self.len < INLINE {
            self.short[self.len] = value;
        } else {
            self.long.push(value);
        }
        self.len += 1;
    }

    pub(super) fn len(&self) -> usize {
        self.len
    }

    pub(super) fn get_mut(&mut self, index: usize) -> Option<&mut T> {
        if self.len <= index {
            None
        } else if index < INLINE {
            Some(&mut self.short[index])
        } else {
            self.long.get_mut(index - INLINE)
        }
    }
}

impl<T> std::ops::Index<usize> for Inline<T> {
    type Output = T;
    fn index(&self, index: usize) -> &T {
        if index < INLINE { &self.short[index] } else { &self.long[index - INLINE] }
    }
}

/// Repetitions by group.
#[derive(Clone, Debug, Default)]
pub(super) struct Counts(Inline<u64>);

impl Counts {
    pub(super) fn zero(len: usize) -> Self {
        let mut counts = Counts::default();
        for _ in 0..len {
            counts.0.push(0);
        }
        counts
    }

    pub(super) fn get(&self, group: usize) -> u64 {
        if group < self.0.len() { self.0[group] } else { 0 }
    }

    pub(super) fn set(&mut self, group: usize, count: u64) {
        if let Some(slot) = self.0.get_mut(group) {
            *slot = count;
        }
    }
}
