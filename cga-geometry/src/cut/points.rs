//! The points of a cut: the points of the mesh, and the crossings of its edges with planes.
//!
//! An edge owns its crossings: the first face that needs them makes them, and the other faces find them. Points on a
//! plane are stored and numbered per plane, because later steps (the pieces on both sides, the caps) work plane by
//! plane.

use glam::{DVec2, DVec3};

use super::class::Class;
use super::edges::Edges;
use super::segment::Segment;
use crate::each::Each;
use crate::mesh::Mesh;

/// The number of a point without a number yet.
pub(super) const NONE: u32 = u32::MAX;

/// The class of a point among the planes, and its number there. It is small, because it is read at random for each
/// corner.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Location {
    pub(super) class: Class,
    /// The number in the slab or on the plane.
    pub(super) number: u32,
}

impl Location {
    /// A point on a plane.
    pub(super) fn on(plane: u32, number: u32) -> Self {
        Location { class: Class::on(plane), number }
    }
}

/// A corner of a piece: a corner of the mesh, or a crossing between two corners.
#[derive(Clone, Copy, Debug)]
pub(super) struct PieceCorner {
    pub(super) place: Location,
    /// The corner, or the corner at the lexicographically first end of the edge.
    pub(super) from: u32,
    /// The same corner, or the corner at the other end.
    pub(super) to: u32,
}

impl PieceCorner {
    /// A corner of the mesh.
    #[inline]
    pub(super) fn corner(corner: usize, place: Location) -> Self {
        PieceCorner { place, from: corner as u32, to: corner as u32 }
    }

    /// Returns true if it is a corner, rather than a crossing.
    pub(super) fn is_corner(&self) -> bool {
        self.from == self.to
    }

    #[inline]
    pub(super) fn class(&self) -> Class {
        self.place.class
    }
}

/// The points on a plane.
#[derive(Default)]
pub(super) struct PlanePoints {
    /// The other two coordinates of each point, in the order in which the plane's axis points to the viewer.
    pub(super) flat: Vec<DVec2>,
    /// The numbers of each point in the slabs below and above, [`NONE`] until assigned.
    pub(super) numbers: Vec<[u32; 2]>,
    /// The relative position of each crossing on its edge, from the lexicographically first end. Kept only if corners
    /// have values to interpolate.
    shares: Vec<f64>,
}

impl PlanePoints {
    fn clear(&mut self) {
        self.flat.clear();
        self.numbers.clear();
        self.shares.clear();
    }
}

/// All points of a cut.
#[derive(Default)]
pub(super) struct CutPoints {
    pub(super) axis: usize,
    /// The planes that meet the mesh.
    pub(super) planes: Vec<f64>,
    /// The place of each point of the mesh.
    pub(super) places: Vec<Location>,
    /// The points on each plane. The list may be longer than the list of planes.
    pub(super) levels: Vec<PlanePoints>,
    /// True if corners have values to interpolate at crossings.
    pub(super) mixes: bool,
    /// For each edge the number of its only crossing on the plane, or the start of its crossings in the list.
    pub(super) edges: Edges,
    /// The numbers on their planes of the crossings of edges with several, from low to high.
    pub(super) crossings: Vec<u32>,
}

impl CutPoints {
    /// Classifies the points of a mesh. They have no numbers yet.
    pub(super) fn start(&mut self, mesh: &Mesh) {
        let CutPoints { axis, planes, places, .. } = self;
        places.clear();
        places.extend(mesh.points.iter().map(|p| Location { class: Class::among(planes, p[*axis]), number: 0 }));
        // Drops the lists left by cuts with many more planes.
        let keep = self.levels.len().min(4 * self.planes.len() + 64).max(self.planes.len());
        self.levels.resize_with(keep, PlanePoints::default);
        self.levels[..self.planes.len()].iter_mut().for_each(PlanePoints::clear);
        self.edges.reset(mesh.points.len());
        self.crossings.clear();
        self.mixes = !mesh.uvs.is_empty() || !mesh.normals.is_empty();
    }

    /// Adds a point to a plane, with its numbers in the slabs. Returns its number on the plane.
    #[inline]
    pub(super) fn add(&mut self, plane: u32, point: DVec3, share: f64, numbers: [u32; 2]) -> u32 {
        let flat = match self.axis {
            0 => DVec2::new(point.y, point.z),
            1 => DVec2::new(point.z, point.x),
            _ => DVec2::new(point.x, point.y),
        };
        let level = &mut self.levels[plane as usize];
        level.flat.push(flat);
        level.numbers.push(numbers);
        if self.mixes {
            level.shares.push(share);
        }
        (level.flat.len() - 1) as u32
    }

    /// The position of a point on a plane.
    #[inline]
    pub(super) fn lift(&self, plane: u32, number: u32) -> DVec3 {
        let at = self.planes[plane as usize];
        let flat = self.levels[plane as usize].flat[number as usize];
        match self.axis {
            0 => DVec3::new(at, flat.x, flat.y),
            1 => DVec3::new(flat.y, at, flat.x),
            _ => DVec3::new(flat.x, flat.y, at),
        }
    }

    /// The position of a corner of a piece.
    #[inline]
    pub(super) fn position(&self, mesh: &Mesh, node: &PieceCorner) -> DVec3 {
        if node.is_corner() {
            return mesh.points[mesh.corners[node.from as usize] as usize];
        }
        self.lift(node.class().plane(), node.place.number)
    }

    /// For a mesh that was cut by one plane at the points `cut`: the points on the plane, computed between the points
    /// `own`.
    pub(super) fn on_plane_of(&self, own: &[DVec3], cut: &[DVec3]) -> Vec<DVec3> {
        let mut list = vec![DVec3::ZERO; self.levels[0].flat.len()];
        for (place, point) in self.places.iter().zip(own).filter(|(place, _)| place.class == Class::on(0)) {
            list[place.number as usize] = *point;
        }
        for (ends, number) in self.edges.all() {
            let [a, b] = ends.each(|end| (own[end as usize], cut[end as usize][self.axis]));
            list[number as usize] = Segment::between(a, b).meet(self.planes[0]).0;
        }
        list
    }

    /// The relative position of a crossing on its edge.
    pub(super) fn share(&self, place: Location) -> f64 {
        self.levels[place.class.plane() as usize].shares[place.number as usize]
    }
}
