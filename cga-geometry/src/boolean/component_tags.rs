//! The tags of edges and vertices.

use std::sync::Arc;

use super::edge_table::{EdgeTable, NO_CORNER};
use super::facet::Facet;
use super::operation::{BooleanError, BooleanOp};
use super::progress::goes_on;
use super::sheet::Sheets;
use crate::each::Each;
use crate::mesh::{Mesh, TagSet, TagSetTable};
use crate::small_sort::sort_owned_by;

/// The number for "no tags".
pub(super) const NO_TAGS: u32 = u32::MAX;

/// The tags of the edges of an arrangement.
pub(super) struct EdgeTags {
    pub(super) sets: Arc<[TagSet]>,
    of_edge: Vec<u32>,
}

impl EdgeTags {
    /// The number of an edge's tags, or [`NO_TAGS`].
    pub(super) fn of(&self, edge: u32) -> u32 {
        self.of_edge[edge as usize]
    }

    /// The tags of a number.
    pub(super) fn set(&self, number: u32) -> Option<&TagSet> {
        self.sets.get(number as usize)
    }

    /// An edge has the tags of the edges of which it is a part, and `bool.cut` if faces of both operands meet there.
    pub(super) fn new(
        op: BooleanOp,
        mesh: &Mesh,
        edges: &EdgeTable,
        facets: &[Facet<'_>],
        sheets: &Sheets,
        operands: &[u8],
    ) -> Result<Self, BooleanError> {
        let (mut table, mut of_edge) = (TagSetTable::default(), vec![NO_TAGS; edges.list.len()]);
        let has_tags = mesh.subcomponent_tags.edges().len() != 0;
        if op == BooleanOp::Unify && !has_tags {
            return Ok(EdgeTags { sets: table.into_sets(), of_edge });
        }
        for (edge, uses) in sheets.fans() {
            goes_on(uses.len())?;
            let mut tags = TagSet::default();
            if has_tags {
                for owner in edges.owners(edge).iter().filter(|owner| owner.corner != NO_CORNER) {
                    let ends = facets[owner.facet as usize].edge_sources(owner.corner);
                    let own = mesh.edge_tags(ends.each(|corner| mesh.corners()[corner as usize]));
                    tags = own.map_or_else(|| tags.clone(), |own| tags.union(own));
                }
            }
            if op != BooleanOp::Unify {
                let sources = || uses.iter().flat_map(|used| sheets.at(used.sheet).sources);
                let has = |operand: u8| sources().any(|source| operands[source.facet as usize] == operand);
                tags = tags.without_below("bool");
                if has(0) && has(1) {
                    tags = tags.with("bool.cut");
                }
            }
            if !tags.names().is_empty() {
                of_edge[edge as usize] = table.number(&tags);
            }
        }
        Ok(EdgeTags { sets: table.into_sets(), of_edge })
    }
}

/// The tags of the vertices of an arrangement, from all vertices of the mesh at their points. `numbers` gives the point of the
/// arrangement for each point of the mesh. Sorted by point.
pub(super) fn vertex_tags(mesh: &Mesh, numbers: &[u32]) -> Vec<(u32, TagSet)> {
    let mut list: Vec<(u32, TagSet)> =
        mesh.subcomponent_tags.vertices().map(|(point, tags)| (numbers[point as usize], tags.clone())).collect();
    sort_owned_by(&mut list, |a, b| a.0.cmp(&b.0));
    list.dedup_by(|next, kept| {
        let is_same = next.0 == kept.0;
        if is_same {
            kept.1 = kept.1.union(&next.1);
        }
        is_same
    });
    list
}
