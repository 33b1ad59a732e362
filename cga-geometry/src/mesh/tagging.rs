//! Changes of the tags of a mesh, and of the marks of caps.

use std::sync::Arc;

use super::tag::{TagSet, TagSetTable, TaggedComponents};
use super::{FaceTag, Mesh};

impl Mesh {
    /// The mesh with a tag on every face.
    pub fn with_tagged_faces(&self, name: &str) -> Mesh {
        self.with_face_tags(|set| set.with(name))
    }

    /// The mesh with a tag on every edge.
    pub fn with_tagged_edges(&self, name: &str) -> Mesh {
        Mesh { subcomponent_tags: self.subcomponent_tags.with_edges(self.face_edges(), name), ..self.clone() }
    }

    /// The mesh with a tag on every vertex.
    pub fn with_tagged_vertices(&self, name: &str) -> Mesh {
        Mesh { subcomponent_tags: self.subcomponent_tags.with_vertices(self.points.len(), name), ..self.clone() }
    }

    /// The mesh without some tags of some components.
    pub fn without_tags(&self, goes: &dyn Fn(&str) -> bool, components: TaggedComponents) -> Mesh {
        let subcomponent_tags = self.subcomponent_tags.without(goes, components);
        let mesh = if components.faces() { self.with_face_tags(|set| set.without(goes)) } else { self.clone() };
        Mesh { subcomponent_tags, ..mesh }
    }

    /// The tags of faces, in any order; some more than once.
    pub fn face_tag_names(&self) -> impl Iterator<Item = &Arc<str>> {
        let mut used = vec![false; self.tag_sets.len()];
        for (_, tag) in self.tags.runs() {
            if let Some(used) = used.get_mut(tag.tags as usize) {
                *used = true;
            }
        }
        self.tag_sets.iter().zip(used).filter(|(_, used)| *used).flat_map(|(set, _)| set.names())
    }

    /// Returns true if it has a cap that no operation on texture coordinates has reached.
    pub fn has_unmapped_caps(&self) -> bool {
        self.tags.runs().iter().any(|(_, tag)| tag.is_unmapped_cap())
    }

    /// The mesh whose caps are reached by operations on texture coordinates.
    pub fn with_mapped_caps(&self) -> Mesh {
        Mesh { tags: self.tags.mapped(|tag| FaceTag { mapped: tag.cap, ..tag }), ..self.clone() }
    }

    /// The mesh with other sets of tags on its faces.
    fn with_face_tags(&self, change: impl Fn(&TagSet) -> TagSet) -> Mesh {
        let mut table = TagSetTable::default();
        let plain = TagSet::default();
        let mut number = |tag: &FaceTag| {
            let set = change(self.tag_sets.get(tag.tags as usize).unwrap_or(&plain));
            if set == plain { FaceTag::NONE } else { table.number(&set) }
        };
        let tags = self.tags.mapped(|tag| FaceTag { tags: number(&tag), ..tag });
        Mesh { tags, tag_sets: table.into_sets().into(), ..self.clone() }
    }
}
