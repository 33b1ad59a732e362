//! Triangles of polygons with holes: rectilinear footprints, straight, turned, far away, pinched and jittered.

use std::sync::Arc;

use crate::cut_support::*;
use cga_geometry::Axis;
use cga_geometry::cut::{Plane, halves, slabs};
use cga_geometry::mesh::{FaceTag, Mesh, MeshBuilder};
use cga_geometry::triangulate::Triangulator;
use glam::{DVec2, DVec3};

/// The section of a random pattern of cells as polygons, with holes, pinched where cells meet at a corner. Every
/// other polygon keeps the corners between cells.
fn footprints(rng: &mut Rng, count: usize) -> Vec<Vec<Vec<DVec2>>> {
    let mut all = Vec::new();
    while all.len() < count {
        let bits = rng.next() | if rng.below(2) == 0 { rng.next() } else { 0 };
        let mesh = Arc::new(cells(6, |x, y, z| y == 0 && (bits >> (x + 6 * z)) & 1 == 1));
        if mesh.is_empty() {
            continue;
        }
        let parts = slabs(&mesh, Axis::Y, &[0.5]).parts;
        let part = parts[0].as_ref().unwrap();
        for face in part.faces().filter(|face| face.tag().cap) {
            let flat = |&c: &u32| DVec2::new(part.points()[c as usize].z, part.points()[c as usize].x);
            let loops = face.loops().map(|ring| ring.iter().map(flat).collect::<Vec<_>>());
            all.push(if rng.below(2) == 0 { loops.collect() } else { loops.map(|ring| corners_only(&ring)).collect() });
        }
    }
    all
}

fn corners_only(ring: &[DVec2]) -> Vec<DVec2> {
    let count = ring.len();
    let straight =
        |i: usize| (ring[i] - ring[(i + count - 1) % count]).perp_dot(ring[(i + 1) % count] - ring[i]) == 0.0;
    (0..count).filter(|&i| !straight(i)).map(|i| ring[i]).collect()
}

fn area(ring: &[DVec2]) -> f64 {
    0.5 * ring.windows(2).map(|w| (w[0] - ring[0]).perp_dot(w[1] - ring[0])).sum::<f64>()
}

/// Triangulates a polygon, also as a face of a mesh. `slack` is the tolerance for loops that rounding makes cross.
fn check(what: &str, polygon: &[Vec<DVec2>], slack: f64) {
    let points: Vec<DVec2> = polygon.iter().flatten().copied().collect();
    let ends: Vec<u32> = polygon
        .iter()
        .scan(0, |end, ring| {
            *end += ring.len() as u32;
            Some(*end)
        })
        .collect();
    let mut found = Vec::new();
    Triangulator::new().polygon(&points, &ends, &mut found);
    // The triangles of crossing loops need not be connected.
    assert!(what == "jittered" || found.len() == points.len() + 2 * ends.len() - 4, "{what}: {polygon:?}");
    let mut edges = std::collections::HashMap::new();
    let mut count = |a: u32, b: u32, by: i32| {
        *edges.entry((a.min(b), a.max(b))).or_insert(0) += if a < b { by } else { -by };
    };
    let mut start = 0;
    for &end in &ends {
        (start..end).for_each(|i| count(i, if i + 1 == end { start } else { i + 1 }, 1));
        start = end;
    }
    let mut sum = 0.0;
    for t in &found {
        (0..3).for_each(|k| count(t[k], t[(k + 1) % 3], -1));
        sum += area(&t.map(|i| points[i as usize])).abs();
    }
    assert!(edges.values().all(|&net| net == 0), "{what}: the rim is lost of {polygon:?}");
    let expected: f64 = polygon.iter().map(|ring| area(ring)).sum();
    assert!((sum - expected).abs() <= slack, "{what}: {sum} of {expected}: {polygon:?}");
}

fn mapped(polygon: &[Vec<DVec2>], mut by: impl FnMut(DVec2) -> DVec2) -> Vec<Vec<DVec2>> {
    polygon.iter().map(|ring| ring.iter().map(|&p| by(p)).collect()).collect()
}

#[test]
fn rectilinear_footprints_of_every_kind() {
    let mut rng = Rng(11);
    let (sin, cos) = (libm::sin(0.3), libm::cos(0.3));
    let turn = |p: DVec2| DVec2::new(p.x * cos - p.y * sin, p.x * sin + p.y * cos);
    for polygon in footprints(&mut rng, 1500) {
        check("straight", &polygon, 0.0);
        check("sheared", &mapped(&polygon, |p| DVec2::new(p.x + 3.0 * p.y, p.y)), 0.0);
        check("turned a quarter", &mapped(&polygon, |p| DVec2::new(-p.y, p.x)), 0.0);
        check("far", &mapped(&polygon, |p| p + DVec2::splat(500_000.0)), 0.0);
        check("turned", &mapped(&polygon, turn), 1e-12);
        check("turned and far", &mapped(&polygon, |p| turn(p) + DVec2::splat(500_000.0)), 1e-7);
        check("jittered", &mapped(&polygon, |p| p + DVec2::new(rng.unit(), rng.unit()) * 1e-9), 1e-7);
    }
}

#[test]
fn random_stars_and_combs() {
    let mut rng = Rng(12);
    for round in 0..500 {
        let count = 5 + rng.below(60);
        let radii: Vec<f64> = (0..count).map(|_| 0.05 + rng.unit()).collect();
        let star: Vec<DVec2> = ring(count, |i| radii[i]).into_iter().map(|(x, y)| DVec2::new(x, y)).collect();
        check("star", std::slice::from_ref(&star), 1e-13);
        let small: Vec<DVec2> = ring(3 + round % 9, |_| 0.02).into_iter().map(|(x, y)| DVec2::new(x, -y)).collect();
        check("star with a hole", &[star, small], 1e-13);
        let mut comb = vec![DVec2::ZERO, DVec2::new(count as f64, 0.0)];
        for i in (0..count).rev() {
            comb.push(DVec2::new(i as f64 + 0.5, 1.0 + rng.below(5) as f64));
            comb.push(DVec2::new(i as f64, 0.5 + 0.25 * rng.below(2) as f64));
        }
        check("comb", &[comb], 1e-11);
    }
}

#[test]
fn combs_of_many_teeth_begin_and_end_in_any_order() {
    let mut rng = Rng(16);
    let heights: [&mut dyn FnMut(usize) -> f64; 4] =
        [&mut |_| 1.0, &mut |i| 1.0 + i as f64, &mut |i| 1.0 - 1e-5 * i as f64, &mut |_| 1.0 + rng.unit()];
    for height in heights {
        let teeth = 5_000;
        let mut comb = vec![DVec2::new(0.0, -1.0), DVec2::new(f64::from(teeth), -1.0)];
        for i in (0..teeth).rev() {
            let root = height(i as usize);
            comb.push(DVec2::new(f64::from(i) + 0.5, root + 3.0));
            comb.push(DVec2::new(f64::from(i), root));
        }
        for turn in [DVec2::X, DVec2::NEG_X, DVec2::Y] {
            let turned: Vec<DVec2> = comb.iter().map(|p| p.rotate(turn)).collect();
            check("comb of many teeth", &[turned], 1e-5);
        }
    }
}

#[test]
fn any_points_at_all_keep_their_rim() {
    let mut rng = Rng(13);
    for _ in 0..5000 {
        let rings = 1 + rng.below(3);
        let polygon: Vec<Vec<DVec2>> = (0..rings)
            .map(|_| (0..3 + rng.below(9)).map(|_| DVec2::new(rng.below(4) as f64, rng.below(4) as f64)).collect())
            .collect();
        let points: Vec<DVec2> = polygon.iter().flatten().copied().collect();
        let mut end = 0;
        let ends: Vec<u32> = polygon
            .iter()
            .map(|ring| {
                end += ring.len() as u32;
                end
            })
            .collect();
        let mut found = Vec::new();
        Triangulator::new().polygon(&points, &ends, &mut found);
        let signed: f64 = found.iter().map(|t| area(&t.map(|i| points[i as usize]))).sum();
        let expected: f64 = polygon.iter().map(|ring| area(ring)).sum();
        assert!((signed - expected).abs() < 1e-12, "{polygon:?}");
        assert!(rim_is_kept(&polygon, &points, &found), "{polygon:?}");
    }
}

/// Returns true if the edges of the triangles, by position, add up to the edges of the loops.
fn rim_is_kept(polygon: &[Vec<DVec2>], points: &[DVec2], triangles: &[[u32; 3]]) -> bool {
    let mut net = std::collections::HashMap::new();
    let mut count = |ring: &[DVec2], by: i32| {
        for i in 0..ring.len() {
            let [a, b] = [i, (i + 1) % ring.len()].map(|at| (ring[at] + 0.0).to_array().map(f64::to_bits));
            *net.entry((a.min(b), a.max(b))).or_insert(0) += if a < b { by } else { -by };
        }
    };
    polygon.iter().for_each(|ring| count(ring, 1));
    triangles.iter().for_each(|t| count(&t.map(|i| points[i as usize]), -1));
    net.iter().all(|((a, b), &net)| a == b || net == 0)
}

#[test]
fn numbers_of_any_size_do_no_harm() {
    let mut rng = Rng(17);
    let sizes = [0.0, -0.0, 1.0, -1.0, 5e-324, 1e-308, 1e-160, 1e154, -1e300, f64::MAX, f64::MIN, 1.0 + f64::EPSILON];
    let mut triangulator = Triangulator::new();
    for round in 0..3000 {
        let polygon: Vec<Vec<DVec2>> = (0..1 + rng.below(2))
            .map(|_| {
                let corners = 3 + rng.below(if round % 50 == 0 { 150 } else { 12 });
                (0..corners).map(|_| DVec2::new(sizes[rng.below(12)], sizes[rng.below(12)])).collect()
            })
            .collect();
        let points = polygon.concat();
        let ends = if polygon.len() == 1 { vec![points.len()] } else { vec![polygon[0].len(), points.len()] };
        let ends: Vec<u32> = ends.into_iter().map(|end| end as u32).collect();
        let mut found = Vec::new();
        triangulator.polygon(&points, &ends, &mut found);
        assert!(rim_is_kept(&polygon, &points, &found), "{polygon:?}");
    }
}

#[test]
fn faces_far_away_in_any_direction() {
    let outline = polygon(&[(0.0, 0.0), (6.0, 0.0), (6.0, 2.0), (2.0, 2.0), (2.0, 5.0), (0.0, 5.0)]);
    let hole = polygon(&square(0.5, 0.5, 1.0));
    let base = Mesh::from_polygon(&outline, &[hole]).unwrap();
    for far in [0.0, 1e3, 1e6] {
        let mesh = turned(&moved(&base, DVec3::splat(far)));
        check_triangles("far face", &mesh, 10.0 + far * 1e-2);
    }
}

/// A random disc of triangles of equal winding, each attached to an edge of an earlier one. It may overlap itself.
/// Returns its rim.
fn overlapping(rng: &mut Rng, count: usize, size: usize) -> Vec<DVec2> {
    let mut rim: Vec<DVec2> = [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0)].map(DVec2::from).to_vec();
    while rim.len() < count {
        let at = rng.below(rim.len());
        let (a, b) = (rim[at], rim[(at + 1) % rim.len()]);
        let apex = a + DVec2::new(rng.below(size) as f64, rng.below(size) as f64) - (size / 2) as f64;
        if (apex - a).perp_dot(b - a) > 0.0 {
            rim.insert(at + 1, apex);
        }
    }
    rim
}

#[test]
fn loops_that_overlap_themselves_are_not_folded() {
    let mut rng = Rng(14);
    for round in 0..400 {
        let count = 4 + rng.below(if round % 20 == 0 { 120 } else { 30 });
        let size = 4 + rng.below(30);
        let rim = overlapping(&mut rng, count, size);
        check("overlapping", std::slice::from_ref(&rim), 0.0);
        let far: Vec<DVec2> = rim.iter().map(|&p| p.perp() * 0.125 + DVec2::new(500_000.0, -7.5)).collect();
        check("overlapping, far", &[far], 0.0);
    }
}

/// The triangles of the caps by position, the triangles of the upper part reversed, each from its least corner on.
fn caps(part: &Mesh, is_upper: bool) -> Vec<[[u64; 3]; 3]> {
    let mut found = Vec::new();
    let mut triangulator = Triangulator::new();
    part.faces().filter(|face| face.tag().cap).for_each(|face| triangulator.face(part, face.index(), &mut found));
    let position = |c: u32| (part.points()[part.corners()[c as usize] as usize] + 0.0).to_array().map(f64::to_bits);
    let turned = |[a, b, c]: [u32; 3]| if is_upper { [a, c, b] } else { [a, b, c] };
    let from_least = |t: [[u64; 3]; 3]| [t, [t[1], t[2], t[0]], [t[2], t[0], t[1]]].into_iter().min().unwrap();
    found.iter().map(|&triangle| from_least(turned(triangle).map(position))).collect()
}

/// The surface swept by an outline along y, with both ends. It crosses itself if the outline does.
fn tube(outline: &[(f64, f64)]) -> Mesh {
    let count = outline.len() as u32;
    let mut builder = MeshBuilder::new();
    for y in [0.0, 4.0] {
        outline.iter().for_each(|&(x, z)| _ = builder.point([x, y, -z]));
    }
    for i in 0..count {
        let j = (i + 1) % count;
        builder.face(&[i, j, count + j, count + i], &[], FaceTag::PLAIN);
    }
    for end in [(0..count).rev().collect::<Vec<_>>(), (count..2 * count).collect()] {
        builder.face(&end, &[], FaceTag::PLAIN);
    }
    builder.build().unwrap()
}

#[test]
fn caps_of_both_sides_are_mirror_images() {
    let mut rng = Rng(15);
    let mut count = 0;
    for round in 0..300 {
        let bits = rng.next() & rng.next();
        let pattern = cells(4, |x, y, z| (bits >> ((x + 4 * z + 16 * y) & 63)) & 1 == 1);
        let outline: Vec<(f64, f64)> =
            (0..4 + rng.below(9)).map(|_| (rng.below(4) as f64, rng.below(4) as f64)).collect();
        for mesh in [pattern, tube(&outline)] {
            if mesh.is_empty() {
                continue;
            }
            let mesh = Arc::new(if round % 3 == 0 { turned(&mesh) } else { mesh });
            let axis = [Axis::X, Axis::Y, Axis::Z][round % 3];
            let size = mesh.bounds().size()[axis.index()];
            let offsets = [0.3, 0.55].map(|at| mesh.bounds().low[axis.index()] + at * size);
            let parts = slabs(&mesh, axis, &offsets[..1]).parts;
            let normal = [DVec3::new(1.0, 1.0, 0.0), DVec3::new(0.0, -1.0, 1.0), DVec3::new(-1.0, 0.5, 1.0)][round % 3];
            let plane = Plane { point: 0.5 * (mesh.bounds().low + mesh.bounds().high), normal };
            let halves = halves(&mesh, &plane, 0.0).parts;
            for pair in [&parts, &halves] {
                if let [Some(below), Some(above)] = &pair[..] {
                    let found = caps(below, false);
                    count += found.len();
                    assert_eq!(found, caps(above, true), "{outline:?} {round}");
                }
            }
        }
    }
    assert!(8_000 < count, "{count}");
}
