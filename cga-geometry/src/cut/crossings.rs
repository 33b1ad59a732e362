//! The crossings of edges with planes. The first face that needs them makes them.

use std::ops::Range;

use super::CROSSING;
use super::class::ClassRange;
use super::points::{CutPoints, Location, PieceCorner};
use super::segment::{Segment, comes_first};
use super::slab::Slab;
use crate::each::Each;
use crate::mesh::Mesh;
use crate::work;

impl CutPoints {
    /// The crossing of the edge between two corners with the only plane between them.
    #[inline]
    pub(super) fn crossing(&mut self, parts: &mut [Slab], mesh: &Mesh, plane: u32, from: u32, to: u32) -> PieceCorner {
        let [a, b] = [from, to].each(|corner| mesh.corners[corner as usize]);
        let (number, new) = self.edges.entry(a, b, self.levels[plane as usize].flat.len() as u32);
        if new {
            self.make(parts, mesh, a, b, plane..plane + 1);
        }
        self.node(mesh, Location::on(plane, number), from, to)
    }

    /// Appends the corners of a loop, each with the crossings of the edge after it.
    pub(super) fn cross_loop(
        &mut self,
        parts: &mut [Slab],
        mesh: &Mesh,
        ring: Range<usize>,
        nodes: &mut Vec<PieceCorner>,
    ) {
        for corner in ring.clone() {
            let next = if corner + 1 == ring.end { ring.start } else { corner + 1 };
            let [from, to] = [corner, next].each(|c| PieceCorner::corner(c, self.places[mesh.corners[c] as usize]));
            nodes.push(from);
            let planes = ClassRange::between(from.class(), to.class()).planes().len();
            if !work::spend(CROSSING * planes) {
                return;
            }
            self.cross(parts, mesh, from, to, nodes);
        }
    }

    /// Appends the crossings of the edge from one corner to another, in the order along the edge.
    #[inline]
    pub(super) fn cross(
        &mut self,
        parts: &mut [Slab],
        mesh: &Mesh,
        from: PieceCorner,
        to: PieceCorner,
        nodes: &mut Vec<PieceCorner>,
    ) {
        let planes = ClassRange::between(from.class(), to.class()).planes();
        if planes.is_empty() {
            return;
        }
        if planes.len() == 1 {
            nodes.push(self.crossing(parts, mesh, planes.start, from.from, to.from));
            return;
        }
        let [a, b] = [from, to].each(|corner| mesh.corners[corner.from as usize]);
        let (first, new) = self.edges.entry(a, b, self.crossings.len() as u32);
        if new {
            self.make(parts, mesh, a, b, planes.clone());
        }
        let node = |plane: u32, number: u32| self.node(mesh, Location::on(plane, number), from.from, to.from);
        let crossings = planes.clone().zip(&self.crossings[first as usize..first as usize + planes.len()]);
        if from.class() < to.class() {
            nodes.extend(crossings.map(|(plane, &number)| node(plane, number)));
        } else {
            nodes.extend(crossings.rev().map(|(plane, &number)| node(plane, number)));
        }
    }

    /// The node of a crossing on the edge between two corners.
    #[inline]
    fn node(&self, mesh: &Mesh, place: Location, from: u32, to: u32) -> PieceCorner {
        // The values of corners are interpolated from the same end as the position.
        let point = |corner: u32| mesh.points[mesh.corners[corner as usize] as usize];
        let ordered = !self.mixes || comes_first(point(from), point(to));
        let (from, to) = if ordered { (from, to) } else { (to, from) };
        PieceCorner { place, from, to }
    }

    /// Makes the crossings of an edge. The requesting face has pieces on both sides, so the crossings get numbers
    /// there.
    fn make(&mut self, parts: &mut [Slab], mesh: &Mesh, a: u32, b: u32, planes: Range<u32>) {
        let single = planes.len() == 1;
        let axis = self.axis;
        let (p, q) = (mesh.points[a as usize], mesh.points[b as usize]);
        let segment = Segment::between((p, p[axis]), (q, q[axis]));
        for plane in planes {
            let at = self.planes[plane as usize];
            let (mut x, share) = segment.meet(at);
            x[axis] = at;
            let [below, above] = &mut parts[plane as usize..plane as usize + 2] else { return };
            let numbers = [below.mesh.add_point(x), above.mesh.add_point(x)];
            let number = self.add(plane, x, share, numbers);
            if !single {
                self.crossings.push(number);
            }
        }
    }
}
