//! The distinct points and edges of the leaves of an initial shape, and the points inside of each edge.

use std::collections::HashMap;

use glam::DVec3;

use super::search::Search;
use crate::fixed_hash::FixedState;
use crate::geometry::each::Each;
use crate::geometry::mesh::{Bounds, Mesh};
use crate::output::near_origin::near_origin;

/// Points at this share of the largest coordinate from an edge are in it: some steps of a 32-bit float.
const IN_EDGE: f64 = 5e-7;

/// The largest distance from an edge in metres at which a point is in it.
const FAR: f64 = 0.004;

/// The distinct points and edges. Tables are only for look-ups, never iterated.
pub(super) struct Network {
    origin: DVec3,
    /// The number of each place as sinks write it: in 32 bits, by its bits.
    numbers: HashMap<[u32; 3], u32, FixedState>,
    /// The first point at each place.
    points: Vec<DVec3>,
    edge_numbers: HashMap<u64, u32, FixedState>,
    /// The ends of each edge, the lower number first.
    edges: Vec<[u32; 2]>,
    /// The numbers of the points of all leaves.
    leaf_points: Vec<u32>,
    /// The numbers of the edges of all leaves, in the order of their loops.
    leaf_edges: Vec<u32>,
    /// For each edge the points inside, from its first to its second end, as a range of `inside`.
    ranges: Vec<[u32; 2]>,
    inside: Vec<u32>,
}

/// The points and edges of a leaf in a [`Network`].
#[derive(Clone, Copy, Debug)]
pub(super) struct LeafPart {
    points: [usize; 2],
    edges: [usize; 2],
}

impl LeafPart {
    /// The number of points and edges.
    pub(super) fn size(self) -> usize {
        self.points[1] - self.points[0] + self.edges[1] - self.edges[0]
    }
}

impl Network {
    /// A network without points. Sinks write coordinates relative to an origin that follows from the bounds.
    pub(super) fn new(bounds: Bounds) -> Self {
        Network {
            origin: near_origin(bounds),
            numbers: HashMap::default(),
            points: Vec::new(),
            edge_numbers: HashMap::default(),
            edges: Vec::new(),
            leaf_points: Vec::new(),
            leaf_edges: Vec::new(),
            ranges: Vec::new(),
            inside: Vec::new(),
        }
    }

    /// Adds the points and edges of a leaf: the edges of a mesh with its points at other places.
    pub(super) fn add(&mut self, mesh: &Mesh, places: &[DVec3], is_closed: bool) -> LeafPart {
        let (first_point, first_edge) = (self.leaf_points.len(), self.leaf_edges.len());
        for &place in places {
            let number = self.number(place);
            self.leaf_points.push(number);
        }
        for face in mesh.faces() {
            for ring in face.loops() {
                let Some(&last) = ring.last() else { continue };
                let mut from = last;
                for &to in ring {
                    // A closed mesh has each edge in both directions.
                    if from < to || !is_closed {
                        let ends = [from, to].each(|end| self.leaf_points[first_point + end as usize]);
                        self.add_edge(ends);
                    }
                    from = to;
                }
            }
        }
        LeafPart { points: [first_point, self.leaf_points.len()], edges: [first_edge, self.leaf_edges.len()] }
    }

    fn number(&mut self, place: DVec3) -> u32 {
        // −0 and 0 are one place.
        let key = (place - self.origin).as_vec3().to_array().each(|c| (c + 0.0).to_bits());
        let next = self.points.len() as u32;
        let number = *self.numbers.entry(key).or_insert(next);
        if number == next {
            self.points.push(place);
        }
        number
    }

    fn add_edge(&mut self, ends: [u32; 2]) {
        if ends[0] == ends[1] {
            return;
        }
        let next = self.edges.len() as u32;
        let number = *self.edge_numbers.entry(edge_key(ends)).or_insert(next);
        if number == next {
            self.edges.push([ends[0].min(ends[1]), ends[0].max(ends[1])]);
        }
        self.leaf_edges.push(number);
    }

    /// The distance in metres within which a point is in an edge.
    pub(super) fn near(&self) -> f64 {
        let reach = |point: &DVec3| Some((*point - self.origin).abs().max_element()).filter(|reach| reach.is_finite());
        (IN_EDGE * self.points.iter().filter_map(reach).fold(0.0, f64::max)).min(FAR)
    }

    /// Finds the points inside of each edge. Returns false if the work is to end; no edge has points then.
    pub(super) fn find_points(&mut self) -> bool {
        let search = Search { points: &self.points, edges: &self.edges, origin: self.origin, near: self.near() };
        match search.points_in_edges() {
            Some((ranges, inside)) => {
                (self.ranges, self.inside) = (ranges, inside);
                true
            }
            None => false,
        }
    }

    /// Returns true if a point is inside of an edge of a leaf.
    pub(super) fn divides(&self, part: LeafPart) -> bool {
        let edges = &self.leaf_edges[part.edges[0]..part.edges[1]];
        !self.inside.is_empty() && edges.iter().any(|edge| self.ranges[*edge as usize] != [0; 2])
    }

    /// The points inside of an edge of a leaf with these points of its mesh as ends, and true if they come from the second end to the
    /// first.
    pub(super) fn inside(&self, part: LeafPart, ends: [u32; 2]) -> (&[u32], bool) {
        let ends = ends.each(|end| self.leaf_points[part.points[0] + end as usize]);
        let range = self.edge_numbers.get(&edge_key(ends)).and_then(|edge| self.ranges.get(*edge as usize));
        let [start, end] = range.copied().unwrap_or_default();
        (&self.inside[start as usize..end as usize], ends[1] < ends[0])
    }

    /// The place of a point, in the world.
    pub(super) fn place(&self, point: u32) -> DVec3 {
        self.points[point as usize]
    }
}

/// The edge between two points, in any direction.
fn edge_key([a, b]: [u32; 2]) -> u64 {
    u64::from(a.min(b)) << 32 | u64::from(a.max(b))
}
