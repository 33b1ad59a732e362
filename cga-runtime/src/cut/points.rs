//! The points of a cut: those of the mesh, and the crossings where its edges meet planes.
//!
//! An edge owns its crossings: they are made when the first face asks and found by the others. Crossings are numbered
//! after the points of the mesh; those of one edge follow each other, from low to high.

use std::ops::Range;

use glam::DVec3;

use crate::mesh::Mesh;
use crate::mesh::table::PairTable;

/// Not numbered yet.
pub(super) const NONE: u32 = u32::MAX;

/// Where a point is among the planes. Read at random for each corner, so it is kept small.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place {
    /// 2s strictly inside slab s, 2j + 1 on plane j.
    pub(super) class: u32,
    /// Its number in the slab; of a point on a plane, its number among those.
    pub(super) number: u32,
}

/// A corner of a piece: a point of the mesh at one of its corners, or a crossing between two.
#[derive(Clone, Copy, Debug)]
pub(super) struct Node {
    pub(super) point: u32,
    pub(super) place: Place,
    /// The corner, or that at the lexicographically first end of the edge.
    pub(super) from: u32,
    /// The same corner, or that at the other end.
    pub(super) to: u32,
}

impl Node {
    /// A corner of the mesh.
    #[inline]
    pub(super) fn corner(corner: usize, point: u32, place: Place) -> Self {
        Node { point, place, from: corner as u32, to: corner as u32 }
    }

    /// Whether it is a corner, not a crossing.
    pub(super) fn is_corner(&self) -> bool {
        self.from == self.to
    }

    #[inline]
    pub(super) fn class(&self) -> u32 {
        self.place.class
    }
}

/// All points of a cut.
#[derive(Default)]
pub(super) struct Points {
    pub(super) axis: usize,
    /// The planes that reach the mesh.
    pub(super) planes: Vec<f64>,
    /// Where each point of the mesh is.
    pub(super) places: Vec<Place>,
    /// For each point on a plane, its numbers in the slabs below and above: points of the mesh, then crossings.
    pub(super) numbers: Vec<[u32; 2]>,
    /// How many of those are of the mesh.
    on_planes: u32,
    /// Whether corners carry something that is mixed at crossings.
    mixes: bool,
    /// Edge to its first crossing.
    edges: PairTable,
    crossings: Vec<DVec3>,
    /// How far along its edge each is, from the lexicographically first end. Only kept when that is asked for.
    shares: Vec<f64>,
}

impl Points {
    /// Classifies the points of a mesh; they are not numbered yet.
    pub(super) fn start(&mut self, mesh: &Mesh) {
        let Points { axis, planes, places, .. } = self;
        let axis = *axis;
        places.clear();
        if let [plane] = planes[..] {
            let class = |x: f64| 2 * u32::from(plane < x) + u32::from(plane == x);
            places.extend(mesh.points.iter().map(|p| Place { class: class(p[axis]), number: 0 }));
        } else {
            let class = |x: f64| -> u32 {
                let below = planes.partition_point(|&o| o < x) as u32;
                2 * below + u32::from(planes.get(below as usize) == Some(&x))
            };
            places.extend(mesh.points.iter().map(|p| Place { class: class(p[axis]), number: 0 }));
        }
        self.numbers.clear();
        self.edges.clear();
        self.crossings.clear();
        self.shares.clear();
        self.mixes = !mesh.uvs.is_empty() || !mesh.normals.is_empty();
    }

    /// To be called once all points of the mesh have their numbers.
    pub(super) fn numbered(&mut self) {
        self.on_planes = self.numbers.len() as u32;
    }

    /// How many points there are, crossings included.
    pub(super) fn len(&self) -> usize {
        self.places.len() + self.crossings.len()
    }

    /// Where a point is.
    #[inline]
    pub(super) fn position(&self, mesh: &Mesh, point: u32) -> DVec3 {
        match (point as usize).checked_sub(mesh.points.len()) {
            None => mesh.points[point as usize],
            Some(crossing) => self.crossings[crossing],
        }
    }

    /// How far along its edge a crossing is.
    pub(super) fn share(&self, point: u32) -> f64 {
        self.shares[point as usize - self.places.len()]
    }

    /// The place of a point that is known to be on a plane.
    #[inline]
    pub(super) fn place_on(&self, point: u32, plane: u32) -> Place {
        match (point as usize).checked_sub(self.places.len()) {
            None => self.places[point as usize],
            Some(crossing) => Place { class: 2 * plane + 1, number: self.on_planes + crossing as u32 },
        }
    }

    /// Appends the crossings of the edge from one corner to another, in the order they are met.
    #[inline]
    pub(super) fn cross(&mut self, mesh: &Mesh, from: (usize, Place), to: (usize, Place), nodes: &mut Vec<Node>) {
        let rises = from.1.class < to.1.class;
        let (low, high) = if rises { (from.1.class, to.1.class) } else { (to.1.class, from.1.class) };
        let planes = low.div_ceil(2)..high / 2;
        if planes.is_empty() {
            return;
        }
        let [a, b] = [from.0, to.0].map(|corner| mesh.corners[corner]);
        let next = self.len() as u32;
        let (base, new) = self.edges.entry(a.min(b), a.max(b), next);
        let base = *base;
        if new {
            self.make(mesh, a, b, planes.clone());
        }
        // What corners carry is mixed from the same end as the position.
        let ordered = !self.mixes || comes_first(mesh.points[a as usize], mesh.points[b as usize]);
        let (first, second) = if ordered { (from.0, to.0) } else { (to.0, from.0) };
        let number = self.on_planes + (base - self.places.len() as u32);
        let mut add = |plane: u32| {
            let along = plane - planes.start;
            let place = Place { class: 2 * plane + 1, number: number + along };
            nodes.push(Node { point: base + along, place, from: first as u32, to: second as u32 });
        };
        if rises {
            for plane in planes.start..planes.end {
                add(plane);
            }
        } else {
            for plane in (planes.start..planes.end).rev() {
                add(plane);
            }
        }
    }

    fn make(&mut self, mesh: &Mesh, a: u32, b: u32, planes: Range<u32>) {
        let axis = self.axis;
        let (p, q) = (mesh.points[a as usize], mesh.points[b as usize]);
        let (p, q) = if comes_first(p, q) { (p, q) } else { (q, p) };
        let along = q - p;
        let (low, high) = (p.min(q), p.max(q));
        for plane in planes {
            let at = self.planes[plane as usize];
            let mut share = (at - p[axis]) / along[axis];
            let mut x = p + along * share;
            if !x.is_finite() {
                // The ends are so far apart that their difference overflows.
                share = (at * 0.5 - p[axis] * 0.5) / (q[axis] * 0.5 - p[axis] * 0.5);
                x = p * (1.0 - share) + q * share;
            }
            // Rounding does not lead out of the box of the edge.
            x = x.max(low).min(high);
            x[axis] = at;
            self.crossings.push(x);
            self.numbers.push([NONE; 2]);
            if self.mixes {
                self.shares.push(share);
            }
        }
    }
}

/// Lexicographic order of coordinates: it survives every renumbering.
fn comes_first(a: DVec3, b: DVec3) -> bool {
    a.x < b.x || (a.x == b.x && (a.y < b.y || (a.y == b.y && a.z < b.z)))
}
