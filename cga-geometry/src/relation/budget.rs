//! The limit on the work of one pair.

use crate::work;

/// The most comparisons of a corner with a plane for one pair: some tenths of a second.
const MOST_COMPARISONS: usize = 50_000_000;

/// The comparisons that a pair may still make.
pub(super) struct Budget(usize);

impl Budget {
    pub(super) fn new() -> Self {
        Budget(MOST_COMPARISONS)
    }

    /// Takes some comparisons. Returns false if none are left, or if the work is to end.
    pub(super) fn spend(&mut self, count: usize) -> bool {
        self.0 = if work::spend(count) { self.0.saturating_sub(count) } else { 0 };
        self.0 != 0
    }

    pub(super) fn is_spent(&self) -> bool {
        self.0 == 0
    }
}
