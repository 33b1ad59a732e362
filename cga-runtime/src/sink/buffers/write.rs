//! Vertices and indices of quads, written in place.

use glam::{DVec3, Vec4};

use super::Vertex;
use crate::sink::Cuboid;

/// A corner, rounded.
#[inline(always)]
pub(in crate::sink) fn four(p: DVec3) -> Vec4 {
    Vec4::new(p.x as f32, p.y as f32, p.z as f32, 0.0)
}

/// The corners of a box, as numbers x + 2y + 4z count them. Each is rounded once, so the three faces that meet there agree.
#[inline(always)]
pub(in crate::sink) fn box_corners(cuboid: &Cuboid) -> [Vec4; 8] {
    // Whole vectors are stored and loaded: parts of one would have to wait for each other.
    let (o, [x, y, z]) = (cuboid.origin, [cuboid.sides.x_axis, cuboid.sides.y_axis, cuboid.sides.z_axis]);
    let (p, q) = (o + y, o + z);
    let r = p + z;
    [four(o), four(o + x), four(p), four(p + x), four(q), four(q + x), four(r), four(r + x)]
}

/// Writes the faces of a box; `normals` are those of its sides.
#[inline(always)]
pub(super) fn write_box(to: &mut [[Vertex; 4]; 6], cuboid: &Cuboid, normals: &[[f32; 3]; 6]) {
    let corners = box_corners(cuboid);
    for (face, to) in cuboid.unit.sides().iter().zip(to) {
        write_face(to, face.corners.map(|corner| corners[usize::from(corner & 7)]), normals[face.side as usize]);
    }
}

/// Writes the indices of quads whose vertices follow each other.
#[inline(always)]
pub(in crate::sink) fn write_quad_indices(to: &mut [u32], start: u32) {
    const PAIR: [u32; 12] = [0, 1, 2, 0, 2, 3, 4, 5, 6, 4, 6, 7];
    let (pairs, rest) = to.as_chunks_mut::<12>();
    let mut first = start;
    for pair in pairs {
        *pair = PAIR.map(|corner| first + corner);
        first += 8;
    }
    for (to, corner) in rest.iter_mut().zip(PAIR) {
        *to = first + corner;
    }
}

/// Writes the four vertices of a face as six vectors.
#[inline(always)]
pub(super) fn write_face(to: &mut [Vertex; 4], [a, b, c, d]: [Vec4; 4], [u, v, w]: [f32; 3]) {
    let vectors = [
        Vec4::new(a.x, a.y, a.z, u),
        Vec4::new(v, w, b.x, b.y),
        Vec4::new(b.z, u, v, w),
        Vec4::new(c.x, c.y, c.z, u),
        Vec4::new(v, w, d.x, d.y),
        Vec4::new(d.z, u, v, w),
    ];
    let (chunks, _) = to.as_flattened_mut().as_chunks_mut::<4>();
    for (to, vector) in chunks.iter_mut().zip(vectors) {
        *to = vector.to_array();
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
