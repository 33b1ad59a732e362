//! The tags of edges and vertices of parts of faces (*setback operation*, *Geometry tagging*).

use std::collections::BTreeMap;

use super::RingCorner;
use crate::geometry::mesh::{FaceRef, Mesh, SubcomponentTagger, TagSet};
use crate::value::each::Each;

/// The kind of a side of a setback or of its remainder.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum SideKind {
    /// An edge of the face that was set back.
    Front,
    /// The new place of such an edge.
    Back,
    /// An end of a setback.
    End,
    /// An edge of the face that is left.
    Remainder,
}

impl SideKind {
    fn tag(self) -> &'static str {
        match self {
            SideKind::Front => "setback.front",
            SideKind::Back => "setback.back",
            SideKind::End => "setback.side",
            SideKind::Remainder => "setback.remainder",
        }
    }
}

/// The origin of a side of a part.
#[derive(Clone, Copy, Debug)]
pub(super) struct SideOrigin {
    pub(super) kind: SideKind,
    /// The edge of the face from which it comes: the number of the corner where the edge begins, counted from the first one
    /// of the face.
    pub(super) edge: Option<usize>,
}

/// Collects the tags of all parts. A side has the tags of the edge from which it comes, and the tag of its kind in place of
/// other tags of setbacks.
pub(crate) struct SideTags<'s> {
    source: &'s Mesh,
    /// True if the kinds of sides are tagged.
    tags_kinds: bool,
    tagger: SubcomponentTagger,
    /// The sets of sides by the number of the source's set and by kind.
    known: BTreeMap<(Option<u32>, SideKind), TagSet>,
}

impl<'s> SideTags<'s> {
    /// Tags for parts of the faces of a mesh.
    pub(crate) fn new(source: &'s Mesh, tags_kinds: bool) -> Self {
        SideTags { source, tags_kinds, tagger: SubcomponentTagger::default(), known: BTreeMap::new() }
    }

    /// Returns true if nothing is tagged.
    fn is_idle(&self) -> bool {
        !self.tags_kinds && self.source.subcomponent_tags.is_empty()
    }

    /// Tags the side between two points. `from` are the points of the source's edge from which it comes, and `vertex` the one at
    /// an end of the side if the side comes from no edge.
    fn side(&mut self, ends: [u32; 2], kind: SideKind, from: Option<[u32; 2]>, vertex: Option<u32>) {
        let tags = &self.source.subcomponent_tags;
        let own = match (from, vertex) {
            (Some(from), _) => tags.edge_set(from),
            (None, Some(vertex)) => tags.vertex_set(vertex),
            (None, None) => None,
        };
        let tags_kinds = self.tags_kinds;
        let set = self.known.entry((own, kind)).or_insert_with(|| {
            let set = own.map_or_else(TagSet::default, |own| tags.sets()[own as usize].without(Some("setback")));
            if tags_kinds { set.with(&kind.tag().into()) } else { set }
        });
        self.tagger.edge(ends, set);
    }

    /// Tags the sides and vertices of a loop: its points in the plane of a face, and in the mesh. `points` are the points of the
    /// face, and `ends` the ends of its edges, by their first corners.
    pub(super) fn ring(
        &mut self,
        points: &[u32],
        ends: &[[u32; 2]],
        origins: &BTreeMap<[u32; 2], SideOrigin>,
        ring: &[RingCorner],
        numbers: &[u32],
    ) {
        if self.is_idle() {
            return;
        }
        let vertex = |k: usize| points.get(ring[k % ring.len()].0 as usize).copied();
        for k in 0..ring.len() {
            if let Some(vertex) = vertex(k) {
                self.vertex(numbers[k], vertex);
            }
            let next = (k + 1) % ring.len();
            if let Some(SideOrigin { kind, edge }) = origins.get(&[ring[k].0, ring[next].0]) {
                let from = edge.map(|corner| ends[corner]);
                self.side([numbers[k], numbers[next]], *kind, from, vertex(k).or(vertex(next)));
            }
        }
    }

    /// Tags a vertex that is a vertex of the source.
    fn vertex(&mut self, point: u32, source: u32) {
        if let Some(set) = self.source.vertex_tags(source) {
            self.tagger.vertex(point, set);
        }
    }

    /// Tags the copy of a face that is the last one of a mesh: all its edges are left.
    pub(crate) fn whole(&mut self, face: &FaceRef<'_>, made: &Mesh) {
        if self.is_idle() {
            return;
        }
        let first = made.corners.len() - face.corner_count();
        let range = face.corner_range();
        for edge in face.edges() {
            let ends = edge.each(|corner| made.corners[first + corner - range.start]);
            let from = edge.each(|corner| face.mesh.corners[corner]);
            self.side(ends, SideKind::Remainder, Some(from), None);
            self.vertex(ends[0], from[0]);
        }
    }

    /// Gives the tags to the mesh of all parts.
    pub(crate) fn finish(self, made: &mut Mesh) {
        made.put_tags(self.tagger);
    }
}
