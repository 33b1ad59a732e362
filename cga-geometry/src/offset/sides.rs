//! The origins of the sides of parts of faces.

use std::collections::BTreeMap;

use crate::derive::{Derivation, EdgeOrigin, EdgeSource};
use crate::each::Each;
use crate::mesh::FaceRef;

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

/// The origins of sides, by their points in the plane.
pub(super) type SideOrigins = BTreeMap<[u32; 2], SideOrigin>;

/// Gives the origins of the sides of parts of a face. A side has the tags of the edge from which it comes, or else of a vertex
/// at its ends, and the tag of its kind in place of other tags of setbacks.
pub(super) struct Sides<'a> {
    face: FaceRef<'a>,
    /// The ends of the edges of the face, by their first corners.
    ends: Vec<[u32; 2]>,
    /// True if the kinds of sides are tagged.
    tags_kinds: bool,
}

impl<'a> Sides<'a> {
    pub(super) fn of(face: &FaceRef<'a>, tags_kinds: bool) -> Self {
        let ends = face.edges().map(|edge| edge.each(|corner| face.mesh.corners()[corner])).collect();
        Sides { face: *face, ends, tags_kinds }
    }

    /// The sides of a loop, by its points in the plane and in the mesh. `points` are the points of the face.
    pub(super) fn of_loop(
        &self,
        made: &mut Derivation<'_>,
        points: &[u32],
        origins: &SideOrigins,
        ring: &[u32],
        numbers: &[u32],
    ) {
        if !self.tags_kinds && !made.has_component_tags() {
            return;
        }
        for k in 0..ring.len() {
            let next = (k + 1) % ring.len();
            let Some(origin) = origins.get(&[ring[k], ring[next]]) else { continue };
            let vertex = || [k, next].into_iter().find_map(|k| points.get(ring[k] as usize).copied());
            let source = match origin.edge {
                Some(corner) => EdgeSource::Edge(self.ends[corner]),
                None => vertex().map_or(EdgeSource::New, EdgeSource::Vertex),
            };
            self.side(made, [numbers[k], numbers[next]], source, origin.kind);
        }
    }

    fn side(&self, made: &mut Derivation<'_>, ends: [u32; 2], source: EdgeSource, kind: SideKind) {
        made.edge(ends, EdgeOrigin { source, tag: self.tags_kinds.then(|| kind.tag()) });
    }

    /// Adds a copy of the face, of which all edges are left.
    pub(super) fn copy(&self, made: &mut Derivation<'_>) {
        let rings = made.copy(&self.face);
        let sides = rings.iter().flat_map(|ring| ring.iter().zip(ring.iter().cycle().skip(1)));
        for ((a, b), ends) in sides.zip(&self.ends) {
            self.side(made, [*a, *b], EdgeSource::Edge(*ends), SideKind::Remainder);
        }
    }
}
