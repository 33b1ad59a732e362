//! Laws of networks, and their checks.

use std::collections::{HashMap, HashSet};

use glam::DVec2;

use super::*;
use cga_geometry::mesh::FaceRef;

/// The rings of a face in plan; an outline is counter-clockwise as seen from above.
fn flat(face: &FaceRef<'_>, mesh: &Mesh) -> Vec<Vec<DVec2>> {
    let place = |&corner: &u32| DVec2::new(mesh.points()[corner as usize].x, -mesh.points()[corner as usize].z);
    face.loops().map(|ring| ring.iter().map(place).collect()).collect()
}

fn area(ring: &[DVec2]) -> f64 {
    ring.windows(2).map(|edge| (edge[0] - ring[0]).perp_dot(edge[1] - ring[0])).sum::<f64>() / 2.0
}

type Bits = [u64; 3];

fn bits(mesh: &Mesh, corner: u32) -> Bits {
    mesh.points()[corner as usize].to_array().map(f64::to_bits)
}

/// Checks the areas and the texture coordinates of a network.
pub(super) fn check(network: &Network, name: &str) {
    check_areas(network, name);
    network.parts().iter().for_each(|part| coordinates(part, name));
}

/// Checks the areas of a network. Directed edges of all faces pair up or are on the border of the whole. No point is inside an edge.
/// The sum of the areas is the area within the border. So parts neither overlap nor leave gaps.
fn check_areas(network: &Network, name: &str) {
    let mut edges: HashMap<(Bits, Bits), usize> = HashMap::new();
    let mut ends: HashMap<(u64, u64), Bits> = HashMap::new();
    let mut sum = 0.0;
    for (number, part) in network.parts().iter().enumerate() {
        let mesh = &part.mesh;
        assert_eq!(mesh.check(), [], "{name}: part {number}");
        for face in mesh.faces() {
            let rings = flat(&face, mesh);
            assert!(0.0 < area(&rings[0]), "{name}: a face of part {number} is turned over");
            sum += rings.iter().map(|ring| area(ring)).sum::<f64>();
            for ring in face.loops() {
                for at in 0..ring.len() {
                    let (a, b) = (bits(mesh, ring[at]), bits(mesh, ring[(at + 1) % ring.len()]));
                    let before = edges.insert((a, b), number);
                    assert_eq!(before, None, "{name}: an edge of part {number} has two faces on one side");
                    // A point has one height.
                    let known = *ends.entry((a[0], a[2])).or_insert(a);
                    assert_eq!(known, a, "{name}: part {number}");
                }
            }
        }
    }
    // The border: edges with a face on one side only. The signed area within it equals the sum of the areas of all
    // parts.
    let border: Vec<(Bits, Bits)> = edges.keys().filter(|&&(a, b)| !edges.contains_key(&(b, a))).copied().collect();
    let place = |bits: Bits| DVec2::new(f64::from_bits(bits[0]), -f64::from_bits(bits[2]));
    let within: f64 = border.iter().map(|&(a, b)| place(a).perp_dot(place(b)) / 2.0).sum();
    assert!((within - sum).abs() <= 1e-9 * (1.0 + sum), "{name}: {within} {sum}");
    disjoint(network, &border, name);
    touching(&border, name);
}

/// Checks at random points that triangles of the network do not overlap. Each point is inside at most one face, and
/// inside exactly one if the border winds around it.
fn disjoint(network: &Network, border: &[(Bits, Bits)], name: &str) {
    let place = |bits: Bits| DVec2::new(f64::from_bits(bits[0]), -f64::from_bits(bits[2]));
    let faces: Vec<Vec<Vec<DVec2>>> =
        network.parts().iter().flat_map(|part| part.mesh.faces().map(|face| flat(&face, &part.mesh))).collect();
    let mut state = 12345u64;
    let mut random = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1u64 << 53) as f64
    };
    let all = || faces.iter().flatten().flatten();
    let (low, high) =
        (all().fold(DVec2::INFINITY, |a, &b| a.min(b)), all().fold(DVec2::NEG_INFINITY, |a, &b| a.max(b)));
    let crosses = |a: DVec2, b: DVec2, p: DVec2| {
        let side = (b - a).perp_dot(p - a);
        i32::from(a.y <= p.y && p.y < b.y && 0.0 < side) - i32::from(b.y <= p.y && p.y < a.y && side < 0.0)
    };
    for _ in 0..150 {
        let p = low + (high - low) * DVec2::new(random(), random());
        let turns = |rings: &Vec<Vec<DVec2>>| -> i32 {
            rings
                .iter()
                .map(|ring| (0..ring.len()).map(|at| crosses(ring[at], ring[(at + 1) % ring.len()], p)).sum::<i32>())
                .sum()
        };
        let count: i32 = faces.iter().map(turns).sum();
        let around: i32 = border.iter().map(|&(a, b)| crosses(place(a), place(b), p)).sum();
        assert!((0..=1).contains(&count) && count == around, "{name}: {p} is inside of {count} faces, {around}");
    }
}

/// No point of the border is inside an edge of it: neighbours share all points of their common border.
fn touching(border: &[(Bits, Bits)], name: &str) {
    let place = |bits: Bits| DVec2::new(f64::from_bits(bits[0]), -f64::from_bits(bits[2]));
    if 3000 < border.len() {
        return;
    }
    let points: HashSet<Bits> = border.iter().map(|edge| edge.0).collect();
    for &(a, b) in border {
        let (from, to) = (place(a), place(b));
        for &point in points.iter().filter(|&&point| point != a && point != b) {
            let (off, along) = (place(point) - from, to - from);
            let part = off.dot(along) / along.length_squared();
            let near = (off - along * part).length();
            assert!(near > 1e-9 || !(0.0..=1.0).contains(&part), "{name}: {from} {to} {}", place(point));
        }
    }
}

/// Coordinates of streets go from 0 to 1, agree at common points, and are counter-clockwise on roadways.
fn coordinates(part: &NetworkPart, name: &str) {
    let mesh = &part.mesh;
    let sets: &[usize] = if part.line.is_some() { &[0, 1, 2] } else { &[0] };
    for &set in sets {
        let uvs = mesh.uv_set(set);
        assert_eq!(uvs.len(), mesh.corners().len(), "{name}: set {set} of {:?}", part.kind);
        let mut known: HashMap<u32, DVec2> = HashMap::new();
        let most = if set == 0 { DVec2::ONE } else { DVec2::new(part.length, part.width) };
        for (&corner, &uv) in mesh.corners().iter().zip(uvs) {
            let slack = 1e-9 * most;
            assert!(uv.cmpge(-slack).all() && uv.cmple(most + slack).all(), "{name}: {uv} {most}");
            // Inner borders of tight bends overlap, so a sidewalk's border may be in two cells there.
            if part.kind == Kind::Street {
                let before = *known.entry(corner).or_insert(uv);
                // The end of a loop is its start.
                let seam = (before.x - uv.x).abs() == most.x && before.y == uv.y;
                assert!(before == uv || seam, "{name}: set {set} at {}", mesh.points()[corner as usize]);
            }
        }
    }
    if part.kind == Kind::Street {
        for face in mesh.faces() {
            // Points on an edge of a sloping quad leave triangles that are rounding errors only.
            if area(&flat(&face, mesh)[0]) < 1e-5 {
                continue;
            }
            let uvs: Vec<DVec2> = face.corner_range().take(face.outer().len()).map(|at| mesh.uv_set(1)[at]).collect();
            assert!(0.0 < area(&uvs), "{name}: a face is mirrored: {uvs:?} {:?}", flat(&face, mesh));
        }
        let uvs = || mesh.uvs().iter();
        let (low, high) = (uvs().fold(DVec2::ONE, |a, &b| a.min(b)), uvs().fold(DVec2::ZERO, |a, &b| a.max(b)));
        assert_eq!((low, high), (DVec2::ZERO, DVec2::ONE), "{name}");
    }
}

#[test]
fn hard_cases_are_divided_without_overlaps_and_gaps() {
    for (name, lines) in cases::cases() {
        let network = Network::new(&lines, &NetworkOptions::default()).unwrap();
        check(&network, name);
        for radius in [0.0, 1.5, 12.0] {
            let options = NetworkOptions { corner_radius: radius, ..NetworkOptions::default() };
            check(&Network::new(&lines, &options).unwrap(), name);
        }
    }
}

#[test]
fn parts_do_not_overlap_even_if_the_plan_does() {
    for (name, lines) in cases::cases() {
        for attempts in [0, 1] {
            check_areas(&Network::within(&lines, &NetworkOptions::default(), attempts).unwrap(), name);
        }
    }
}
