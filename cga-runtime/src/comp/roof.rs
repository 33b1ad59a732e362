//! The edges of roofs: eaves, hips, valleys and ridges.
//!
//! A roof is what looks up. Of its edges, level ones that only one of its faces has are eaves, and those that two have are
//! valleys where the faces slope towards each other, hips where they touch an eave, else ridges. What looks down or
//! sideways below or beside the roof does not count, so it is the same for a roof that is a closed volume.

use std::sync::Arc;

use glam::DVec3;

use super::select::RoofEdge;
use crate::geometry::mesh::{Mesh, unit};
use crate::geometry::tol::UP_EPSILON;

/// A mesh seen as a roof.
#[derive(Debug)]
pub(super) struct Roof {
    mesh: Arc<Mesh>,
    /// Of the faces, outwards.
    normals: Vec<DVec3>,
    /// Which way an edge runs as seen from outside: with its face, or against it where that looks inwards.
    sense: f64,
    /// Whether an eave ends at each point.
    eaves: Vec<bool>,
}

impl Roof {
    /// With the normals of the faces, and whether these look inwards.
    pub(super) fn new(mesh: &Arc<Mesh>, normals: &[DVec3], inwards: bool) -> Self {
        let sense = if inwards { -1.0 } else { 1.0 };
        let normals = normals.iter().map(|normal| normal * sense).collect();
        let mut roof = Roof { mesh: mesh.clone(), normals, sense, eaves: vec![false; mesh.points().len()] };
        for edge in 0..mesh.adjacency().edge_count() {
            if matches!(roof.faces(edge), (Some(_), None)) && roof.is_level(edge) {
                roof.ends(edge).into_iter().for_each(|point| roof.eaves[point] = true);
            }
        }
        roof
    }

    /// What an edge is.
    pub(super) fn edge(&self, edge: usize) -> Option<RoofEdge> {
        match self.faces(edge) {
            (Some(_), None) => self.is_level(edge).then_some(RoofEdge::Eave),
            (Some(one), Some(other)) => Some(match () {
                () if self.is_concave(edge, one, other) => RoofEdge::Valley,
                () if self.ends(edge).into_iter().any(|point| self.eaves[point]) => RoofEdge::Hip,
                () => RoofEdge::Ridge,
            }),
            _ => None,
        }
    }

    /// The first two faces at an edge that look up.
    fn faces(&self, edge: usize) -> (Option<u32>, Option<u32>) {
        let mut faces = self.mesh.adjacency().faces_at(edge).filter(|&face| UP_EPSILON < self.normals[face as usize].y);
        (faces.next(), faces.next())
    }

    /// Where the first face at an edge that looks up begins with it.
    pub(super) fn corner(&self, edge: usize) -> Option<u32> {
        let adjacency = self.mesh.adjacency();
        let face = self.faces(edge).0?;
        adjacency.uses(edge).iter().copied().find(|&corner| adjacency.face(corner) == face)
    }

    fn ends(&self, edge: usize) -> [usize; 2] {
        let adjacency = self.mesh.adjacency();
        let corner = adjacency.uses(edge)[0];
        [corner, adjacency.next(corner)].map(|corner| self.mesh.corners()[corner as usize] as usize)
    }

    fn is_level(&self, edge: usize) -> bool {
        let [a, b] = self.mesh.edge_ends(edge);
        a != b && unit(b - a).y.abs() <= UP_EPSILON
    }

    /// Whether two faces slope towards each other: the inside of one is in front of the other.
    fn is_concave(&self, edge: usize, one: u32, other: u32) -> bool {
        let adjacency = self.mesh.adjacency();
        let Some(corner) = self.corner(edge) else { return false };
        let at = |corner: u32| self.mesh.points()[self.mesh.corners()[corner as usize] as usize];
        let along = unit(at(adjacency.next(corner)) - at(corner)) * self.sense;
        let inwards = self.normals[one as usize].cross(along);
        UP_EPSILON < inwards.dot(self.normals[other as usize])
    }
}
