//! The limit on the work of one pair.

use std::cell::Cell;

use crate::work;

/// The most comparisons of a corner with a plane, or of a point with a triangle, for one pair: about a second.
const MOST_COMPARISONS: usize = 50_000_000;

/// The comparisons that a pair may still make.
pub(super) struct Budget(Cell<usize>);

impl Budget {
    pub(super) fn new() -> Self {
        Budget(Cell::new(MOST_COMPARISONS))
    }

    /// Takes some comparisons. Returns false if none are left, or if the work is to end.
    pub(super) fn spend(&self, count: usize) -> bool {
        self.0.set(if work::spend(count) { self.0.get().saturating_sub(count) } else { 0 });
        !self.is_spent()
    }

    /// Returns true if none are left. Then places of points are not known.
    pub(super) fn is_spent(&self) -> bool {
        self.0.get() == 0
    }
}

/// Counts the comparisons of one search, and takes them from the budget in one go or in large parts.
pub(super) struct Count<'b> {
    budget: &'b Budget,
    open: usize,
}

impl<'b> Count<'b> {
    /// The comparisons that are taken at once.
    const PART: usize = 4096;

    pub(super) fn of(budget: &'b Budget) -> Self {
        Count { budget, open: 0 }
    }

    /// Adds some comparisons. Returns false if none are left.
    #[inline]
    pub(super) fn add(&mut self, count: usize) -> bool {
        self.open += count;
        self.open < Self::PART || self.budget.spend(std::mem::take(&mut self.open))
    }

    /// Takes the comparisons that were added last.
    pub(super) fn finish(self) {
        self.budget.spend(self.open);
    }
}
