//! The edges of roofs: eaves, hips, valleys and ridges.
//!
//! A roof consists of the faces that look up. A level edge of one such face is an eave if the
//! face does not fall away from it. So a shed has one eave, as the text of *comp* says ("on the bottom of the roof"); the
//! picture of the page colours its upper edge, too. An edge of two such faces is a valley if they slope towards each
//! other, a hip if it touches an eave, otherwise a ridge. An edge between two coplanar faces, as at a collinear corner,
//! has no class. Faces that look down or sideways do not count, so the result is the same for a roof that is a closed
//! volume.

use std::sync::Arc;

use glam::DVec3;

use super::select::RoofEdge;
use crate::geometry::each::Each;
use crate::geometry::mesh::{Mesh, unit};
use crate::geometry::tol::UP_EPSILON;

/// A mesh as a roof.
#[derive(Debug)]
pub(super) struct RoofMesh {
    mesh: Arc<Mesh>,
    /// The outward normals of the faces.
    normals: Vec<DVec3>,
    /// 1 if an edge seen from outside runs with its face; -1 if faces look inwards.
    sense: f64,
    /// True for each point at the end of an eave.
    eaves: Vec<bool>,
}

impl RoofMesh {
    /// A roof with the normals of the faces, and true if these look inwards.
    pub(super) fn new(mesh: &Arc<Mesh>, normals: &[DVec3], inwards: bool) -> Self {
        let sense = if inwards { -1.0 } else { 1.0 };
        let normals = normals.iter().map(|normal| normal * sense).collect();
        let mut roof = RoofMesh { mesh: mesh.clone(), normals, sense, eaves: vec![false; mesh.points().len()] };
        for edge in 0..mesh.adjacency().edge_count() {
            if matches!(roof.faces(edge), (Some(face), None) if roof.is_eave(edge, face)) {
                roof.ends(edge).into_iter().for_each(|point| roof.eaves[point] = true);
            }
        }
        roof
    }

    /// The class of an edge.
    pub(super) fn edge(&self, edge: usize) -> Option<RoofEdge> {
        match self.faces(edge) {
            (Some(face), None) => self.is_eave(edge, face).then_some(RoofEdge::Eave),
            (Some(one), Some(other)) => match self.rise(edge, one, other) {
                rise if UP_EPSILON < rise => Some(RoofEdge::Valley),
                rise if -UP_EPSILON <= rise && self.look_alike(one, other) => None,
                _ if self.ends(edge).into_iter().any(|point| self.eaves[point]) => Some(RoofEdge::Hip),
                _ => Some(RoofEdge::Ridge),
            },
            _ => None,
        }
    }

    /// The first two faces at an edge that look up.
    fn faces(&self, edge: usize) -> (Option<u32>, Option<u32>) {
        let mut faces = self.mesh.adjacency().faces_at(edge).filter(|&face| UP_EPSILON < self.normals[face as usize].y);
        (faces.next(), faces.next())
    }

    /// The corner at which the first upward face at an edge begins with it.
    pub(super) fn corner(&self, edge: usize) -> Option<u32> {
        let adjacency = self.mesh.adjacency();
        let face = self.faces(edge).0?;
        adjacency.uses(edge).iter().copied().find(|&corner| adjacency.face(corner) == face)
    }

    fn ends(&self, edge: usize) -> [usize; 2] {
        let adjacency = self.mesh.adjacency();
        let corner = adjacency.uses(edge)[0];
        [corner, adjacency.next(corner)].each(|corner| self.mesh.corners()[corner as usize] as usize)
    }

    /// Returns true if an edge is a low border of its only face that looks up.
    fn is_eave(&self, edge: usize, face: u32) -> bool {
        let [a, b] = self.mesh.edge_ends(edge);
        a != b && unit(b - a).y.abs() <= UP_EPSILON && -UP_EPSILON <= self.inwards(edge, face).y
    }

    /// Returns true if two faces look in about the same direction.
    fn look_alike(&self, one: u32, other: u32) -> bool {
        0.0 < self.normals[one as usize].dot(self.normals[other as usize])
    }

    /// The rise of one face over another one: the sine of the angle between them, positive if they slope towards each other.
    fn rise(&self, edge: usize, one: u32, other: u32) -> f64 {
        self.inwards(edge, one).dot(self.normals[other as usize])
    }

    /// The direction in the first face at an edge that looks up, across the edge.
    fn inwards(&self, edge: usize, face: u32) -> DVec3 {
        let adjacency = self.mesh.adjacency();
        let Some(corner) = self.corner(edge) else { return DVec3::ZERO };
        let at = |corner: u32| self.mesh.points()[self.mesh.corners()[corner as usize] as usize];
        let along = unit(at(adjacency.next(corner)) - at(corner)) * self.sense;
        self.normals[face as usize].cross(along)
    }
}
