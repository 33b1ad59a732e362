//! The distinct points and edges of the leaves of an initial shape, and the points inside of each edge.

use std::ops::Range;

use glam::DVec3;

use super::numbered_keys::NumberedKeys;
use super::search::Search;
use crate::geometry::each::Each;
use crate::geometry::mesh::{Bounds, Mesh};
use crate::output::near_origin::near_origin;

/// Points at this share of the largest coordinate from an edge are in it: some steps of a 32-bit float.
const IN_EDGE: f64 = 5e-7;

/// The largest distance from an edge in metres at which a point is in it.
const FAR: f64 = 0.004;

/// The distinct points and edges.
pub(super) struct Network {
    origin: DVec3,
    /// The places as sinks write them: in 32 bits, by their bits.
    places: NumberedKeys<[u32; 3]>,
    /// The first point at each place.
    points: Vec<DVec3>,
    /// The ends of each edge, the lower number first.
    edges: NumberedKeys<[u32; 2]>,
    /// The numbers of the points of all leaves.
    leaf_points: Vec<u32>,
    /// For each corner of all leaves the number of the edge that begins there, or [`NO_EDGE`].
    leaf_edges: Vec<u32>,
    /// For each edge the points inside, from its first to its second end, as a range of `inside`.
    ranges: Vec<[u32; 2]>,
    inside: Vec<u32>,
    /// The largest distance of a point from the origin along an axis.
    reach: f64,
    box_edges: BoxEdges,
}

/// The edges of the mesh of a box. Most boxes have the mesh of the box before them.
#[derive(Debug, Default)]
struct BoxEdges {
    /// The address of the mesh.
    mesh: usize,
    /// The points at the ends of each edge.
    ends: Vec<[u32; 2]>,
    /// The edge that begins at each corner.
    of_corner: Vec<u32>,
    /// The numbers of the edges of a box.
    numbers: Vec<u32>,
}

impl BoxEdges {
    /// Changes to the edges of a mesh.
    fn read(&mut self, mesh: &Mesh) {
        let address = std::ptr::from_ref(mesh).addr();
        if self.mesh == address {
            return;
        }
        let (adjacency, corners) = (mesh.adjacency(), mesh.corners());
        let first = |edge: usize| adjacency.uses(edge)[0];
        let ends = |corner: u32| [corner, adjacency.next(corner)].each(|corner| corners[corner as usize]);
        self.mesh = address;
        self.ends = (0..adjacency.edge_count()).map(|edge| ends(first(edge))).collect();
        self.of_corner = (0..corners.len() as u32).map(|corner| adjacency.edge(corner) as u32).collect();
    }
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
        Network {
            origin: near_origin(bounds),
            places: NumberedKeys::default(),
            points: Vec::new(),
            edges: NumberedKeys::default(),
            leaf_points: Vec::new(),
            leaf_edges: Vec::with_capacity(corners),
            ranges: Vec::new(),
            inside: Vec::new(),
            reach: 0.0,
            box_edges: BoxEdges::default(),
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
        if is_box {
            let mut edges = std::mem::take(&mut self.box_edges);
            edges.read(mesh);
            edges.numbers.clear();
            for ends in &edges.ends {
                let number = self.edge(ends.each(|point| self.leaf_points[first_point + point as usize]));
                edges.numbers.push(number);
            }
            self.leaf_edges.extend(edges.of_corner.iter().map(|edge| edges.numbers[*edge as usize]));
            self.box_edges = edges;
        } else {
            let corners = mesh.corners();
            for edge in mesh.faces().flat_map(|face| face.edges()) {
                let ends = edge.each(|corner| self.leaf_points[first_point + corners[corner] as usize]);
                let number = self.edge(ends);
                self.leaf_edges.push(number);
            }
        }
        LeafPart { points: [first_point, self.leaf_points.len()], edges: [first_edge, self.leaf_edges.len()] }
    }

    fn number(&mut self, place: DVec3) -> u32 {
        let from_origin = place - self.origin;
        // −0 and 0 are one place.
        let number = self.places.number(from_origin.as_vec3().to_array().each(|c| (c + 0.0).to_bits()));
        if number as usize == self.points.len() {
            self.points.push(place);
            let reach = from_origin.abs().max_element();
            if reach.is_finite() {
                self.reach = self.reach.max(reach);
            }
        }
        number
    }

    /// The number of the edge between two points.
    fn edge(&mut self, ends: [u32; 2]) -> u32 {
        if ends[0] == ends[1] {
            return NO_EDGE;
        }
        self.edges.number([ends[0].min(ends[1]), ends[0].max(ends[1])])
    }

    /// The distance in metres within which a point is in an edge.
    pub(super) fn near(&self) -> f64 {
        (IN_EDGE * self.reach).min(FAR)
    }

    /// Finds the points inside of each edge. Returns false if the work is to end; no edge has points then.
    pub(super) fn find_points(&mut self) -> bool {
        let search = Search { points: &self.points, edges: self.edges.keys(), origin: self.origin, near: self.near() };
        match search.points_in_edges() {
            Some((ranges, inside)) => {
                (self.ranges, self.inside) = (ranges, inside);
                true
            }
            None => false,
        }
    }

    /// The number of points inside of the edges of a leaf. Edges of two faces count twice.
    pub(super) fn count_inside(&self, part: LeafPart) -> usize {
        if self.inside.is_empty() {
            return 0;
        }
        self.leaf_edges[part.edges[0]..part.edges[1]].iter().map(|edge| self.range(*edge).len()).sum()
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
