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
