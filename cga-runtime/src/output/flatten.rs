//! Meshes as triangles in the world, shared by all sinks that write triangles.
//!
//! Faces do not share vertices, so a face's vertices are its corners: the corners of the outline, then the corners of its holes.

use std::ops::Range;

use glam::{DAffine3, DMat3, DVec2, DVec3};

use super::sink_table::SinkTable;
use crate::geometry::mesh::Mesh;
use crate::geometry::mesh::map::normal_map;
use crate::geometry::triangulate::Triangulator;

/// Cuts faces into triangles. It keeps its buffers from mesh to mesh.
#[derive(Debug, Default)]
pub(crate) struct Flattener {
    triangulator: Triangulator,
    triangles: Vec<[u32; 3]>,
}

/// A face, placed in the world.
pub(crate) struct PlacedFace<'a> {
    pub(crate) mesh: &'a Mesh,
    placement: &'a DAffine3,
    /// The map of normals to the world.
    turn: DMat3,
    /// The index of the face in the mesh.
    pub(crate) index: usize,
    /// The range of its corners in the mesh.
    pub(crate) corners: Range<usize>,
    /// The triangles, as indices relative to the start of `corners`.
    pub(crate) triangles: &'a [[u32; 3]],
    /// The unit normal in the world, towards the side from which the outline is counter-clockwise.
    pub(crate) normal: DVec3,
}

/// Lists that are kept from mesh to mesh are not copied.
impl Clone for Flattener {
    fn clone(&self) -> Self {
        Flattener::default()
    }
}

impl Flattener {
    /// Passes the faces of a mesh to `each` in order, until it returns false.
    pub(crate) fn faces(&mut self, mesh: &Mesh, placement: &DAffine3, mut each: impl FnMut(PlacedFace<'_>) -> bool) {
        let turn = normal_map(&placement.matrix3);
        for face in mesh.faces() {
            let (index, corners) = (face.index(), face.corner_range());
            self.triangles.clear();
            self.triangulator.face(mesh, index, &mut self.triangles);
            for corner in self.triangles.as_flattened_mut() {
                *corner -= corners.start as u32;
            }
            let normal = unit(turn * face.area_vector());
            if !each(PlacedFace { mesh, placement, turn, index, corners, triangles: &self.triangles, normal }) {
                return;
            }
        }
    }
}

impl PlacedFace<'_> {
    /// The point of a corner, in the world.
    #[inline]
    pub(crate) fn point(&self, corner: usize) -> DVec3 {
        self.placement.transform_point3(corner_point(self.mesh, corner))
    }

    /// The unit normal at a corner, in the world: the normal of the mesh if it has normals.
    #[inline]
    pub(crate) fn normal_at(&self, corner: usize) -> DVec3 {
        self.mesh.normals().get(corner).map_or(self.normal, |&normal| unit(self.turn * normal))
    }

    /// The texture coordinates of all corners in a set.
    pub(crate) fn uvs(&self, set: usize) -> &[DVec2] {
        &self.mesh.uv_set(set)[self.corners.clone()]
    }

    /// The number of the visible material on a shape with the material `shape`.
    #[inline]
    pub(crate) fn material(&self, table: &mut SinkTable, shape: u32) -> u32 {
        table.face_material(shape, self.mesh.material_list(), self.mesh.face(self.index).tag().material)
    }
}

/// The point of a corner.
#[inline]
pub(crate) fn corner_point(mesh: &Mesh, corner: usize) -> DVec3 {
    mesh.points()[mesh.corners()[corner] as usize]
}

/// A vector of length one; upwards if the vector is zero.
#[inline]
pub(crate) fn unit(v: DVec3) -> DVec3 {
    v.normalize_or(DVec3::Y)
}
