//! Meshes with texture coordinates, and a slow reference cutter.
#![allow(unreachable_pub)]

use cga_geometry::mesh::{FaceTag, Mesh, MeshBuilder, UvAxis};
use cga_geometry::triangulate::Triangulator;
use glam::{DVec2, DVec3};

use crate::cut_support::Rng;

/// A mesh with known properties of its texture coordinates.
pub struct Sample {
    pub name: String,
    pub mesh: Mesh,
    /// Every point has one pair of coordinates in each set.
    pub is_seamless: bool,
    /// Faces are triangles, or their coordinates are affine, so the pieces follow from the triangles.
    pub is_as_triangulated: bool,
    pub is_planar: bool,
}

/// The mesh with coordinates that follow from a corner: its face, its number there and its position.
pub fn charted(mesh: &Mesh, sets: &[usize], chart: impl Fn(usize, usize, DVec3, usize) -> DVec2) -> Mesh {
    let mut builder = MeshBuilder::new();
    builder.tag_sets(mesh.tag_sets().to_vec()).groups(mesh.groups().to_vec());
    let points: Vec<u32> = mesh.points().iter().map(|&point| builder.point(point)).collect();
    for face in mesh.faces() {
        let rings: Vec<Vec<u32>> =
            face.loops().map(|ring| ring.iter().map(|&p| points[p as usize]).collect()).collect();
        let holes: Vec<&[u32]> = rings[1..].iter().map(Vec::as_slice).collect();
        builder.face(&rings[0], &holes, face.tag());
        for &set in sets {
            let corner = |(number, corner): (usize, usize)| {
                chart(face.index(), number, mesh.points()[mesh.corners()[corner] as usize], set)
            };
            let uvs: Vec<DVec2> = face.corner_range().enumerate().map(corner).collect();
            builder.uv_set(set, &uvs);
        }
        let normals: Vec<DVec3> = face.corner_range().map(|_| face.normal()).collect();
        builder.normals(&normals);
    }
    builder.build().unwrap()
}

/// A grid of quads, or of triangles, with a position for each node.
pub fn grid(columns: usize, rows: usize, triangles: bool, place: impl Fn(usize, usize) -> DVec3) -> Mesh {
    let mut builder = MeshBuilder::new();
    let nodes = (0..=rows).flat_map(|j| (0..=columns).map(move |i| (i, j)));
    let points: Vec<u32> = nodes.map(|(i, j)| builder.point(place(i, j))).collect();
    let at = |i: usize, j: usize| points[j * (columns + 1) + i];
    for (i, j) in (0..rows).flat_map(|j| (0..columns).map(move |i| (i, j))) {
        let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
        let faces: &[&[u32]] = if triangles { &[&[a, b, c], &[a, c, d]] } else { &[&[a, b, c, d]] };
        for face in faces {
            builder.face(face, &[], FaceTag::PLAIN);
        }
    }
    builder.build().unwrap()
}

/// The corners of a quad of a street, each with its position along and across the whole street as (u, v) in [0, 1].
pub fn street(bends: &[(f64, f64)], width: f64) -> Mesh {
    let mut builder = MeshBuilder::new();
    let mut uvs = Vec::new();
    let count = bends.len();
    let direction = |i: usize| DVec2::new(bends[i + 1].0 - bends[i].0, bends[i + 1].1 - bends[i].1).normalize();
    let length = |i: usize| DVec2::from(bends[i]).distance(DVec2::from(bends[i + 1]));
    let total: f64 = (0..count - 1).map(length).sum();
    let mut along = 0.0;
    let mut pairs = Vec::new();
    for (i, &bend) in bends.iter().enumerate() {
        let before = direction(i.saturating_sub(1));
        let after = direction(i.min(count - 2));
        let mitre = (before + after).normalize();
        let half = width / 2.0 / mitre.dot(after);
        let left = DVec2::new(-mitre.y, mitre.x) * half;
        let pair = [-left, left].map(|side| DVec2::from(bend) + side);
        pairs.push(pair.map(|p| builder.point([p.x, 0.0, -p.y])));
        uvs.push(along / total);
        along += if i + 1 < count { length(i) } else { 0.0 };
    }
    for i in 0..count - 1 {
        let [[a, d], [b, c]] = [pairs[i], pairs[i + 1]];
        builder.face(&[a, b, c, d], &[], FaceTag::PLAIN);
        let (from, to) = (uvs[i], if i + 2 == count { 1.0 } else { uvs[i + 1] });
        builder.uvs(&[DVec2::new(from, 0.0), DVec2::new(to, 0.0), DVec2::new(to, 1.0), DVec2::new(from, 1.0)]);
    }
    builder.build().unwrap()
}

/// A number between small integers and floats.
pub fn number(rng: &mut Rng, most: usize) -> f64 {
    match rng.below(3) {
        0 => rng.unit() * most as f64,
        1 => rng.below(2 * most + 1) as f64 / 2.0,
        _ => rng.below(most + 1) as f64,
    }
}

/// The area of faces' triangles between two values of a coordinate. Faces of one value belong to the band above.
pub fn area_between(mesh: &Mesh, set: usize, axis: UvAxis, low: f64, high: f64) -> f64 {
    let mut triangulator = Triangulator::new();
    let mut triangles = Vec::new();
    mesh.faces().for_each(|face| triangulator.face(mesh, face.index(), &mut triangles));
    let mut sum = 0.0;
    for triangle in triangles {
        let corner =
            |c: u32| (mesh.points()[mesh.corners()[c as usize] as usize], mesh.uv_set(set)[c as usize][axis.index()]);
        let mut ring = triangle.map(corner).to_vec();
        if ring.iter().all(|&(_, value)| value == ring[0].1) {
            if ring[0].1 < low || high <= ring[0].1 {
                continue;
            }
        } else {
            ring = clip(&clip(&ring, |value| value - low), |value| high - value);
        }
        let fan = (2..ring.len()).map(|i| (ring[i - 1].0 - ring[0].0).cross(ring[i].0 - ring[0].0));
        sum += 0.5 * fan.sum::<DVec3>().length();
    }
    sum
}

fn clip(ring: &[(DVec3, f64)], height: impl Fn(f64) -> f64) -> Vec<(DVec3, f64)> {
    let mut kept = Vec::new();
    for (i, &(p, a)) in ring.iter().enumerate() {
        let (q, b) = ring[(i + 1) % ring.len()];
        let (ha, hb) = (height(a), height(b));
        if 0.0 <= ha {
            kept.push((p, a));
        }
        if (ha < 0.0) != (hb < 0.0) && ha != 0.0 && hb != 0.0 && ha.is_finite() && hb.is_finite() {
            let share = ha / (ha - hb);
            kept.push((p.lerp(q, share), a + (b - a) * share));
        }
    }
    kept
}
