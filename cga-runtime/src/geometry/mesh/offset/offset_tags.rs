//! The tags of the parts of offset faces (*Geometry tagging*, tag propagation).

use super::RingCorner;
use crate::geometry::mesh::flat_face::FlatFace;
use crate::geometry::mesh::{FaceRef, FaceTag, Mesh, PartTags, SubcomponentTagger};
use crate::value::each::Each;

/// Collects the tags of all parts. Parts have the tags of their face, strips also the tags of their edge. An edge from a corner of
/// the face to a new corner has the tags of the old one, and other new edges have none.
pub(super) struct OffsetTags<'s> {
    source: &'s Mesh,
    parts: PartTags<'s>,
    tagger: SubcomponentTagger,
}

impl<'s> OffsetTags<'s> {
    pub(super) fn new(source: &'s Mesh) -> Self {
        OffsetTags { source, parts: PartTags::new(source, ""), tagger: SubcomponentTagger::default() }
    }

    /// The tag of an interior.
    pub(super) fn inside(&mut self, plane: &FlatFace<'_>) -> FaceTag {
        self.parts.same(plane.face.tag())
    }

    /// The tag of the strip of an edge, between two corners counted from the first one of the face.
    pub(super) fn strip(&mut self, plane: &FlatFace<'_>, edge: [usize; 2]) -> FaceTag {
        let ends = edge.each(|corner| plane.points[plane.corners[corner] as usize]);
        self.parts.beside_edge(plane.face.tag(), ends)
    }

    /// Tags the edges and vertices of a loop: its points in the plane, and in the mesh.
    pub(super) fn ring(&mut self, plane: &FlatFace<'_>, ring: &[RingCorner], numbers: &[u32]) {
        let source = |k: u32| plane.points.get(ring[k as usize].0 as usize).copied();
        let corners: Vec<u32> = (0..ring.len() as u32).collect();
        self.tagger.grow_ring(self.source, &corners, |k| numbers[k as usize], source);
    }

    /// Adds a copy of a face with all its tags.
    pub(super) fn copy(&mut self, face: &FaceRef<'_>, made: &mut Mesh) {
        let tag = self.parts.same(face.tag());
        made.add_tagged_copy(face, tag, &mut self.tagger);
    }

    /// Gives the tags to the mesh of all parts.
    pub(super) fn finish(self, made: &mut Mesh) {
        made.tag_sets = self.parts.finish();
        made.put_tags(self.tagger);
    }
}
