//! Where edges meet planes. An edge owns its crossings: they are made when the first face asks and found by the others.

use glam::DVec3;

use super::State;
use super::part::{Node, Place};
use crate::mesh::Mesh;
use crate::mesh::table::PairTable;

/// The crossings of a cut, numbered after the points of the mesh; those of one edge follow each other, from low to high.
#[derive(Default)]
pub(super) struct Crossings {
    /// Edge to its first crossing.
    edges: PairTable,
    pub(super) points: Vec<DVec3>,
    /// How far along its edge each is, from the lexicographically first end.
    shares: Vec<f64>,
    /// How many points the mesh has.
    first: usize,
}

impl Crossings {
    pub(super) fn reset(&mut self, first: usize) {
        self.edges.clear();
        self.points.clear();
        self.shares.clear();
        self.first = first;
    }

    /// Where a point is, of the mesh or a crossing.
    #[inline]
    pub(super) fn position(&self, mesh: &Mesh, point: u32) -> DVec3 {
        let point = point as usize;
        if point < self.first { mesh.points[point] } else { self.points[point - self.first] }
    }

    /// How far along its edge a crossing is.
    pub(super) fn share(&self, point: u32) -> f64 {
        self.shares[point as usize - self.first]
    }
}

/// Planes strictly between two classes.
#[inline]
fn between(low: u32, high: u32) -> std::ops::Range<u32> {
    low.div_ceil(2)..high / 2
}

/// Lexicographic order of coordinates: it survives every renumbering.
fn comes_first(a: DVec3, b: DVec3) -> bool {
    a.to_array() < b.to_array()
}

impl State {
    /// Appends the crossings of the edge from one corner to another, in the order they are met.
    #[inline]
    pub(super) fn crossings(&mut self, mesh: &Mesh, from: usize, to: usize, nodes: &mut Vec<Node>) {
        let [a, b] = [from, to].map(|corner| mesh.corners[corner]);
        let [class_a, class_b] = [a, b].map(|point| self.places[point as usize].class);
        let planes = between(class_a.min(class_b), class_a.max(class_b));
        if planes.is_empty() {
            return;
        }
        let next = (self.crossings.first + self.crossings.points.len()) as u32;
        let (base, new) = self.crossings.edges.entry(a.min(b), a.max(b), next);
        let base = *base;
        if new {
            self.make(mesh, a, b, planes.clone());
        }
        // What corners carry is mixed from the same end as the position.
        let carries = !mesh.uvs.is_empty() || !mesh.normals.is_empty();
        let ordered = !carries || comes_first(mesh.points[a as usize], mesh.points[b as usize]);
        let (first, second) = if ordered { (from as u32, to as u32) } else { (to as u32, from as u32) };
        let node =
            |plane: u32| Node { point: base + (plane - planes.start), class: 2 * plane + 1, from: first, to: second };
        if class_a < class_b {
            nodes.extend(planes.clone().map(node));
        } else {
            nodes.extend(planes.clone().rev().map(node));
        }
    }

    fn make(&mut self, mesh: &Mesh, a: u32, b: u32, planes: std::ops::Range<u32>) {
        let axis = self.axis;
        let (p, q) = (mesh.points[a as usize], mesh.points[b as usize]);
        let (p, q) = if comes_first(p, q) { (p, q) } else { (q, p) };
        let along = q - p;
        let (low, high) = (p.min(q), p.max(q));
        for plane in planes {
            let at = self.offsets[plane as usize];
            let mut share = (at - p[axis]) / along[axis];
            let mut x = p + along * share;
            if !x.is_finite() {
                // The ends are so far apart that their difference overflows.
                share = (at * 0.5 - p[axis] * 0.5) / (q[axis] * 0.5 - p[axis] * 0.5);
                x = p * (1.0 - share) + q * share;
            }
            // Rounding does not lead out of the box of the edge.
            x = x.clamp(low, high);
            x[axis] = at;
            self.crossings.points.push(x);
            self.crossings.shares.push(share);
            self.places.push(Place::new(2 * plane + 1));
        }
    }
}
