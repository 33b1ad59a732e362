//! Workload C: closed meshes cut into closed pieces, with caps.
//!
//! `cargo bench --bench cutting`, with `-- --instructions` instructions instead of times. It compares the grammar, the cutter alone, and a copy of their output. Volumes and
//! areas are checked against formulas, areas of caps against the sum over the edges in which faces meet the planes.

mod common;
#[path = "../cga-geometry/tests/cutting/cut_support/section.rs"]
mod section;

use std::f64::consts::{PI, TAU};
use std::hint::black_box;
use std::sync::Arc;
use std::time::{Duration, Instant};

use cga::glam::{DAffine3, DVec3};
use cga::{Cuboid, Flow, Leaf, Mesh, Quad, Settings, Shape, Sink, cga};
use cga_runtime::geometry::Axis;
use cga_runtime::geometry::cut;
use cga_runtime::geometry::mesh::{FaceTag, MeshBuilder};
use common::instructions::{Work, counted};
use common::table::{Table, number};
use section::section;

cga! {
    /// Equal slices along x.
    grammar Slices;

    attr n = 4
    Lot --> split(x) { ~(scope.sx / n) : Slice. }*
}

cga! {
    /// Equal slices along z.
    grammar Rings;

    attr n = 4
    Lot --> split(z) { ~(scope.sz / n) : Slice. }*
}

/// The meshes of all leaves.
#[derive(Default)]
struct Keep(Vec<Arc<Mesh>>);

impl Sink for Keep {
    fn quad(&mut self, _: &Leaf<'_>, _: &Quad) -> Flow {
        Flow::Continue(())
    }

    fn cuboid(&mut self, _: &Leaf<'_>, _: &Cuboid) -> Flow {
        Flow::Continue(())
    }

    fn mesh(&mut self, _: &Leaf<'_>, mesh: &Arc<Mesh>, _: &DAffine3) -> Flow {
        self.0.push(mesh.clone());
        Flow::Continue(())
    }
}

/// A cylinder along x: sides, then the two ends.
fn cylinder(sides: u32) -> Mesh {
    let mut builder = MeshBuilder::new();
    for x in [0.0, 10.0] {
        for i in 0..sides {
            let angle = f64::from(i) * TAU / f64::from(sides);
            builder.point([x, 0.5 + 0.5 * libm::cos(angle), 0.5 + 0.5 * libm::sin(angle)]);
        }
    }
    for i in 0..sides {
        let j = (i + 1) % sides;
        builder.face(&[i, j, sides + j, sides + i], &[], FaceTag::PLAIN);
    }
    for end in [(0..sides).rev().collect::<Vec<_>>(), (sides..2 * sides).collect()] {
        builder.polygon(&end);
    }
    builder.build().expect("a cylinder")
}

/// A torus around z; radii 1 and 0.4.
fn torus(around: u32, across: u32) -> Mesh {
    let mut builder = MeshBuilder::new();
    for u in 0..around {
        for v in 0..across {
            let [a, b] = [(u, around), (v, across)].map(|(i, of)| f64::from(i) * TAU / f64::from(of));
            let r = 1.0 + 0.4 * libm::cos(b);
            builder.point([1.4 + r * libm::cos(a), 1.4 + r * libm::sin(a), 0.4 + 0.4 * libm::sin(b)]);
        }
    }
    for u in 0..around {
        for v in 0..across {
            let at = |u: u32, v: u32| u % around * across + v % across;
            builder.face(&[at(u, v), at(u + 1, v), at(u + 1, v + 1), at(u, v + 1)], &[], FaceTag::PLAIN);
        }
    }
    builder.build().expect("a torus")
}

/// Upright tubes of 1 by 1 at random places, which overlap: one for each unit of the ground. The walls are 0.05
/// thick.
fn overlapping_tubes(count: u32) -> Mesh {
    let mut builder = MeshBuilder::new();
    let (mut seed, side) = (1u32, f64::from(count).sqrt());
    let mut noise = || {
        seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        f64::from(seed) / f64::from(u32::MAX)
    };
    for _ in 0..count {
        let (x, y) = (noise() * side, noise() * side);
        let mut ring = |inset: f64, z: f64| {
            [[inset, inset], [1.0 - inset, inset], [1.0 - inset, 1.0 - inset], [inset, 1.0 - inset]]
                .map(|[u, v]| builder.point([x + u, y + v, z]))
        };
        let [outer, inner, upper_outer, upper_inner] =
            [ring(0.0, 0.0), ring(0.05, 0.0), ring(0.0, 1.0), ring(0.05, 1.0)];
        for i in 0..4 {
            let j = (i + 1) % 4;
            builder.polygon(&[outer[i], outer[j], upper_outer[j], upper_outer[i]]);
            builder.polygon(&[inner[j], inner[i], upper_inner[i], upper_inner[j]]);
        }
        let turned = |[a, b, c, d]: [u32; 4]| [d, c, b, a];
        builder.face(&turned(outer), &[&inner], FaceTag::PLAIN);
        builder.face(&upper_outer, &[&turned(upper_inner)], FaceTag::PLAIN);
    }
    builder.build().expect("tubes")
}

/// A section of many loops that cross, half of them holes.
fn overlaps(table: &mut Table, count: u32) {
    let mesh = Arc::new(overlapping_tubes(count));
    let (mut best, mut parts) = (Duration::MAX, Vec::new());
    for _ in 0..3 {
        parts = timed(&mut best, || cut::slabs(&mesh, Axis::Z, black_box(&[0.5])).parts);
    }
    for part in parts.iter().flatten() {
        // Every outline has a cap, and every hole is in a cap.
        let holes = part.faces().filter(|face| face.tag().cap).map(|cap| cap.holes().len());
        assert!(holes.clone().count() == count as usize && holes.sum::<usize>() == count as usize);
        assert!(part.is_closed() && (part.volume() / f64::from(count) - 0.095).abs() < 1e-9);
    }
    let time = best.as_secs_f64();
    let made = triangles(&mesh) + parts.iter().flatten().map(|part| triangles(part)).sum::<usize>();
    table.row(&count.to_string(), &[number(time * 1e9 / made as f64, 1), number(time * 1e6, 1)]);
}

/// The points and corners of all parts, copied one after the other into existing memory.
#[derive(Default)]
struct Copy {
    points: Vec<DVec3>,
    corners: Vec<u32>,
}

impl Copy {
    fn fill(&mut self, parts: &[Arc<Mesh>]) {
        self.points.clear();
        self.corners.clear();
        for part in parts {
            self.points.extend_from_slice(part.points());
            self.corners.extend_from_slice(part.corners());
        }
    }
}

/// The best time so far.
fn timed<T>(best: &mut Duration, work: impl FnOnce() -> T) -> T {
    let start = Instant::now();
    let result = work();
    *best = (*best).min(start.elapsed());
    result
}

/// The number of triangles of all faces of a mesh.
fn triangles(mesh: &Mesh) -> usize {
    let of_face = |(corners, holes): (usize, usize)| corners + 2 * holes - 2;
    mesh.faces()
        .map(|face| (face.outer().len() + face.holes().map(<[u32]>::len).sum::<usize>(), face.holes().len()))
        .map(of_face)
        .sum()
}

/// The sums over all pieces; areas to the four digits of the documents.
struct Documented {
    volume: f64,
    area: f64,
}

/// Cuts a mesh into equal pieces.
fn compare(table: &mut Table, workload: &str, mesh: Mesh, axis: Axis, pieces: usize, documented: Documented) {
    let name = format!("{workload}({pieces})");
    let offsets = offsets(&mesh, axis, pieces);
    let area = mesh.area() + 2.0 * offsets.iter().map(|&at| section(&mesh, axis, at)).sum::<f64>();
    assert!((area - documented.area).abs() < 1e-4, "{name}: area {area}, not {}", documented.area);
    let volume = mesh.volume();
    assert!((volume - documented.volume).abs() < 1e-6, "{name}: volume {volume}, not {}", documented.volume);
    let shape = Shape::mesh_axis_aligned(mesh.clone());
    let mesh = Arc::new(mesh);
    let (slices, rings, settings) = (Slices { n: pieces as f64 }, Rings { n: pieces as f64 }, Settings::default());
    let (mut kept, mut slabs, mut copy) = (Vec::new(), Vec::new(), Copy::default());
    let mut best = [Duration::MAX; 3];
    let begin = Instant::now();
    let mut rounds = 0;
    while rounds < 3 || begin.elapsed().as_secs_f64() < 0.7 {
        kept = timed(&mut best[0], || {
            let mut sink = Keep::default();
            let made = match axis {
                Axis::X => slices.run(&shape, &settings, &mut sink),
                _ => rings.run(&shape, &settings, &mut sink),
            };
            made.expect("no limit is reached");
            sink.0
        });
        slabs = timed(&mut best[1], || cut::slabs(&mesh, axis, black_box(&offsets)).parts);
        timed(&mut best[2], || copy.fill(black_box(&kept)));
        rounds += 1;
    }
    let near = |a: f64, b: f64| (a - b).abs() <= 1e-9 * b;
    for parts in [&kept, &slabs.into_iter().flatten().collect::<Vec<_>>()] {
        assert_eq!(parts.len(), pieces, "{name}");
        assert!(parts.iter().all(|part| part.is_closed()), "{name}");
        let sum = |of: fn(&Mesh) -> f64| parts.iter().map(|part| of(part)).sum::<f64>();
        assert!(near(sum(Mesh::volume), volume), "{name}: volume {}, not {volume}", sum(Mesh::volume));
        assert!(near(sum(Mesh::area), area), "{name}: area {}, not {area}", sum(Mesh::area));
    }
    assert_eq!(copy.points.len(), kept.iter().map(|part| part.points().len()).sum::<usize>());
    let made = triangles(&mesh) + kept.iter().map(|part| triangles(part)).sum::<usize>();
    let [grammar, cutter, copy] = best.map(|time| time.as_secs_f64());
    let cells = [
        number(grammar / copy, 1),
        number(cutter / copy, 1),
        number(grammar * 1e9 / made as f64, 1),
        number(copy * 1e6, 1),
        number(cutter * 1e6, 1),
        number(grammar * 1e6, 1),
    ];
    table.row(&name, &cells);
}

/// The places of the planes that divide a mesh into equal pieces.
fn offsets(mesh: &Mesh, axis: Axis, pieces: usize) -> Vec<f64> {
    let extent = mesh.bounds().size()[axis.index()];
    (1..pieces).map(|i| i as f64 * extent / pieces as f64).collect()
}

/// The work of which instructions are counted.
fn works() -> Vec<Work> {
    let of = |name: &str, mesh: fn() -> Mesh, axis: Axis, pieces: usize| {
        Work::new(&format!("{name}({pieces})"), move || {
            let mesh = Arc::new(mesh());
            let offsets = offsets(&mesh, axis, pieces);
            let parts = cut::slabs(&mesh, axis, &offsets).parts;
            let made = triangles(&mesh) + parts.iter().flatten().map(|part| triangles(part)).sum::<usize>();
            (made, move || drop(black_box(cut::slabs(&mesh, axis, black_box(&offsets)).parts)))
        })
    };
    let (cylinder, torus) = (|| cylinder(64), || torus(64, 32));
    vec![
        of("C1", cylinder, Axis::X, 16),
        of("C1", cylinder, Axis::X, 256),
        of("C2", torus, Axis::X, 4),
        of("C2", torus, Axis::X, 64),
        of("C3", torus, Axis::Z, 4),
        of("C3", torus, Axis::Z, 64),
        of("tubes", || overlapping_tubes(2_000), Axis::Z, 2),
    ]
}

fn main() {
    if counted("Cutting closed meshes", "triangle", &works()) {
        return;
    }
    let columns = [
        "scene(pieces)",
        "grammar / copy",
        "cutter / copy",
        "grammar, ns a triangle in or out",
        "copy, us",
        "cutter, us",
        "grammar, us",
    ];
    let mut table = Table::new("Cutting closed meshes", &columns);
    let sides = 64.0;
    let end = 0.25 * sides / 2.0 * libm::sin(TAU / sides);
    for pieces in [16, 64, 256, 1024] {
        let area = 10.0 * sides * libm::sin(PI / sides) + 2.0 * pieces as f64 * end;
        compare(&mut table, "C1", cylinder(64), Axis::X, pieces, Documented { volume: 10.0 * end, area });
    }
    let volume = 3.132_980_5;
    for (pieces, area) in [(4, 24.0744), (16, 51.2740), (64, 158.9476), (256, 588.6422)] {
        compare(&mut table, "C2", torus(64, 32), Axis::X, pieces, Documented { volume, area });
    }
    for (pieces, area) in [(2, 25.7871), (4, 43.0742), (16, 139.0574), (64, 516.2891), (256, 2020.6795)] {
        compare(&mut table, "C3", torus(64, 32), Axis::Z, pieces, Documented { volume, area });
    }
    table.note("C1 is a cylinder, C2 a torus across its axis, C3 a torus along it, where every cap is a ring.");
    table.print();

    let columns = ["tubes", "cutter, ns a triangle in or out", "cutter, us"];
    let mut table = Table::new("Cutting tubes that overlap", &columns);
    for count in [8_000, 32_000, 128_000] {
        overlaps(&mut table, count);
    }
    table.print();
}
