//! Meshes and checks shared by the tests of the cutter.
#![allow(dead_code, unreachable_pub)]

pub mod bytes;
pub mod corpus;
pub mod section;

use std::collections::{BTreeSet, HashMap};
use std::f64::consts::TAU;
use std::sync::Arc;

use cga_geometry::Axis;
use cga_geometry::cut::{Slabs, slabs};
use cga_geometry::extrude::{Extrude, extrude};
use cga_geometry::mesh::{FaceTag, Mesh, MeshBuilder, TagSet};
use cga_geometry::triangulate::Triangulator;
use glam::{DAffine3, DMat3, DVec3};

pub const AXES: [Axis; 3] = [Axis::X, Axis::Y, Axis::Z];

/// A pseudo-random number generator (splitmix64).
pub struct Rng(pub u64);

impl Rng {
    pub fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }

    pub fn below(&mut self, end: usize) -> usize {
        (self.next() % end as u64) as usize
    }

    pub fn unit(&mut self) -> f64 {
        (self.next() >> 11) as f64 / (1u64 << 53) as f64
    }
}

pub fn polygon(points: &[(f64, f64)]) -> Vec<DVec3> {
    points.iter().map(|&(x, z)| DVec3::new(x, 0.0, -z)).collect()
}

/// An extruded footprint.
pub fn prism(outline: &[(f64, f64)], holes: &[Vec<(f64, f64)>], height: f64) -> Mesh {
    let holes: Vec<Vec<DVec3>> = holes.iter().map(|hole| polygon(hole)).collect();
    extrude(&Mesh::from_polygon(&polygon(outline), &holes).unwrap(), Extrude::FaceNormal, height)
}

pub fn square(x: f64, z: f64, size: f64) -> Vec<(f64, f64)> {
    vec![(x, z), (x + size, z), (x + size, z + size), (x, z + size)]
}

pub fn ring(count: usize, radius: impl Fn(usize) -> f64) -> Vec<(f64, f64)> {
    (0..count)
        .map(|i| {
            let angle = TAU * i as f64 / count as f64;
            (radius(i) * libm::cos(angle), radius(i) * libm::sin(angle))
        })
        .collect()
}

/// A torus about z: `around` × `across` quads, first vertex at angle 0.
pub fn torus(around: usize, across: usize, large: f64, small: f64) -> Mesh {
    let mut b = MeshBuilder::new();
    for i in 0..around {
        let u = TAU * i as f64 / around as f64;
        for j in 0..across {
            let v = TAU * j as f64 / across as f64;
            let r = large + small * libm::cos(v);
            b.point([r * libm::cos(u), r * libm::sin(u), small * libm::sin(v)]);
        }
    }
    let at = |i: usize, j: usize| ((i % around) * across + j % across) as u32;
    for i in 0..around {
        for j in 0..across {
            b.face(&[at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)], &[], FaceTag::PLAIN);
        }
    }
    b.build().unwrap()
}

/// The surface of the unit cells for which `filled` returns true.
pub fn cells(size: usize, filled: impl Fn(i32, i32, i32) -> bool) -> Mesh {
    let mut b = MeshBuilder::new();
    let size = size as i32;
    let inside = |c: [i32; 3]| c.iter().all(|&v| 0 <= v && v < size) && filled(c[0], c[1], c[2]);
    for x in 0..size {
        for y in 0..size {
            for z in 0..size {
                if !inside([x, y, z]) {
                    continue;
                }
                for axis in 0..3 {
                    for side in [0, 1] {
                        let mut other = [x, y, z];
                        other[axis] += 2 * side - 1;
                        if inside(other) {
                            continue;
                        }
                        let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
                        let mut corners = [(0, 0), (1, 0), (1, 1), (0, 1)].map(|(du, dv)| {
                            let mut p = [x, y, z];
                            p[axis] += side;
                            p[u] += du;
                            p[v] += dv;
                            b.point(p.map(f64::from))
                        });
                        if side == 0 {
                            corners.reverse();
                        }
                        b.face(&corners, &[], FaceTag::PLAIN);
                    }
                }
            }
        }
    }
    b.build().unwrap()
}

/// Several meshes in one.
pub fn together(meshes: &[Mesh]) -> Mesh {
    let mut b = MeshBuilder::new();
    for mesh in meshes {
        let points: Vec<u32> = mesh.points().iter().map(|&p| b.point(p)).collect();
        for face in mesh.faces() {
            let loops: Vec<Vec<u32>> =
                face.loops().map(|ring| ring.iter().map(|&c| points[c as usize]).collect()).collect();
            let holes: Vec<&[u32]> = loops[1..].iter().map(Vec::as_slice).collect();
            b.face(&loops[0], &holes, FaceTag { cap: face.tag().cap, ..FaceTag::PLAIN });
        }
    }
    b.build().unwrap()
}

pub fn moved(mesh: &Mesh, by: DVec3) -> Mesh {
    mesh.map(&DAffine3::from_translation(by))
}

/// The mesh turned about an oblique axis, so that nothing is aligned.
pub fn turned(mesh: &Mesh) -> Mesh {
    let (x, y) = (DVec3::new(0.36, 0.48, 0.8), DVec3::new(-0.8, 0.6, 0.0));
    mesh.map(&DAffine3::from_mat3(DMat3::from_cols(x, y, x.cross(y))))
}

/// Returns true if the mesh is closed when positions are compared bit by bit instead of indices; also for an empty
/// mesh.
pub fn closed_by_position(mesh: &Mesh) -> bool {
    let welded = together(std::slice::from_ref(mesh));
    welded.is_empty() || welded.is_closed()
}

/// Even cuts inside a mesh, not at its own coordinates.
pub fn even(mesh: &Mesh, axis: Axis, count: usize) -> Vec<f64> {
    let (low, high) = (mesh.bounds().low[axis.index()], mesh.bounds().high[axis.index()]);
    (1..=count).map(|i| low + (high - low) * (i as f64 + 0.0123) / (count + 1) as f64).collect()
}

/// Cuts at coordinates of the mesh itself.
pub fn own(mesh: &Mesh, axis: Axis, count: usize) -> Vec<f64> {
    let mut all: Vec<f64> = mesh.points().iter().map(|p| p[axis.index()]).collect();
    all.sort_by(f64::total_cmp);
    all.dedup();
    let step = all.len().div_ceil(count).max(1);
    all.into_iter().step_by(step).collect()
}

/// Cuts a closed mesh and checks the result against every law.
pub fn check_closed_cut(name: &str, mesh: &Arc<Mesh>, axis: Axis, offsets: &[f64]) -> Slabs {
    let what = format!("{name} across {axis:?} at {offsets:?}");
    let cut = slabs(mesh, axis, offsets);
    assert_eq!(cut.parts.len(), offsets.len() + 1, "{what}");
    assert!(cut.open.is_empty(), "{what}: left open {:?}", cut.open);
    let scale = mesh.bounds().size().max_element();
    let (mut volume, mut old, mut caps) = (0.0, 0.0, vec![[0.0; 2]; offsets.len()]);
    for (slab, part) in cut.parts.iter().enumerate() {
        let Some(part) = part else { continue };
        let flaws = part.check();
        assert!(flaws.is_empty(), "{what}: part {slab} {flaws:?}");
        assert!(part.is_closed() && closed_by_position(part), "{what}: part {slab} is open");
        volume += part.volume();
        let (low, high) = (part.bounds().low[axis.index()], part.bounds().high[axis.index()]);
        assert!(slab == 0 || offsets[slab - 1] <= low, "{what}: part {slab} reaches down to {low}");
        assert!(slab == offsets.len() || high <= offsets[slab], "{what}: part {slab} reaches up to {high}");
        for face in part.faces() {
            if face.tag().cap && !mesh.faces().any(|face| face.tag().cap) {
                let at = part.points()[face.outer()[0] as usize][axis.index()];
                let below = offsets.get(slab) == Some(&at);
                caps[if below { slab } else { slab - 1 }][usize::from(below)] += face.area();
            } else {
                old += face.area();
            }
        }
        check_triangles(&what, part, scale);
        let again = slabs(part, axis, offsets);
        let same = again.parts[slab].as_ref().is_some_and(|same| Arc::ptr_eq(same, part));
        assert!(same, "{what}: cutting part {slab} again changes it");
        assert_eq!(again.parts.iter().flatten().count(), 1, "{what}: cutting part {slab} again splits it");
    }
    let near = |a: f64, b: f64, of: f64| (a - b).abs() <= 1e-11 * of;
    let whole = mesh.volume();
    assert!(near(volume, whole, scale * scale * scale), "{what}: volumes add up to {volume}, not {whole}");
    let area = mesh.area();
    if !mesh.faces().any(|face| face.tag().cap) {
        assert!(near(old, area, area), "{what}: areas add up to {old}, not {area}");
    }
    for [down, up] in caps {
        assert!(near(down, up, area), "{what}: caps of {down} and {up}");
    }
    cut
}

/// Checks that triangles have the rim of their face, and its area without reversed triangles.
pub fn check_triangles(what: &str, mesh: &Mesh, scale: f64) {
    let mut triangulator = Triangulator::new();
    let mut found = Vec::new();
    for (index, face) in mesh.faces().enumerate() {
        found.clear();
        triangulator.face(mesh, index, &mut found);
        let corners = mesh.corners();
        let mut net: HashMap<(u32, u32), i32> = HashMap::new();
        let mut count = |a: u32, b: u32, by: i32| {
            *net.entry((a.min(b), a.max(b))).or_default() += if a < b { by } else { -by };
        };
        for ring in face.loops() {
            (0..ring.len()).for_each(|i| count(ring[i], ring[(i + 1) % ring.len()], 1));
        }
        let mut sum = 0.0;
        for t in &found {
            let t = t.map(|corner| corners[corner as usize]);
            (0..3).for_each(|k| count(t[k], t[(k + 1) % 3], -1));
            let [a, b, c] = t.map(|i| mesh.points()[i as usize]);
            sum += 0.5 * (b - a).cross(c - a).length();
        }
        assert!(net.values().all(|&n| n == 0), "{what}: triangles of face {index} leave its rim");
        let area = face.area();
        assert!((sum - area).abs() <= 1e-11 * scale * scale, "{what}: face {index} has {area}, triangles {sum}");
    }
}

/// The mesh with a tag for each edge, made of the numbers of its points, and one for each vertex.
pub fn tagged(mesh: &Mesh) -> Mesh {
    let mut builder = MeshBuilder::new();
    for (number, point) in mesh.points().iter().enumerate() {
        builder.point(*point);
        builder.vertex_tags(number as u32, &TagSet::new([format!("v.{number}")]));
    }
    for face in mesh.faces() {
        let loops: Vec<&[u32]> = face.loops().collect();
        builder.face(loops[0], &loops[1..], FaceTag { tags: FaceTag::NONE, ..face.tag() });
        for ring in loops {
            for k in 0..ring.len() {
                let [a, b] = [ring[k], ring[(k + 1) % ring.len()]];
                builder.edge_tags([a, b], &TagSet::new([edge_tag([a, b])]));
            }
        }
    }
    builder.build().unwrap()
}

/// The tag that [`tagged`] gives an edge.
pub fn edge_tag([a, b]: [u32; 2]) -> String {
    format!("e.{}.{}", a.min(b), a.max(b))
}

/// The edges of a mesh, each once, as the numbers of their points.
pub fn edges(mesh: &Mesh) -> BTreeSet<[u32; 2]> {
    let rings = mesh.faces().flat_map(|face| face.loops().map(<[u32]>::to_vec).collect::<Vec<_>>());
    let sides = |ring: Vec<u32>| (0..ring.len()).map(|k| [ring[k], ring[(k + 1) % ring.len()]]).collect::<Vec<_>>();
    rings.flat_map(sides).map(|[a, b]| [a.min(b), a.max(b)]).collect()
}
