//! The limits on the work and the memory of an arrangement.

use super::edge_table::EdgeTable;
use super::operation::BooleanError;
use super::point_set::PointSet;
use crate::work;

/// The work that an operation may still do, with all attempts together, and the size of its arrangements.
#[derive(Clone, Copy, Debug)]
pub(super) struct Budget {
    /// The number of comparisons.
    pub(super) comparisons: usize,
    /// The number of edges, divided ones included.
    pub(super) edges: usize,
    /// The number of pairs of an edge and a facet that has it. Facets in one plane share edges, so there may be many more than
    /// edges.
    pub(super) owners: usize,
    /// The number of points of one attempt.
    pub(super) points: usize,
    /// The number of windings around all cells of a plane: for each cell, of all facets that are there.
    pub(super) windings: usize,
}

impl Budget {
    /// A few seconds, and up to 0.6 GB. Two balls of 180,000 faces have 550,000 edges.
    pub(super) const DEFAULT: Budget =
        Budget { comparisons: 200_000_000, edges: 700_000, owners: 2_500_000, points: 700_000, windings: 6_000_000 };

    /// Takes some comparisons; an error if none are left, or if the work is to end.
    pub(super) fn spend(&mut self, count: usize) -> Result<(), BooleanError> {
        let left = self.comparisons.checked_sub(count).filter(|_| work::spend(count));
        self.comparisons = left.ok_or(BooleanError::TooMany)?;
        Ok(())
    }

    /// An error if there are too many edges, points, or facets that have edges.
    pub(super) fn check(&self, edges: &EdgeTable, points: &PointSet) -> Result<(), BooleanError> {
        let is_within =
            edges.list.len() <= self.edges && points.at.len() <= self.points && edges.owner_count <= self.owners;
        if is_within { Ok(()) } else { Err(BooleanError::TooMany) }
    }

    /// Takes the edges of an attempt, so that a further attempt has only the rest.
    pub(super) fn spend_edges(&mut self, edges: &EdgeTable) {
        self.edges = self.edges.saturating_sub(edges.list.len());
        self.owners = self.owners.saturating_sub(edges.owner_count);
    }
}
