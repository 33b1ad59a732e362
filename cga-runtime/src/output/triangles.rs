//! Vertices and indices of triangles, written in place.

use glam::{DAffine3, DVec3, DVec4, Vec4};

use super::flatten::{FlatMesh, PlacedFace};
use super::room::Room;
use crate::geometry::each::Each;
use crate::geometry::mesh::Mesh;
use crate::run::sink::corners::PlacedBox;
use crate::shape::unit::UnitMesh;

/// Position x, y, z and normal x, y, z.
pub type Vertex = [f32; 6];

/// Triangles of faces that share no vertices.
#[derive(Clone, Debug, Default)]
pub(super) struct Triangles {
    pub(super) vertices: Room<Vertex>,
    pub(super) indices: Room<u32>,
}

impl Triangles {
    /// Adds a rectangle.
    #[inline(always)]
    pub(super) fn quad(&mut self, placed: PlacedBox, normal: Vec4) {
        let start = self.vertices.len() as u32;
        if let Some(to) = self.vertices.take(4).first_chunk_mut::<4>() {
            write_quad(to, &PlacedBox { origin: marked(placed.origin, normal), ..placed }, normal);
        }
        if let Some(to) = self.indices.take(6).first_chunk_mut::<6>() {
            *to = [start, start + 1, start + 2, start, start + 2, start + 3];
        }
    }

    /// Adds a box; `normals` are the normals of its sides.
    #[inline(always)]
    pub(super) fn cuboid(&mut self, placed: &PlacedBox, unit: UnitMesh, normals: &[Vec4; 6]) {
        if let Some(to) = self.quads(6).first_chunk_mut::<6>() {
            write_box(to, placed, unit, normals);
        }
    }

    /// Adds quads. Returns their vertices, which the caller fills.
    #[inline(always)]
    pub(super) fn quads(&mut self, count: usize) -> &mut [[Vertex; 4]] {
        let start = self.vertices.len() as u32;
        write_quad_indices(self.indices.take(6 * count), start);
        self.vertices.take(4 * count).as_chunks_mut::<4>().0
    }

    /// Adds all faces of a mesh, relative to an origin.
    pub(super) fn mesh(&mut self, flat: &FlatMesh, mesh: &Mesh, placement: &DAffine3, origin: DVec3) {
        let start = self.vertices.len() as u32;
        let vertices = self.vertices.take(mesh.corners().len());
        flat.vertices(mesh, placement, vertices, |point, normal| vertex(point - origin, normal));
        flat.indices(mesh, start, self.indices.take(3 * flat.triangle_count()));
    }

    /// Adds triangles of a face, relative to an origin. `corners` become their vertices.
    pub(super) fn face(
        &mut self,
        face: &PlacedFace<'_>,
        origin: DVec3,
        corners: impl ExactSizeIterator<Item = usize>,
        triangles: &[[u32; 3]],
    ) {
        let start = self.vertices.len() as u32;
        self.vertices.extend(corners.map(|corner| vertex(face.point(corner) - origin, face.normal_at(corner))));
        self.indices.extend(triangles.as_flattened().iter().map(|corner| start + corner));
    }
}

/// Writes the faces of a box; `normals` are the normals of its sides, each after a 0.
#[inline(always)]
pub(super) fn write_box(to: &mut [[Vertex; 4]; 6], placed: &PlacedBox, unit: UnitMesh, normals: &[Vec4; 6]) {
    let corners = placed.box_corners();
    for (face, to) in unit.sides().iter().zip(to) {
        let n = normals[face.side as usize];
        let [a, b, c, d] = face.corners.each(|corner| corners[usize::from(corner & 7)]);
        // Sums combine the numbers: the fourth coordinate of corners is 0, and so is the first of normals.
        let first = Vec4::new(n.x, n.x, n.x, n.y);
        let vectors = [
            a + first,
            Vec4::new(n.z, n.w, b.x, b.y),
            Vec4::new(b.z, b.w, b.w, b.w) + n,
            c + first,
            Vec4::new(n.z, n.w, d.x, d.y),
            Vec4::new(d.z, d.w, d.w, d.w) + n,
        ];
        write(to, vectors);
    }
}

/// An origin with the first number of a normal as its fourth coordinate, so that a corner is the vector to write.
#[inline(always)]
pub(super) fn marked(origin: DVec4, normal: Vec4) -> DVec4 {
    origin.with_w(f64::from(normal.y))
}

/// Writes the vertices of a face.
#[inline(always)]
fn write(to: &mut [Vertex; 4], vectors: [Vec4; 6]) {
    let (chunks, _) = to.as_flattened_mut().as_chunks_mut::<4>();
    for (to, vector) in chunks.iter_mut().zip(vectors) {
        *to = vector.to_array();
    }
}

/// Writes the four vertices of a rectangle as six vectors. The origin is [`marked`] with the normal.
#[inline(always)]
pub(super) fn write_quad(to: &mut [Vertex; 4], placed: &PlacedBox, n: Vec4) {
    let [a, b, c, d] = placed.quad_corners();
    let vectors = [
        a,
        Vec4::new(n.z, n.w, b.x, b.y),
        Vec4::new(b.z, b.w, n.z, n.w),
        c,
        Vec4::new(n.z, n.w, d.x, d.y),
        Vec4::new(d.z, d.w, n.z, n.w),
    ];
    write(to, vectors);
}

/// Writes the indices of consecutive quads.
#[inline(always)]
fn write_quad_indices(to: &mut [u32], start: u32) {
    // Two indices form one number. A sum of two such numbers is never a sum with 0, so the compiler writes two of
    // them at once.
    const PAIR: [u64; 6] = [two(0, 1), two(2, 0), two(2, 3), two(4, 5), two(6, 4), two(6, 7)];
    let split = |two: u64| [two as u32, (two >> 32) as u32];
    let mut first = two(start, start);
    let (pairs, rest) = to.as_chunks_mut::<12>();
    for pair in pairs {
        for (to, corners) in pair.as_chunks_mut::<2>().0.iter_mut().zip(PAIR) {
            *to = split(first.wrapping_add(corners));
        }
        first = first.wrapping_add(two(8, 8));
    }
    for (to, corners) in rest.as_chunks_mut::<2>().0.iter_mut().zip(PAIR) {
        *to = split(first.wrapping_add(corners));
    }
}

/// Two indices in writing order.
const fn two(first: u32, second: u32) -> u64 {
    first as u64 | (second as u64) << 32
}

/// The vertex at a point with a unit normal.
#[inline]
pub(super) fn vertex(point: DVec3, normal: DVec3) -> Vertex {
    let ([x, y, z], [u, v, w]) = (point.as_vec3().to_array(), normal.as_vec3().to_array());
    [x, y, z, u, v, w]
}
