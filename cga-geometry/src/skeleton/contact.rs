//! Contacts at the time of an event.
//!
//! Vertices that coincide form a *cluster*. An edge that a cluster touches between its ends is divided there
//! ([`arrangement`](super::arrangement)). Two segments that leave a cluster in the same direction coincide up to the
//! end of the shorter one, so its far end is a contact too ([`overlap`](super::overlap)), and so on. In this way
//! parallel walls meet all at once.
//!
//! The vertices of an event are compared with the edges near a box around them. Finding these edges takes a walk along the
//! wavefront, and another one if a contact is outside of the box. A vertex usually ends at its event, so over all events
//! this is quadratic. Each further round of an event costs only its new contacts.

use std::collections::BTreeSet;

use glam::DVec2;

use super::SkeletonError;
use super::wavefront::Wavefront;
use crate::disjoint::DisjointSets;
use crate::each::Each;
use crate::nesting::extent::Extent;
use crate::segment::nearest_share;
use crate::small_sort::SmallSort;
use crate::work;

/// The contacts at one time. The lists keep their memory from event to event.
#[derive(Debug, Default)]
pub(super) struct Contacts {
    clusters: DisjointSets,
    /// Vertices with possible contacts. The first `compared` of them have been compared with all others.
    reached: Vec<u32>,
    compared: usize,
    is_reached: Vec<bool>,
    /// The same vertices, sorted, as of the last comparison.
    sorted: Vec<u32>,
    /// The edges near a box around reached vertices, each with a box around it and everything in contact with it.
    near: Vec<(u32, Extent)>,
    /// Edges, each with a vertex that touches it between its ends.
    candidates: Vec<[u32; 2]>,
    /// Edges, each with a vertex that touches it.
    on_edges: BTreeSet<[u32; 2]>,
    /// Vertices where the wavefront changes without another contact: the far ends of overlaps.
    tips: BTreeSet<u32>,
}

impl Contacts {
    /// Forgets all contacts. `vertices` is the number of all vertices.
    pub(super) fn clear(&mut self, vertices: usize) {
        self.clusters.resize(vertices);
        self.is_reached.resize(vertices, false);
        for vertex in self.reached.drain(..) {
            self.clusters.isolate(vertex);
            self.is_reached[vertex as usize] = false;
        }
        self.compared = 0;
        // Clearing an empty set costs more than the test.
        if !self.on_edges.is_empty() {
            self.on_edges.clear();
        }
        if !self.tips.is_empty() {
            self.tips.clear();
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

    /// The vertices with possible contacts, sorted, as of the last comparison.
    pub(super) fn vertices(&self) -> &[u32] {
        &self.sorted
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
    /// Finds the contacts of the reached vertices. An error if the work is to end.
    pub(super) fn compare(&self, contacts: &mut Contacts) -> Result<(), SkeletonError> {
        let squared = self.epsilon * self.epsilon;
        let (mut near, mut candidates) = (std::mem::take(&mut contacts.near), std::mem::take(&mut contacts.candidates));
        let mut around = Extent::EMPTY;
        candidates.clear();
        while let Some(&vertex) = contacts.reached.get(contacts.compared) {
            contacts.compared += 1;
            let here = self.positions[vertex as usize];
            if !around.holds(here) {
                around = Extent::of(contacts.reached.iter().map(|&vertex| self.positions[vertex as usize]));
                self.put_edges_near(&around, &mut near);
            }
            if !work::spend(near.len()) {
                return Err(SkeletonError::Tangled);
            }
            for &(edge, _) in near.iter().filter(|(_, around)| around.holds(here)) {
                let next = self.vertices[edge as usize].next;
                let [start, end] = [edge, next].each(|vertex| self.positions[vertex as usize]);
                if start.distance_squared(here) <= squared {
                    // The vertex is reached already.
                    if edge != vertex {
                        contacts.reach(edge);
                        contacts.clusters.unite(vertex, edge);
                    }
                } else if squared < end.distance_squared(here) && to_segment(here, start, end) <= squared {
                    // Only these are listed: a list of all vertices in boxes is quadratic where a disk ends in a point.
                    candidates.push([edge, vertex]);
                }
            }
        }
        contacts.sorted.clone_from(&contacts.reached);
        contacts.sorted.small_sort();
        contacts.clusters.flatten_some(&contacts.sorted);
        for &[edge, vertex] in &candidates {
            let cluster = contacts.cluster(vertex);
            if ![edge, self.vertices[edge as usize].next].each(|end| contacts.cluster(end)).contains(&cluster) {
                contacts.touch(edge, vertex);
            }
        }
        (contacts.near, contacts.candidates) = (near, candidates);
        Ok(())
    }

    /// Lists the edges near a box.
    fn put_edges_near(&self, place: &Extent, near: &mut Vec<(u32, Extent)>) {
        let margin = DVec2::splat(2.0 * self.epsilon);
        let around = |&edge: &u32| {
            let [a, b] = [edge, self.vertices[edge as usize].next].each(|vertex| self.positions[vertex as usize]);
            (edge, Extent { low: a.min(b) - margin, high: a.max(b) + margin })
        };
        near.clear();
        near.extend(self.alive.iter().map(around).filter(|(_, around)| around.meets(place)));
    }
}

/// The square of the distance from a point to a segment.
pub(super) fn to_segment(p: DVec2, a: DVec2, b: DVec2) -> f64 {
    (p - a - (b - a) * nearest_share(p, [a, b])).length_squared()
}

#[cfg(test)]
mod tests {
    use super::super::Speeds;
    use super::*;

    /// The vertices of a disk meet at its centre, so each of them is in the boxes of all edges there.
    #[test]
    fn the_candidates_are_not_the_vertices_that_coincide() {
        let count = 500;
        let angle = |i: u32| std::f64::consts::TAU * f64::from(i) / f64::from(count);
        let points: Vec<DVec2> = (0..count).map(|i| DVec2::new(libm::cos(angle(i)), libm::sin(angle(i)))).collect();
        let ring: Vec<u32> = (0..count).collect();
        let mut front = Wavefront::new(&points, &[ring], Speeds::Equal, 1e-10, 2.0).expect("a polygon");
        front.now = libm::cos(0.5 * angle(1));
        front.place();
        let mut contacts = Contacts::default();
        contacts.clear(count as usize);
        (0..count).for_each(|vertex| contacts.reach(vertex));
        front.compare(&mut contacts).expect("the work goes on");
        assert!((0..count).all(|vertex| contacts.cluster(vertex) == 0));
        assert!(contacts.candidates.is_empty() && contacts.touched() == 0);
    }
}
