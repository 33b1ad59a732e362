//! Vertices and indices of quads, written in place.

use glam::{DVec3, Vec4};

use super::Vertex;
use crate::sink::corners::Placed;
use crate::unit::UnitMesh;

/// Writes the faces of a box; `normals` are those of its sides, each after a 0.
#[inline(always)]
pub(super) fn write_box(to: &mut [[Vertex; 4]; 6], placed: &Placed, unit: UnitMesh, normals: &[Vec4; 6]) {
    let corners = placed.box_corners();
    for (face, to) in unit.sides().iter().zip(to) {
        let n = normals[face.side as usize];
        let [a, b, c, d] = face.corners.map(|corner| corners[usize::from(corner & 7)]);
        // Sums put numbers beside each other: the fourth coordinate of corners is 0, and so is the first of normals.
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

/// Writes the vertices of a face.
#[inline(always)]
fn write(to: &mut [Vertex; 4], vectors: [Vec4; 6]) {
    let (chunks, _) = to.as_flattened_mut().as_chunks_mut::<4>();
    for (to, vector) in chunks.iter_mut().zip(vectors) {
        *to = vector.to_array();
    }
}

/// Writes the four vertices of a rectangle as six vectors.
#[inline(always)]
pub(super) fn write_quad(to: &mut [Vertex; 4], mut placed: Placed, n: Vec4) {
    // With the first part of the normal as its fourth coordinate a corner is a vector as it is.
    placed.origin.w = f64::from(n.y);
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

/// Writes the indices of quads whose vertices follow each other.
#[inline(always)]
pub(in crate::sink) fn write_quad_indices(to: &mut [u32], start: u32) {
    // From the vertex before the first: a sum with 0 is no sum, and the compiler adds four numbers at once or one by one.
    const PAIR: [u32; 12] = [1, 2, 3, 1, 3, 4, 5, 6, 7, 5, 7, 8];
    let (pairs, rest) = to.as_chunks_mut::<12>();
    let mut before = start.wrapping_sub(1);
    for pair in pairs {
        *pair = PAIR.map(|corner| before.wrapping_add(corner));
        before = before.wrapping_add(8);
    }
    for (to, corner) in rest.iter_mut().zip(PAIR) {
        *to = before.wrapping_add(corner);
    }
}

#[inline]
pub(super) fn vertex(p: [f32; 3], n: [f32; 3]) -> Vertex {
    [p[0], p[1], p[2], n[0], n[1], n[2]]
}

#[inline]
pub(super) fn short(v: DVec3) -> [f32; 3] {
    [v.x as f32, v.y as f32, v.z as f32]
}
