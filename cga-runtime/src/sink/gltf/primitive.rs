//! The triangles of one material, growing leaf by leaf.

use glam::{DAffine3, DVec2, DVec3};

use crate::mesh::Mesh;
use crate::sink::flatten::{FlatFace, corner_point, normal_map, unit};
use crate::sink::{Cuboid, Quad};

/// Streams of one glTF primitive. Texture coordinates are there for all vertices or for none.
#[derive(Debug, Default)]
pub(super) struct Primitive {
    pub(super) look: u32,
    pub(super) positions: Vec<[f32; 3]>,
    pub(super) normals: Vec<[f32; 3]>,
    pub(super) uvs: Vec<[f32; 2]>,
    /// The rule of each vertex.
    pub(super) rules: Vec<f32>,
    pub(super) indices: Vec<u32>,
}

/// Bytes that a vertex without texture coordinates takes, and an index.
pub(super) const VERTEX_BYTES: u64 = 28;
pub(super) const INDEX_BYTES: u64 = 4;

fn short(v: DVec3) -> [f32; 3] {
    v.to_array().map(|c| c as f32)
}

/// glTF counts v downwards.
fn flipped(uv: DVec2) -> [f32; 2] {
    [uv.x as f32, (1.0 - uv.y) as f32]
}

impl Primitive {
    pub(super) fn new(look: u32) -> Self {
        Primitive { look, ..Primitive::default() }
    }

    pub(super) fn quad(&mut self, quad: &Quad, rule: u32, origin: DVec3) {
        let start = self.positions.len() as u32;
        let normal = short(unit(quad.u.cross(quad.v)));
        self.positions.extend(quad.corners().map(|corner| short(corner - origin)));
        self.normals.extend([normal; 4]);
        self.rules.extend([rule as f32; 4]);
        self.indices.extend([0, 1, 2, 0, 2, 3].map(|i| start + i));
    }

    pub(super) fn cuboid(&mut self, cuboid: &Cuboid, rule: u32, origin: DVec3) {
        // A box without extent along an axis still has six faces; the opposite ones share their direction then.
        for face in cuboid.faces() {
            self.quad(&face, rule, origin);
        }
    }

    pub(super) fn face(&mut self, mesh: &Mesh, placement: &DAffine3, face: &FlatFace<'_>, rule: u32, origin: DVec3) {
        let start = self.positions.len() as u32;
        let turn = normal_map(&placement.matrix3);
        for corner in face.corners.clone() {
            let point = placement.transform_point3(corner_point(mesh, corner)) - origin;
            let normal = mesh.normals.get(corner).map_or(face.normal, |&n| unit(turn * n));
            self.positions.push(short(point));
            self.normals.push(short(normal));
            self.rules.push(rule as f32);
        }
        if !mesh.uvs().is_empty() {
            self.uvs.extend(mesh.uvs()[face.corners.clone()].iter().map(|&uv| flipped(uv)));
        }
        self.indices.extend(face.triangles.as_flattened().iter().map(|i| start + i));
    }
}
