//! The tags of the faces that an operation makes over the faces of a mesh (*Geometry tagging*, auto-tags and tag propagation).

use std::collections::BTreeMap;
use std::sync::Arc;

use super::tag::TagSetTable;
use super::{FaceTag, Mesh, TagSet};

/// The sets of tags of new faces.
///
/// A face over a face has the tags of that face, a face that grows out of an edge also the tags of the edge. The tag of an operation
/// replaces the other tags of that operation.
pub(crate) struct PartTags<'s> {
    source: &'s Mesh,
    /// The tag above all tags of the operation.
    base: &'static str,
    table: TagSetTable,
    /// The numbers of sets by the number of the source's set, and the tag of the part.
    known: BTreeMap<(u32, &'static str), u32>,
}

impl<'s> PartTags<'s> {
    /// The sets of an operation whose tags are below `base`.
    pub(crate) fn new(source: &'s Mesh, base: &'static str) -> Self {
        PartTags { source, base, table: TagSetTable::default(), known: BTreeMap::new() }
    }

    /// The tag of a face with the tag `part` over a face of the source.
    pub(crate) fn over(&mut self, own: FaceTag, part: &'static str) -> FaceTag {
        let PartTags { source, base, table, known } = self;
        let tags = *known.entry((own.tags, part)).or_insert_with(|| {
            let plain = TagSet::default();
            let set = source.tag_sets.get(own.tags as usize).unwrap_or(&plain);
            table.number(&set.renewed(base, part))
        });
        FaceTag { tags, ..own.uncapped() }
    }

    /// The tag of a face with the tag `part` over the edge between two points, which a face of the source has.
    pub(crate) fn over_edge(&mut self, own: FaceTag, part: &'static str, ends: [u32; 2]) -> FaceTag {
        let tag = self.over(own, part);
        self.with_edge(tag, ends)
    }

    /// The tag of a face that is a face of the source, or a part of it.
    pub(crate) fn same(&mut self, own: FaceTag) -> FaceTag {
        let set = self.source.tag_sets.get(own.tags as usize).filter(|set| !set.names().is_empty());
        FaceTag { tags: set.map_or(FaceTag::NONE, |set| self.table.number(set)), ..own }
    }

    /// The tag of a part of a face of the source that grows out of the edge between two points.
    pub(crate) fn beside_edge(&mut self, own: FaceTag, ends: [u32; 2]) -> FaceTag {
        let tag = self.same(own);
        self.with_edge(tag, ends)
    }

    /// A tag of this operation with the tags of an edge of the source.
    fn with_edge(&mut self, tag: FaceTag, ends: [u32; 2]) -> FaceTag {
        let Some(set) = self.source.edge_tags(ends) else { return tag };
        let edge = self.table.number(set);
        let tags = if tag.tags == FaceTag::NONE { edge } else { self.table.union(tag.tags, edge) };
        FaceTag { tags, ..tag }
    }

    /// The sets, which tags of faces index.
    pub(crate) fn finish(self) -> Arc<[TagSet]> {
        self.table.into_sets()
    }
}
