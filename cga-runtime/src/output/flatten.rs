//! Meshes as triangles in the world, shared by all sinks that write triangles.
//!
//! Faces do not share vertices, so a face's vertices are its corners: the corners of the outline, then the corners of its holes.

use std::collections::HashMap;
use std::ops::Range;
use std::sync::{Arc, Weak};

use glam::{DAffine3, DMat3, DVec2, DVec3};

use super::sink_table::SinkTable;
use crate::fixed_hash::FixedState;
use crate::geometry::mesh::map::normal_map;
use crate::geometry::mesh::{FaceTag, Mesh};
use crate::geometry::triangulate::Triangulator;

/// Cuts faces into triangles. It keeps its buffers from mesh to mesh, and the triangles of meshes that come again.
#[derive(Debug, Default)]
pub(crate) struct Flattener {
    triangulator: Triangulator,
    own: FlatMesh,
    /// The meshes that came last and are not flat, at an index that follows from the address.
    seen: Vec<Weak<Mesh>>,
    /// The flat meshes by address. Each is the mesh itself, so the address stays its own.
    flat: HashMap<usize, (Arc<Mesh>, Arc<FlatMesh>), FixedState>,
    /// The number of corners and triangles in them.
    kept: usize,
}

/// The number of corners up to which a mesh is cut into triangles as fast as it is found.
const FEW: usize = 4;

/// The number of meshes that are remembered.
const SEEN: usize = 64;

/// The number of corners and triangles of flat meshes that are kept: about 10 MB. Beyond it they are made again.
const KEPT: usize = 1 << 19;

/// The triangles of all faces of a mesh.
#[derive(Debug, Default)]
pub(crate) struct FlatMesh {
    /// Indices relative to the first corner of the face.
    triangles: Vec<[u32; 3]>,
    /// The number of triangles up to the end of each face, and its area vector.
    faces: Vec<(u32, DVec3)>,
    /// For a mesh with normals that comes again: the points with their normals, each once, and the number of each corner.
    corners: Option<(Vec<[DVec3; 2]>, Vec<u32>)>,
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
    pub(crate) fn faces(&mut self, mesh: &Arc<Mesh>, placement: &DAffine3, each: impl FnMut(PlacedFace<'_>) -> bool) {
        self.whole(mesh, |flat| flat.place(mesh, placement, each));
    }

    /// Passes the triangles of a mesh to `then`.
    pub(crate) fn whole(&mut self, mesh: &Arc<Mesh>, then: impl FnOnce(&FlatMesh)) {
        match self.known(mesh) {
            Some(flat) => then(&flat),
            None => {
                self.own.fill(mesh, &mut self.triangulator);
                then(&self.own);
            }
        }
    }

    /// The triangles of a mesh that comes again. At its second sight they are kept: most meshes come once.
    fn known(&mut self, mesh: &Arc<Mesh>) -> Option<Arc<FlatMesh>> {
        // A mesh that is remembered keeps its memory, so the faces of a component split could not share it.
        if mesh.corners().len() <= FEW {
            return None;
        }
        let address = Arc::as_ptr(mesh).addr();
        if let Some((_, flat)) = self.flat.get(&address) {
            return Some(flat.clone());
        }
        self.seen.resize_with(SEEN, Weak::new);
        let seen = &mut self.seen[(address / size_of::<Mesh>()) % SEEN];
        if seen.as_ptr().addr() != address {
            *seen = Arc::downgrade(mesh);
            return None;
        }
        let mut flat = FlatMesh::default();
        flat.fill(mesh, &mut self.triangulator);
        flat.corners = distinct_corners(mesh);
        let size = mesh.corners().len() + flat.triangles.len();
        if KEPT < self.kept + size {
            self.flat.clear();
            self.kept = 0;
        }
        let flat = Arc::new(flat);
        if size <= KEPT {
            self.kept += size;
            self.flat.insert(address, (mesh.clone(), flat.clone()));
        }
        Some(flat)
    }
}

impl FlatMesh {
    fn fill(&mut self, mesh: &Mesh, triangulator: &mut Triangulator) {
        self.triangles.clear();
        self.faces.clear();
        for face in mesh.faces() {
            let before = self.triangles.len();
            triangulator.face(mesh, face.index(), &mut self.triangles);
            let start = face.corner_range().start as u32;
            self.triangles[before..].as_flattened_mut().iter_mut().for_each(|corner| *corner -= start);
            self.faces.push((self.triangles.len() as u32, face.area_vector()));
        }
    }

    /// The number of triangles.
    pub(crate) fn triangle_count(&self) -> usize {
        self.triangles.len()
    }

    /// Makes the vertices of all corners, with a function of the point and its unit normal in the world.
    pub(crate) fn vertices<V: Copy>(
        &self,
        mesh: &Mesh,
        placement: &DAffine3,
        to: &mut [V],
        make: impl Fn(DVec3, DVec3) -> V,
    ) {
        let Some((distinct, corners)) = &self.corners else {
            return self.place(mesh, placement, |face| {
                for (to, corner) in to[face.corners.clone()].iter_mut().zip(face.corners.clone()) {
                    *to = make(face.point(corner), face.normal_at(corner));
                }
                true
            });
        };
        let turn = normal_map(&placement.matrix3);
        let placed =
            distinct.iter().map(|[point, normal]| make(placement.transform_point3(*point), unit(turn * *normal)));
        let placed: Vec<V> = placed.collect();
        to.iter_mut().zip(corners).for_each(|(to, corner)| *to = placed[*corner as usize]);
    }

    /// Makes the indices of all triangles, if the first corner has the number `start`.
    pub(crate) fn indices(&self, mesh: &Mesh, start: u32, to: &mut [u32]) {
        let (own, _) = to.as_chunks_mut::<3>();
        let mut first = 0;
        for (face, (end, _)) in mesh.faces().zip(&self.faces) {
            let (base, range) = (start + face.corner_range().start as u32, first..*end as usize);
            first = range.end;
            own[range.clone()]
                .iter_mut()
                .zip(&self.triangles[range])
                .for_each(|(to, from)| *to = from.map(|c| base + c));
        }
    }

    /// Passes the faces of the mesh to `each` in order, until it returns false.
    #[inline]
    pub(crate) fn place(&self, mesh: &Mesh, placement: &DAffine3, mut each: impl FnMut(PlacedFace<'_>) -> bool) {
        let (turn, mut first) = (normal_map(&placement.matrix3), 0);
        for (face, (end, area)) in mesh.faces().zip(&self.faces) {
            let (index, corners) = (face.index(), face.corner_range());
            let triangles = &self.triangles[first as usize..*end as usize];
            first = *end;
            let normal = unit(turn * *area);
            if !each(PlacedFace { mesh, placement, turn, index, corners, triangles, normal }) {
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

/// The points with their normals, each once, and the number of each corner; `None` for a mesh without normals.
fn distinct_corners(mesh: &Mesh) -> Option<(Vec<[DVec3; 2]>, Vec<u32>)> {
    if mesh.normals().is_empty() {
        return None;
    }
    let mut distinct = Vec::new();
    // Only for look-ups, never iterated.
    let mut known: HashMap<(u32, [u64; 3]), u32, FixedState> = HashMap::default();
    let number = |(point, normal): (&u32, &DVec3)| {
        *known.entry((*point, normal.to_array().map(f64::to_bits))).or_insert_with(|| {
            distinct.push([mesh.points()[*point as usize], *normal]);
            distinct.len() as u32 - 1
        })
    };
    let corners = mesh.corners().iter().zip(mesh.normals()).map(number).collect();
    Some((distinct, corners))
}

/// Returns true if all faces have the material of the shape.
pub(crate) fn has_one_material(mesh: &Mesh) -> bool {
    mesh.face_attributes().all(|tag| tag.material == FaceTag::NONE)
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
