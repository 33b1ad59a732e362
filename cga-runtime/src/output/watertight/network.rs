//! The distinct points and edges of the leaves of an initial shape, and the points inside of each edge.

use std::collections::HashMap;
use std::ops::Range;

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
    /// For each corner of all leaves the number of the edge that begins there, or [`NO_EDGE`].
    leaf_edges: Vec<u32>,
    /// For each edge the points inside, from its first to its second end, as a range of `inside`.
    ranges: Vec<[u32; 2]>,
    inside: Vec<u32>,
}

/// The number of an edge whose ends are one place.
const NO_EDGE: u32 = u32::MAX;

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
    /// A network without points. `bounds` are the bounds of the leaves, and `corners` is their number of corners. Sinks write coordinates
    /// relative to an origin, which is computed from the bounds.
    pub(super) fn new(bounds: Bounds, corners: usize) -> Self {
        // Boxes have half as many edges as corners, and share some points and edges.
        let shared = corners / 2;
        Network {
            origin: near_origin(bounds),
            numbers: HashMap::with_capacity_and_hasher(shared / 2, FixedState::default()),
            points: Vec::new(),
            edge_numbers: HashMap::with_capacity_and_hasher(shared, FixedState::default()),
            edges: Vec::new(),
            leaf_points: Vec::new(),
            leaf_edges: Vec::with_capacity(corners),
            ranges: Vec::new(),
            inside: Vec::new(),
        }
    }

    /// Adds the points and edges of a leaf: the edges of a mesh with its points at other places. The mesh of a box is known to have
    /// each edge in both directions.
    pub(super) fn add(&mut self, mesh: &Mesh, places: &[DVec3], is_box: bool) -> LeafPart {
        let (first_point, first_edge) = (self.leaf_points.len(), self.leaf_edges.len());
        for &place in places {
            let number = self.number(place);
            self.leaf_points.push(number);
        }
        let corners = mesh.corners();
        let ends = |from: usize, to: usize| [from, to].each(|corner| first_point + corners[corner] as usize);
        if is_box {
            let (adjacency, mut known) = (mesh.adjacency(), [NO_EDGE; 12]);
            for (edge, known) in known.iter_mut().enumerate().take(adjacency.edge_count()) {
                let corner = adjacency.uses(edge)[0];
                let ends = ends(corner as usize, adjacency.next(corner) as usize).each(|point| self.leaf_points[point]);
                *known = self.edge(ends);
            }
            self.leaf_edges.extend((0..corners.len() as u32).map(|corner| known[adjacency.edge(corner)]));
        } else {
            for [from, to] in mesh.faces().flat_map(|face| face.edges()) {
                let number = self.edge(ends(from, to).each(|point| self.leaf_points[point]));
                self.leaf_edges.push(number);
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

    /// The number of the edge between two points.
    fn edge(&mut self, ends: [u32; 2]) -> u32 {
        if ends[0] == ends[1] {
            return NO_EDGE;
        }
        let next = self.edges.len() as u32;
        let number = *self.edge_numbers.entry(edge_key(ends)).or_insert(next);
        if number == next {
            self.edges.push([ends[0].min(ends[1]), ends[0].max(ends[1])]);
        }
        number
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
        !self.inside.is_empty() && edges.iter().any(|edge| !self.range(*edge).is_empty())
    }

    /// The points inside of the edge of a leaf that begins at a corner, in the direction of its network edge.
    pub(super) fn inside(&self, part: LeafPart, corner: usize) -> &[u32] {
        &self.inside[self.range(self.leaf_edges[part.edges[0] + corner])]
    }

    fn range(&self, edge: u32) -> Range<usize> {
        let [start, end] = self.ranges.get(edge as usize).copied().unwrap_or_default();
        start as usize..end as usize
    }

    /// Returns true if [`Network::inside`] leads from the second to the first of two neighbouring points of the mesh of a leaf.
    pub(super) fn is_turned(&self, part: LeafPart, ends: [u32; 2]) -> bool {
        let ends = ends.each(|end| self.leaf_points[part.points[0] + end as usize]);
        ends[1] < ends[0]
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
