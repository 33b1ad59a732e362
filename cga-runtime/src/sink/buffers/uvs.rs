//! Texture coordinates of vertices, set by set.

use glam::DVec3;

use crate::mesh::Mesh;
use crate::sink::{Cuboid, Quad};
use crate::texture::map::{SetMap, UvMap};

/// Sets of coordinates: one pair a vertex in each that some geometry has, and nothing in the others.
#[derive(Debug, Default)]
pub(super) struct UvLists(Vec<Vec<[f32; 2]>>);

impl UvLists {
    /// The most sets there are.
    pub(super) const MOST: usize = 10;

    /// Returns true as long as nothing had any.
    #[inline]
    pub(super) fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    pub(super) fn get(&self, set: usize) -> &[[f32; 2]] {
        self.0.get(set).map_or(&[], Vec::as_slice)
    }

    pub(super) fn clear(&mut self) {
        self.0.clear();
    }

    /// The bytes that are reserved.
    pub(super) fn memory(&self) -> usize {
        self.0.iter().map(|list| size_of::<[f32; 2]>() * list.capacity()).sum()
    }

    /// The list of a set, with (0, 0) for vertices before `vertex` that have none.
    fn list(&mut self, set: usize, vertex: usize) -> Option<&mut Vec<[f32; 2]>> {
        if UvLists::MOST <= set {
            return None;
        }
        if self.0.len() <= set {
            self.0.resize_with(set + 1, Vec::new);
        }
        let list = &mut self.0[set];
        list.resize(vertex, [0.0; 2]);
        Some(list)
    }

    /// Gives all lists as many pairs as there are vertices.
    #[inline]
    pub(super) fn pad(&mut self, vertices: usize) {
        for list in &mut self.0 {
            if !list.is_empty() {
                list.resize(vertices, [0.0; 2]);
            }
        }
    }

    /// Adds the corner of a mesh that became a vertex.
    #[inline]
    pub(super) fn corner(&mut self, mesh: &Mesh, corner: usize, vertex: usize) {
        for set in mesh.uv_numbers() {
            if let Some((list, uv)) = self.list(set, vertex).zip(mesh.uv_set(set).get(corner)) {
                list.push([uv.x as f32, uv.y as f32]);
            }
        }
    }

    /// Adds the corners of a rectangle whose vertices begin at one.
    pub(super) fn quad(&mut self, maps: &[SetMap], quad: &Quad, vertex: usize) {
        let corners = quad.corners();
        for SetMap { set, map } in maps {
            if let Some(list) = self.list(*set, vertex) {
                list.extend_from_slice(&corners.map(|corner| short(map, corner)));
            }
        }
    }

    /// Adds the corners of all faces of a box. Each is computed once, so the three faces that meet there agree.
    pub(super) fn cuboid(&mut self, maps: &[SetMap], cuboid: &Cuboid, vertex: usize) {
        let corners = cuboid.corners();
        for SetMap { set, map } in maps {
            if let Some(list) = self.list(*set, vertex) {
                let uvs = corners.map(|corner| short(map, corner));
                let faces = cuboid.unit.sides().map(|face| face.corners.map(|at| uvs[usize::from(at & 7)]));
                list.extend_from_slice(faces.as_flattened());
            }
        }
    }
}

#[inline]
fn short(map: &UvMap, point: DVec3) -> [f32; 2] {
    let uv = map.at(point);
    [uv.x as f32, uv.y as f32]
}
