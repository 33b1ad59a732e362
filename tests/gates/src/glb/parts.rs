//! The parts of a primitive: a file has no borders between the leaves of a rule.

use std::collections::HashMap;

use cga::glam::DVec3;
use cga_geometry::disjoint::DisjointSets;

use super::Primitive;

/// Triangles of one rule, one building and one material: a closed part, or all triangles that belong to none.
pub(super) struct FilePart {
    pub(super) owner: [u32; 2],
    pub(super) triangles: Vec<[u32; 3]>,
    pub(super) is_closed: bool,
    pub(super) volume: f64,
}

/// The parts of a primitive. A closed part is the shortest row of neighbouring triangles, in the order of the file, in which each edge has its
/// opposite.
pub(super) fn parts(primitive: &Primitive) -> Vec<FilePart> {
    let mut parts = Vec::new();
    let points = points(&primitive.positions);
    let owner = |triangle: &[u32; 3]| primitive.owners[triangle[0] as usize];
    for row in primitive.triangles.chunk_by(|a, b| owner(a) == owner(b)) {
        let mut rest = Vec::new();
        for own in connected(row, &points) {
            let (mut edges, mut open, mut first) = (HashMap::new(), 0_usize, 0);
            for (at, triangle) in own.iter().enumerate() {
                let [a, b, c] = triangle.map(|corner| points[corner as usize]);
                for [from, to] in [[a, b], [b, c], [c, a]].into_iter().filter(|[from, to]| from != to) {
                    let (key, sign) = if from < to { ([from, to], 1_i32) } else { ([to, from], -1) };
                    let count = edges.entry(key).or_insert(0_i32);
                    let before = count.unsigned_abs() as usize;
                    *count += sign;
                    open = open + count.unsigned_abs() as usize - before;
                }
                if open == 0 {
                    let triangles = own[first..=at].to_vec();
                    let volume = volume(primitive, &triangles);
                    parts.push(FilePart { owner: owner(triangle), triangles, is_closed: true, volume });
                    (edges, first) = (HashMap::new(), at + 1);
                }
            }
            rest.extend_from_slice(&own[first..]);
        }
        if let Some(first) = rest.first() {
            parts.push(FilePart { owner: owner(first), triangles: rest, is_closed: false, volume: 0.0 });
        }
    }
    parts
}

/// The number of the point at each vertex. Faces do not share vertices.
fn points(positions: &[DVec3]) -> Vec<u32> {
    let mut numbers = HashMap::new();
    let number = |at: &DVec3| {
        let next = numbers.len() as u32;
        // −0 and 0 are one place.
        *numbers.entry(at.to_array().map(|c| (c as f32 + 0.0).to_bits())).or_insert(next)
    };
    positions.iter().map(number).collect()
}

/// The groups of triangles that have points in common, each in the order of the file.
fn connected(triangles: &[[u32; 3]], points: &[u32]) -> Vec<Vec<[u32; 3]>> {
    let mut sets = DisjointSets::new(triangles.len());
    let mut first = HashMap::new();
    for (number, triangle) in (0..).zip(triangles) {
        for corner in triangle {
            sets.unite(*first.entry(points[*corner as usize]).or_insert(number), number);
        }
    }
    let group = |numbers: Vec<u32>| numbers.into_iter().map(|number| triangles[number as usize]).collect();
    sets.sets().into_iter().map(group).collect()
}

/// The enclosed volume in cubic metres.
fn volume(primitive: &Primitive, triangles: &[[u32; 3]]) -> f64 {
    let origin = primitive.positions[triangles[0][0] as usize];
    let part = |triangle: &[u32; 3]| {
        let [a, b, c] = triangle.map(|corner| primitive.positions[corner as usize] - origin);
        a.dot(b.cross(c)) / 6.0
    };
    triangles.iter().map(part).sum()
}
