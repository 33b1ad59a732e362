//! The tags of faces.

use std::collections::BTreeMap;
use std::sync::Arc;

use super::FaceOrigin;
use crate::each::Each;
use crate::mesh::{FaceTag, Mesh, TagSet, TagSetTable};

/// The sets of tags of new faces.
///
/// A new face has the tags of its old face. A face that grows out of an edge also has the tags of the edge. The tag of an
/// operation replaces the other tags of that operation.
pub(super) struct FaceTags<'s> {
    source: &'s Mesh,
    table: TagSetTable,
    /// The numbers of sets by the number of the source's set, and the tag of the operation.
    known: BTreeMap<(u32, Option<&'static str>), u32>,
    /// The last of these numbers: many walls of one face follow each other.
    last: Option<((u32, Option<&'static str>), u32)>,
}

impl<'s> FaceTags<'s> {
    pub(super) fn new(source: &'s Mesh) -> Self {
        FaceTags { source, table: TagSetTable::default(), known: BTreeMap::new(), last: None }
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
        let FaceTags { source, table, known, last } = self;
        let key = (own.tags, Some(tag));
        let tags = match last {
            Some((last, number)) if *last == key => *number,
            _ => *known.entry(key).or_insert_with(|| match source.tag_sets().get(own.tags as usize) {
                Some(set) => table.number(&set.renewed(tag)),
                None => table.number(&TagSet::of_operation(tag)),
            }),
        };
        *last = Some((key, tags));
        FaceTag { tags, ..own.uncapped() }
    }

    /// The attributes of a face of the source, or of a piece of it.
    fn same(&mut self, own: FaceTag) -> FaceTag {
        let Some(set) = self.source.tag_sets().get(own.tags as usize).filter(|set| !set.names().is_empty()) else {
            return FaceTag { tags: FaceTag::NONE, ..own };
        };
        let tags = *self.known.entry((own.tags, None)).or_insert_with(|| self.table.number(set));
        FaceTag { tags, ..own }
    }

    /// The attributes with the tags of the edge between two points.
    fn with_edge(&mut self, tag: FaceTag, ends: [u32; 2]) -> FaceTag {
        let Some(set) = self.source.edge_tags(ends) else { return tag };
        let edge = self.table.number(set);
        let tags = if tag.tags == FaceTag::NONE { edge } else { self.table.union(tag.tags, edge) };
        FaceTag { tags, ..tag }
    }

    /// The sets, which tags of faces index. `None` if no face has tags.
    pub(super) fn finish(&mut self) -> Option<Arc<[TagSet]>> {
        (!self.table.is_empty()).then(|| std::mem::take(&mut self.table).into_sets())
    }
}
