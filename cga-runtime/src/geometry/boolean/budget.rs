//! The limits on the work and the memory of an arrangement.

use super::edge_table::EdgeTable;
use super::operation::BooleanError;

/// The work that an operation may still do.
#[derive(Clone, Copy, Debug)]
pub(super) struct Budget {
    /// The number of comparisons.
    pub(super) comparisons: usize,
    /// The number of edges, divided ones included.
    pub(super) edges: usize,
    /// The number of pairs of an edge and a facet that has it. Facets in one plane share edges, so there may be many more than
    /// edges.
    pub(super) owners: usize,
}

impl Budget {
    /// A few seconds, and less than 1 GB.
    pub(super) const DEFAULT: Budget = Budget { comparisons: 200_000_000, edges: 2_000_000, owners: 8_000_000 };

    /// Takes some comparisons; an error if none are left.
    pub(super) fn spend(&mut self, count: usize) -> Result<(), BooleanError> {
        self.comparisons = self.comparisons.checked_sub(count).ok_or(BooleanError::TooMany)?;
        Ok(())
    }

    /// An error if there are too many edges, or too many facets that have them.
    pub(super) fn check(&self, edges: &EdgeTable) -> Result<(), BooleanError> {
        let is_within = edges.list.len() <= self.edges && edges.owner_count <= self.owners;
        if is_within { Ok(()) } else { Err(BooleanError::TooMany) }
    }
}
