//! The tags of faces.

use std::sync::Arc;

use super::FaceOrigin;
use crate::each::Each;
use crate::mesh::pair_table::PairTable;
use crate::mesh::{FaceTag, Mesh, TagSet, TagSetTable};

/// The sets of tags of new faces.
///
/// A new face has the tags of its old face. A face that grows out of an edge also has the tags of the edge. The tag of an
/// operation replaces the other tags of that operation.
pub(super) struct FaceTags<'s> {
    source: &'s Mesh,
    table: TagSetTable,
    /// The tags of the operation so far.
    names: Vec<Option<&'static str>>,
    /// For a set of the source, or [`FaceTag::NONE`], and the place of one of these names the number of the set of both, or [`UNKNOWN`].
    known: PairTable,
}

/// The number of a set that was not asked for yet.
const UNKNOWN: u32 = u32::MAX;

impl<'s> FaceTags<'s> {
    pub(super) fn new(source: &'s Mesh) -> Self {
        FaceTags { source, table: TagSetTable::default(), names: Vec::new(), known: PairTable::default() }
    }

    /// The attributes of a face.
    pub(super) fn of(&mut self, origin: &FaceOrigin) -> FaceTag {
        if origin.is_filling() {
            return FaceTag::PLAIN;
        }
        let own = self.source.face(origin.face as usize).tag();
        let tag = match origin.tag() {
            Some(tag) => self.over(own, tag),
            None => self.same(own),
        };
        match origin.edge() {
            Some(edge) => self.with_edge(tag, edge.each(|corner| self.source.corners()[corner as usize])),
            None => tag,
        }
    }

    /// The attributes of a face with other tags.
    pub(super) fn with(&mut self, origin: &FaceOrigin, tags: &TagSet) -> FaceTag {
        let tags = if tags.names().is_empty() { FaceTag::NONE } else { self.table.number(tags) };
        FaceTag { tags, ..self.source.face(origin.face as usize).tag() }
    }

    /// The attributes of a face with the tag of an operation, over a face of the source.
    fn over(&mut self, own: FaceTag, tag: &'static str) -> FaceTag {
        FaceTag { tags: self.number(own.tags, Some(tag)), ..own.uncapped() }
    }

    /// The attributes of a face of the source, or of a piece of it.
    pub(super) fn same(&mut self, own: FaceTag) -> FaceTag {
        let is_tagged = self.source.tag_sets().get(own.tags as usize).is_some_and(|set| !set.names().is_empty());
        FaceTag { tags: if is_tagged { self.number(own.tags, None) } else { FaceTag::NONE }, ..own }
    }

    /// The number of the tags of a set of the source and of a tag of the operation.
    fn number(&mut self, set: u32, tag: Option<&'static str>) -> u32 {
        let row = self.names.iter().position(|known| *known == tag).unwrap_or_else(|| {
            self.names.push(tag);
            self.names.len() - 1
        });
        let (number, _) = self.known.entry(set, row as u32, UNKNOWN);
        if *number == UNKNOWN {
            *number = match (self.source.tag_sets().get(set as usize), tag) {
                (Some(own), Some(tag)) => self.table.number(&own.renewed(tag)),
                (Some(own), None) => self.table.number(own),
                (None, Some(tag)) => self.table.number(&TagSet::of_operation(tag)),
                (None, None) => FaceTag::NONE,
            };
        }
        *number
    }

    /// The attributes with the tags of the edge between two points.
    fn with_edge(&mut self, tag: FaceTag, ends: [u32; 2]) -> FaceTag {
        let Some(set) = self.source.edge_tags(ends) else { return tag };
        let edge = self.table.number(set);
        let tags = if tag.tags == FaceTag::NONE { edge } else { self.table.union(tag.tags, edge) };
        FaceTag { tags, ..tag }
    }

    /// The sets, which tags of faces index.
    pub(super) fn finish(self) -> Arc<[TagSet]> {
        if self.table.is_empty() { Arc::default() } else { self.table.into_sets() }
    }
}
