//! Meshes as triangles in the world: what every sink that writes triangles shares.
//!
//! Vertices are not shared between faces, so a face's vertices are its corners: the outline's, then its holes'.

use std::ops::Range;

use glam::{DAffine3, DVec3};

use crate::geometry::mesh::Mesh;
use crate::geometry::mesh::map::normal_map;
use crate::geometry::triangulate::Triangulator;

/// Cuts faces into triangles, keeping its buffers from mesh to mesh.
#[derive(Debug, Default)]
pub(crate) struct Flattener {
    triangulator: Triangulator,
    triangles: Vec<[u32; 3]>,
}

/// One face, placed in the world.
pub(crate) struct FlatFace<'a> {
    /// Which of the mesh's faces.
    pub(crate) index: usize,
    /// Its corners within the mesh's.
    pub(crate) corners: Range<usize>,
    /// Triangles as indices counted from the start of `corners`.
    pub(crate) triangles: &'a [[u32; 3]],
    /// Unit normal in the world, to the side from which the outline goes counter-clockwise.
    pub(crate) normal: DVec3,
}

impl Flattener {
    /// Hands over the faces of a mesh in order, until `each` returns `false`.
    pub(crate) fn faces(&mut self, mesh: &Mesh, placement: &DAffine3, mut each: impl FnMut(FlatFace<'_>) -> bool) {
        let turn = normal_map(&placement.matrix3);
        for face in mesh.faces() {
            let (index, corners) = (face.index(), face.corner_range());
            self.triangles.clear();
            self.triangulator.face(mesh, index, &mut self.triangles);
            for corner in self.triangles.as_flattened_mut() {
                *corner -= corners.start as u32;
            }
            let normal = unit(turn * face.area_vector());
            if !each(FlatFace { index, corners, triangles: &self.triangles, normal }) {
                return;
            }
        }
    }
}

/// The point of a corner.
#[inline]
pub(crate) fn corner_point(mesh: &Mesh, corner: usize) -> DVec3 {
    mesh.points[mesh.corners[corner] as usize]
}

/// A vector of length one; up, when there is no direction to keep.
#[inline]
pub(crate) fn unit(v: DVec3) -> DVec3 {
    v.normalize_or(DVec3::Y)
}
