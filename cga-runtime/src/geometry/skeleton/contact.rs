//! Contacts at the time of an event.
//!
//! Vertices that coincide form a *cluster*. An edge that a cluster touches between its ends is divided there
//! ([`arrangement`](super::arrangement)). Two segments that leave a cluster in the same direction coincide up to the
//! end of the shorter one, so its far end is a contact too ([`overlap`](super::overlap)), and so on. In this way
//! parallel walls meet all at once.
//!
//! A vertex is compared with the whole wavefront once per event that it takes part in, and it usually ends there. Over
//! all events this is quadratic. Each further round of an event costs only its contacts, not the wavefront.

use std::collections::BTreeSet;

use glam::DVec2;

use super::wavefront::Wavefront;
use crate::geometry::disjoint::DisjointSets;
use crate::geometry::segment::nearest_share;

/// The contacts at one time.
#[derive(Debug)]
pub(super) struct Contacts {
    clusters: DisjointSets,
    /// Vertices with possible contacts. The first `compared` of them have been compared with all others.
    reached: Vec<u32>,
    compared: usize,
    is_reached: Vec<bool>,
    /// Edges, each with a vertex that touches it.
    on_edges: BTreeSet<[u32; 2]>,
    /// Vertices where the wavefront changes without another contact: the far ends of overlaps.
    tips: BTreeSet<u32>,
}

impl Contacts {
    pub(super) fn new(vertices: usize) -> Self {
        Contacts {
            clusters: DisjointSets::new(vertices),
            reached: Vec::new(),
            compared: 0,
            is_reached: vec![false; vertices],
            on_edges: BTreeSet::new(),
            tips: BTreeSet::new(),
        }
    }

    pub(super) fn reach(&mut self, vertex: u32) {
        if !std::mem::replace(&mut self.is_reached[vertex as usize], true) {
            self.reached.push(vertex);
        }
    }

    pub(super) fn coincide(&mut self, a: u32, b: u32) {
        self.reach(a);
        self.reach(b);
        self.clusters.unite(a, b);
    }

    /// Records that a vertex touches an edge, at any distance. Returns whether this is new.
    pub(super) fn touch(&mut self, edge: u32, vertex: u32) -> bool {
        self.reach(vertex);
        self.on_edges.insert([edge, self.clusters.find(vertex)])
    }

    /// Records that a vertex is the far end of an overlap. Returns whether this is new.
    pub(super) fn tip(&mut self, vertex: u32) -> bool {
        self.reach(vertex);
        self.tips.insert(vertex)
    }

    /// The cluster of a vertex, named by its first vertex. A vertex without contacts is a cluster of its own.
    #[inline]
    pub(super) fn cluster(&self, vertex: u32) -> u32 {
        self.clusters.find(vertex)
    }

    /// The vertices with possible contacts, sorted.
    pub(super) fn vertices(&self) -> Vec<u32> {
        let mut vertices = self.reached.clone();
        vertices.sort_unstable();
        vertices
    }

    /// Edges, each with a vertex that touches it, in the order of edges.
    pub(super) fn on_edges(&self) -> impl Iterator<Item = [u32; 2]> {
        self.on_edges.iter().copied()
    }

    /// The number of contacts between an edge and a vertex.
    pub(super) fn touched(&self) -> usize {
        self.on_edges.len()
    }

    /// The vertices that are far ends of overlaps.
    pub(super) fn tips(&self) -> impl Iterator<Item = u32> {
        self.tips.iter().copied()
    }
}

impl Wavefront {
    /// Finds the contacts of the reached vertices.
    pub(super) fn compare(&self, contacts: &mut Contacts) {
        let near = self.epsilon * self.epsilon;
        let first = contacts.compared;
        while let Some(&vertex) = contacts.reached.get(contacts.compared) {
            contacts.compared += 1;
            let here = self.positions[vertex as usize];
            for &other in &self.alive {
                if self.positions[other as usize].distance_squared(here) <= near && other != vertex {
                    contacts.coincide(vertex, other);
                }
            }
        }
        contacts.clusters.flatten();
        for index in first..contacts.reached.len() {
            let vertex = contacts.reached[index];
            let (here, cluster) = (self.positions[vertex as usize], contacts.cluster(vertex));
            for &edge in &self.alive {
                let next = self.vertices[edge as usize].next;
                let [start, end] = [edge, next].map(|vertex| self.positions[vertex as usize]);
                let (low, high) = (start.min(end) - self.epsilon, start.max(end) + self.epsilon);
                let is_near = here.cmpge(low).all() && here.cmple(high).all();
                if is_near
                    && ![edge, next].map(|end| contacts.cluster(end)).contains(&cluster)
                    && to_segment(here, start, end) <= near
                {
                    contacts.touch(edge, vertex);
                }
            }
        }
    }
}

/// The square of the distance from a point to a segment.
pub(super) fn to_segment(p: DVec2, a: DVec2, b: DVec2) -> f64 {
    (p - a - (b - a) * nearest_share(p, [a, b])).length_squared()
}
