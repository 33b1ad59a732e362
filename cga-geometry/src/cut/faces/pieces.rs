//! Groups the rings of one face within one slab into faces: outlines with their holes.

use std::ops::Range;

use crate::cut::faces::first_edge::first_node;
use crate::cut::points::PieceCorner;
use crate::cut::state::CutState;
use crate::mesh::{FaceTag, Mesh};
use crate::nesting::Nest;
use crate::triangulate::PlaneProjection;

/// The rings collected so far, and buffers.
#[derive(Default)]
pub(crate) struct Rings {
    /// The nodes of all rings. The nodes after the last end belong to the current ring.
    pub(crate) nodes: Vec<PieceCorner>,
    ends: Vec<usize>,
    view: Option<(PlaneProjection, FaceTag)>,
    /// The corners of the face's outline.
    outline: Range<usize>,
    /// True if a ring was dropped since the last faces were added.
    dropped: bool,
    nest: Nest,
}

impl Rings {
    /// Begins a face.
    pub(crate) fn start(&mut self, projection: PlaneProjection, tag: FaceTag, outline: Range<usize>) {
        self.view = Some((projection, tag));
        self.outline = outline;
        self.nodes.clear();
        self.ends.clear();
    }

    /// Ends the current ring. Repeated corners are removed, and rings with fewer than three corners are dropped.
    pub(crate) fn end_ring(&mut self) {
        let start = self.ends.last().copied().unwrap_or(0);
        if close_ring(&mut self.nodes, start, |node| node.place) {
            self.ends.push(self.nodes.len());
        } else {
            self.dropped = true;
        }
    }

    /// Adds the rings to a slab as faces, and clears the list. A hole outside all outlines, which only a broken face
    /// has, becomes a face of its own.
    pub(crate) fn emit(&mut self, state: &mut CutState, mesh: &Mesh, slab: u32) {
        let Some((projection, tag)) = self.view else { return };
        let at = |node: usize| projection.apply(state.points.position(mesh, &self.nodes[node]));
        self.nest.sort_rings(&self.ends, at);
        let CutState { parts, points, .. } = state;
        let part = &mut parts[slab as usize];
        part.dropped |= std::mem::take(&mut self.dropped);
        for rings in self.nest.groups() {
            for ring in rings {
                let nodes = &mut self.nodes[ring.clone()];
                nodes.rotate_left(first_node(nodes.iter(), &self.outline));
                part.corners(points, mesh, nodes, slab);
                part.mesh.end_loop();
            }
            part.mesh.end_face(tag);
        }
        self.nodes.clear();
        self.ends.clear();
    }
}

/// Ends a ring of nodes that begins at `start`. Corners with the key of their predecessor are removed, and so is a ring
/// with fewer than three corners. Returns whether the ring remains.
pub(crate) fn close_ring<T: Copy, K: PartialEq>(nodes: &mut Vec<T>, start: usize, key: impl Fn(&T) -> K) -> bool {
    let mut kept = start;
    for at in start..nodes.len() {
        if kept == start || key(&nodes[kept - 1]) != key(&nodes[at]) {
            nodes[kept] = nodes[at];
            kept += 1;
        }
    }
    if kept > start + 1 && key(&nodes[kept - 1]) == key(&nodes[start]) {
        kept -= 1;
    }
    let remains = start + 3 <= kept;
    nodes.truncate(if remains { kept } else { start });
    remains
}
