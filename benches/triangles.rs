//! Triangles of faces: small faces, and caps with up to a million corners.
//!
//! `cargo bench --bench triangles`, with `-- --instructions` instructions instead of times. The time is proportional to n log n for n corners, for every shape. A face with a
//! million corners is also written to vertex buffers, GLB and OBJ.

mod common;

use std::f64::consts::TAU;
use std::hint::black_box;
use std::time::Instant;

use cga::glam::DVec2;
use cga::sink::buffers::Buffers;
use cga::sink::gltf::Glb;
use cga::sink::obj::Obj;
use cga::{Mesh, Settings, Shape, Sink, cga};
use cga_runtime::geometry::triangulate::Triangulator;
use common::clock::{fastest, nanoseconds_each};
use common::instructions::{Work, counted};
use common::table::{Table, number};

cga! {
    /// The unchanged shape.
    grammar Plain;

    Lot --> Leaf.
}

/// The loops of a polygon, the outline first.
type Polygon = Vec<Vec<DVec2>>;

/// Teeth that point up. A function of the index gives the heights of tips and roots.
fn comb(corners: usize, height: impl Fn(usize) -> f64) -> Polygon {
    let teeth = corners / 2 - 1;
    let mut outline = vec![DVec2::ZERO, DVec2::new(teeth as f64, 0.0)];
    for i in (0..teeth).rev() {
        outline.push(DVec2::new(i as f64 + 0.5, 3.0 + height(2 * i)));
        outline.push(DVec2::new(i as f64, 1.0 + height(2 * i + 1)));
    }
    vec![outline]
}

/// Pseudo-random numbers from 0 to 1.
fn mixed(i: usize) -> f64 {
    let mixed = (i as u64 + 1).wrapping_mul(0x9E37_79B9_7F4A_7C15);
    ((mixed ^ mixed >> 29).wrapping_mul(0xBF58_476D_1CE4_E5B9) >> 11) as f64 / (1u64 << 53) as f64
}

fn ring(corners: usize, radius: impl Fn(usize) -> f64) -> Vec<DVec2> {
    let at = |i: usize| {
        let angle = i as f64 * TAU / corners as f64;
        DVec2::new(libm::cos(angle), libm::sin(angle)) * radius(i)
    };
    (0..corners).map(at).collect()
}

/// A wall with square windows.
fn windows(side: usize) -> Polygon {
    let end = side as f64;
    let mut loops = vec![[(0.0, 0.0), (end, 0.0), (end, end), (0.0, end)].map(DVec2::from).to_vec()];
    for at in 0..side * side {
        let (x, y) = ((at / side) as f64 + 0.25, (at % side) as f64 + 0.25);
        loops.push([(x, y), (x, y + 0.5), (x + 0.5, y + 0.5), (x + 0.5, y)].map(DVec2::from).to_vec());
    }
    loops
}

fn area(ring: &[DVec2]) -> f64 {
    0.5 * ring.windows(2).map(|w| (w[0] - ring[0]).perp_dot(w[1] - ring[0])).sum::<f64>()
}

/// The points of all loops, and the ends of the loops.
fn flat(polygon: &Polygon) -> (Vec<DVec2>, Vec<u32>) {
    let mut end = 0;
    let ends = polygon.iter().map(|ring| {
        end += ring.len() as u32;
        end
    });
    (polygon.concat(), ends.collect())
}

fn row(table: &mut Table, name: &str, polygon: &Polygon) {
    let (points, ends) = flat(polygon);
    let mut triangulator = Triangulator::new();
    let mut triangles = Vec::new();
    // The clock is too coarse for a single small face.
    let times = 1 + 10_000 / points.len();
    let mut work = || {
        for _ in 0..times {
            triangles.clear();
            triangulator.polygon(black_box(&points), &ends, &mut triangles);
        }
    };
    let [best] = fastest(0.5, [&mut work]);
    assert_eq!(triangles.len(), points.len() + 2 * ends.len() - 4, "{name}");
    let sum: f64 = triangles.iter().map(|t| area(&t.map(|i| points[i as usize])).abs()).sum();
    let expected: f64 = polygon.iter().map(|ring| area(ring)).sum();
    assert!((sum - expected).abs() <= 1e-9 * expected, "{name}: area {sum}, not {expected}");
    let corners = points.len();
    let each = nanoseconds_each(best, times * corners);
    table.row(name, &[number(each, 1), corners.to_string(), number(each * corners as f64 / 1e3, 2)]);
}

fn sink<S: Sink>(table: &mut Table, name: &str, shape: &Shape, mut sink: S) -> S {
    let start = Instant::now();
    Plain::default().run(shape, &Settings::default(), &mut sink).expect("no limit is reached");
    table.row(name, &[number(start.elapsed().as_secs_f64() * 1e3, 1)]);
    sink
}

/// The work of which instructions are counted.
fn works() -> Vec<Work> {
    let polygons: [(&str, Polygon); 5] = [
        ("quad", vec![ring(4, |_| 1.0)]),
        ("concave 8-gon", vec![ring(8, |i| 1.0 + (i % 2) as f64)]),
        ("comb", comb(10_000, |_| 0.0)),
        ("star", vec![ring(10_000, |i| 1.0 + mixed(i))]),
        ("windows", windows(50)),
    ];
    let of = |(name, polygon): (&str, Polygon)| {
        Work::new(name, move || {
            let (points, ends) = flat(&polygon);
            let (mut triangulator, mut triangles) = (Triangulator::new(), Vec::new());
            (points.len(), move || {
                triangles.clear();
                triangulator.polygon(black_box(&points), &ends, &mut triangles);
            })
        })
    };
    polygons.into_iter().map(of).collect()
}

fn main() {
    if counted("Triangles of faces", "corner", &works()) {
        return;
    }
    let mut table = Table::new("Triangles of faces", &["face", "ns a corner", "corners", "us"]);
    let square = [(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0)].map(DVec2::from).to_vec();
    let hole = [(1.0, 1.0), (1.0, 2.0), (2.0, 2.0), (2.0, 1.0)].map(DVec2::from).to_vec();
    row(&mut table, "quad", &vec![square.clone()]);
    row(&mut table, "quad with a hole", &vec![square, hole]);
    row(&mut table, "concave 8-gon", &vec![ring(8, |i| 1.0 + (i % 2) as f64)]);
    row(&mut table, "concave 100-gon", &vec![ring(100, |i| 0.5 + mixed(i))]);
    for corners in [1_000, 10_000, 100_000, 1_000_000] {
        row(&mut table, "comb", &comb(corners, |_| 0.0));
        row(&mut table, "comb without order", &comb(corners, mixed));
        row(&mut table, "star", &vec![ring(corners, |i| 0.5 + mixed(i))]);
        row(&mut table, "windows", &windows(((corners / 4) as f64).sqrt() as usize));
    }
    let outline: Vec<_> = comb(1_000_000, |_| 0.0).concat().iter().map(|p| p.extend(0.0)).collect();
    table.print();

    let mut table = Table::new("A face of a million corners", &["step", "ms"]);
    let start = Instant::now();
    let shape = Shape::mesh(Mesh::from_polygon(&outline, &[]).expect("a face"));
    table.row("mesh", &[number(start.elapsed().as_secs_f64() * 1e3, 1)]);
    let buffers = sink(&mut table, "buffers", &shape, Buffers::new());
    assert_eq!(buffers.triangle_count(), outline.len() - 2);
    let glb = sink(&mut table, "GLB", &shape, Glb::new());
    assert!(glb.into_bytes().expect("it fits").len() > 12 * outline.len());
    sink(&mut table, "OBJ", &shape, Obj::new(Vec::new(), "a.mtl"));
    table.print();
}
