//! Rings of one face within one slab into faces: which are outlines, and which holes belong to which.

use std::ops::Range;

use glam::DVec2;

use super::first::first_node;
use super::points::Node;
use super::state::State;
use crate::mesh::check::winding;
use crate::mesh::{FaceTag, Mesh};
use crate::triangulate::Projection;

/// Rings being collected, and buffers.
#[derive(Default)]
pub(super) struct Rings {
    /// Of all rings; those after the last end belong to the ring being made.
    pub(super) nodes: Vec<Node>,
    rings: Vec<Ring>,
    order: Vec<usize>,
    flat: Vec<DVec2>,
    view: Option<(Projection, FaceTag)>,
    /// Corners of the face's outline.
    outline: Range<usize>,
    /// Whether a ring was too short since the last faces were added.
    dropped: bool,
}

struct Ring {
    nodes: Range<usize>,
    area: f64,
    low: DVec2,
    high: DVec2,
    /// Of a hole, the outline it belongs to.
    outline: Option<usize>,
}

impl Rings {
    /// Begins a face.
    pub(super) fn start(&mut self, projection: Projection, tag: FaceTag, outline: Range<usize>) {
        self.view = Some((projection, tag));
        self.outline = outline;
        self.nodes.clear();
        self.rings.clear();
    }

    /// Ends the ring being made. No corner repeats the one before it; what is too short for a ring is dropped.
    pub(super) fn end_ring(&mut self) {
        let start = self.rings.last().map_or(0, |ring| ring.nodes.end);
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
            let (low, high) = (DVec2::INFINITY, DVec2::NEG_INFINITY);
            self.rings.push(Ring { nodes: start..kept, area: 0.0, low, high, outline: None });
        }
        self.nodes.truncate(kept);
    }

    /// Adds the rings to a slab as faces, and forgets them.
    pub(super) fn emit(&mut self, state: &mut State, mesh: &Mesh, slab: u32) {
        let Some((projection, tag)) = self.view else { return };
        if self.rings.len() > 1 {
            self.nest(state, mesh, projection);
        }
        let State { parts, points, .. } = state;
        let part = &mut parts[slab as usize];
        part.dropped |= std::mem::take(&mut self.dropped);
        // Each outline, and its holes behind it.
        self.order.clear();
        self.order.extend(0..self.rings.len());
        let owner = |index: usize| self.rings[index].outline;
        self.order.sort_by_key(|&index| (owner(index).unwrap_or(index), owner(index).is_some()));
        for (place, &index) in self.order.iter().enumerate() {
            let nodes = &mut self.nodes[self.rings[index].nodes.clone()];
            let first = first_node(nodes.iter(), &self.outline);
            nodes.rotate_left(first);
            part.corners(points, mesh, &self.nodes[self.rings[index].nodes.clone()], slab);
            part.end_loop();
            if self.order.get(place + 1).is_none_or(|&next| self.rings[next].outline.is_none()) {
                part.end_face(tag);
            }
        }
        self.nodes.clear();
        self.rings.clear();
    }

    /// Finds the outline of each hole. A hole outside of all outlines, which only a broken face has, stays on its own.
    fn nest(&mut self, state: &State, mesh: &Mesh, projection: Projection) {
        self.flat.clear();
        self.flat.extend(self.nodes.iter().map(|node| projection.apply(state.points.position(mesh, node))));
        for ring in &mut self.rings {
            let flat = &self.flat[ring.nodes.clone()];
            ring.area = flat.windows(2).map(|w| (w[0] - flat[0]).perp_dot(w[1] - flat[0])).sum();
            (ring.low, ring.high) = flat.iter().fold((ring.low, ring.high), |(l, h), &p| (l.min(p), h.max(p)));
        }
        let outlines = self.rings.iter().filter(|ring| 0.0 <= ring.area).count();
        let only = self.rings.iter().position(|ring| 0.0 <= ring.area);
        for hole in 0..self.rings.len() {
            if self.rings[hole].area < 0.0 {
                self.rings[hole].outline = if outlines == 1 { only } else { self.around(hole) };
            }
        }
    }

    /// The smallest outline around a hole.
    fn around(&self, hole: usize) -> Option<usize> {
        let points = &self.flat[self.rings[hole].nodes.clone()];
        let Ring { low, high, .. } = self.rings[hole];
        let holds = |outline: &Ring| {
            if !(outline.low.cmple(low).all() && high.cmple(outline.high).all()) {
                return false;
            }
            let outline = &self.flat[outline.nodes.clone()];
            // Loops may touch at corners: any corner that is off the outline decides.
            points.iter().find_map(|&p| winding(outline, p)).is_some_and(|turns| turns != 0)
        };
        let outlines = self.rings.iter().enumerate().filter(|(_, ring)| 0.0 <= ring.area && holds(ring));
        outlines.min_by(|a, b| a.1.area.total_cmp(&b.1.area)).map(|(index, _)| index)
    }
}
