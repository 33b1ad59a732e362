//! Groups the rings of one face within one slab into faces: outlines with their holes.

use std::ops::Range;

use glam::DVec2;

use crate::geometry::cut::faces::first_edge::first_node;
use crate::geometry::cut::points::PieceCorner;
use crate::geometry::cut::state::State;
use crate::geometry::mesh::{FaceTag, Mesh};
use crate::geometry::nesting::Nest;
use crate::geometry::nesting::contour::Section;
use crate::geometry::triangulate::Projection;

/// The rings collected so far, and buffers.
#[derive(Default)]
pub(crate) struct Rings {
    /// The nodes of all rings. The nodes after the last end belong to the current ring.
    pub(crate) nodes: Vec<PieceCorner>,
    ends: Vec<usize>,
    view: Option<(Projection, FaceTag)>,
    /// The corners of the face's outline.
    outline: Range<usize>,
    /// True if a ring was dropped since the last faces were added.
    dropped: bool,
    nest: Nest,
    flat: Vec<DVec2>,
    numbers: Vec<u32>,
}

impl Rings {
    /// Begins a face.
    pub(crate) fn start(&mut self, projection: Projection, tag: FaceTag, outline: Range<usize>) {
        self.view = Some((projection, tag));
        self.outline = outline;
        self.nodes.clear();
        self.ends.clear();
    }

    /// Ends the current ring. Repeated corners are removed, and rings with fewer than three corners are dropped.
    pub(crate) fn end_ring(&mut self) {
        let start = self.ends.last().copied().unwrap_or(0);
        let mut kept = start;
        for i in start..self.nodes.len() {
            if kept == start || self.nodes[kept - 1].place != self.nodes[i].place {
                self.nodes[kept] = self.nodes[i];
                kept += 1;
            }
        }
        if kept > start + 1 && self.nodes[kept - 1].place == self.nodes[start].place {
            kept -= 1;
        }
        if kept < start + 3 {
            self.dropped = true;
            kept = start;
        } else {
            self.ends.push(kept);
        }
        self.nodes.truncate(kept);
    }

    /// Adds the rings to a slab as faces, and clears the list. A hole outside all outlines, which only a broken face
    /// has, becomes a face of its own.
    pub(crate) fn emit(&mut self, state: &mut State, mesh: &Mesh, slab: u32) {
        let Some((projection, tag)) = self.view else { return };
        if let [end] = self.ends[..] {
            self.nest.single(end);
        } else {
            self.flat.clear();
            self.flat.extend(self.nodes.iter().map(|node| projection.apply(state.points.position(mesh, node))));
            self.numbers.clear();
            self.numbers.extend(0..self.nodes.len() as u32);
            self.nest.sort(&Section { flat: &self.flat, corners: &self.numbers, ends: &self.ends });
        }
        let State { parts, points, .. } = state;
        let part = &mut parts[slab as usize];
        part.dropped |= std::mem::take(&mut self.dropped);
        let mut start = 0;
        for &end in &self.nest.ends {
            for ring in &self.nest.order[start..end] {
                let nodes = &mut self.nodes[ring.clone()];
                nodes.rotate_left(first_node(nodes.iter(), &self.outline));
                part.corners(points, mesh, nodes, slab);
                part.mesh.end_loop();
            }
            part.mesh.end_face(tag);
            start = end;
        }
        self.nodes.clear();
        self.ends.clear();
    }
}
