//! The component split: a large mesh by direction, boxes, whose faces need no mesh, and small meshes.
//!
//! `cargo bench --bench comp`, with `-- --instructions` instructions instead of times. It compares the grammar with a hand-written loop that computes each face's normal and
//! adds the face to the list of its direction.

mod common;

use std::f64::consts::{PI, TAU};
use std::hint::black_box;
use std::sync::Arc;
use std::time::Duration;

use cga::glam::{DAffine3, DVec3};
use cga::sink::buffers::Buffers;
use cga::{Cuboid, Flow, Leaf, Mesh, Quad, Repeats, Settings, Shape, Sink, cga};
use cga_runtime::geometry::mesh::MeshBuilder;
use common::clock::{fastest, nanoseconds_each};
use common::instructions::{Work, counted};
use common::table::{Table, number};

cga! {
    /// Every face as a shape.
    grammar Each;
    Ball --> comp(f) { top : Top. | side : Side. | all : Rest. }
}

cga! {
    /// All faces of a direction as one shape.
    grammar Together;
    Ball --> comp(f) { top = Top. | side = Side. | all = Rest. }
}

cga! {
    /// Rows of boxes, and the faces of each.
    grammar Boxes;
    attr n = 1000
    Row --> split(x) { ~(scope.sx / n) : comp(f) { front : Front. | side : Side. | all : Rest. } }*
}

cga! {
    /// The same, with a test of every face's width. The test never passes.
    grammar Asked;
    attr n = 1000
    Row --> split(x) { ~(scope.sx / n) : comp(f) { front : Face | side : Face | all : Face } }*
    Face --> case scope.sx > 2 : Wide. else : NIL
}

cga! {
    /// Rows of boxes that leave nothing.
    grammar Nothing;
    attr n = 1000
    Row --> split(x) { ~(scope.sx / n) : Box }*
    Box --> case scope.sx > 2 : Wide. else : NIL
}

cga! {
    /// Rows of boxes as leaves.
    grammar Whole;
    attr n = 1000
    Row --> split(x) { ~(scope.sx / n) : Box. }*
}

cga! {
    /// Rows of cylinders, and the faces of each: rectangles around two disks.
    grammar Cylinders;
    attr n = 1000
    Row --> split(x) { ~(scope.sx / n) : primitiveCylinder(12) comp(f) { top : Top. | side : Side. | all : Rest. } }*
}

cga! {
    /// Rows of spheres, and the faces of each: triangles and trapezoids.
    grammar Spheres;
    attr n = 1000
    Row --> split(x) { ~(scope.sx / n) : primitiveSphere(12, 6) comp(f) { top : Top. | side : Side. | all : Rest. } }*
}

/// Counts its faces.
#[derive(Default)]
struct Count(usize);

impl Sink for Count {
    fn quad(&mut self, _: &Leaf<'_>, quad: &Quad) -> Flow {
        self.0 += usize::from(black_box(quad).u != DVec3::ZERO);
        Flow::Continue(())
    }

    fn cuboid(&mut self, _: &Leaf<'_>, cuboid: &Cuboid) -> Flow {
        self.0 += usize::from(black_box(cuboid).origin.is_finite());
        Flow::Continue(())
    }

    fn mesh(&mut self, _: &Leaf<'_>, mesh: &Arc<Mesh>, _: &DAffine3) -> Flow {
        self.0 += mesh.face_count();
        Flow::Continue(())
    }
}

/// A ball of triangles.
fn ball(rows: u32) -> Mesh {
    let around = 2 * rows;
    let mut builder = MeshBuilder::new();
    for j in 0..=rows {
        for i in 0..around {
            let (turn, rise) = (TAU * f64::from(i) / f64::from(around), PI * f64::from(j) / f64::from(rows));
            let r = if j == 0 || j == rows { 0.0 } else { libm::sin(rise) };
            builder.point([r * libm::cos(turn), -libm::cos(rise), -r * libm::sin(turn)]);
        }
    }
    let at = |i: u32, j: u32| j * around + i % around;
    for j in 0..rows {
        for i in 0..around {
            let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
            if j != 0 {
                builder.polygon(&[a, b, c]);
            }
            if j != rows - 1 {
                builder.polygon(&[a, c, d]);
            }
        }
    }
    builder.build().expect("a ball")
}

/// Computes each face's normal and makes a list for each direction.
fn by_hand(mesh: &Mesh) -> [Vec<u32>; 3] {
    let mut lists = [Vec::new(), Vec::new(), Vec::new()];
    for face in mesh.faces() {
        let outline = face.outer();
        let at = |i: usize| mesh.points()[outline[i] as usize];
        let (a, b, c) = (at(0), at(1), at(2));
        let normal = (b - a).cross(c - a).normalize();
        let list = if normal.x.abs().max(normal.z.abs()) < normal.y { 0 } else { 1 + usize::from(0.98 < -normal.y) };
        lists[list].push(face.index() as u32);
    }
    lists
}

/// The seconds for which each row is repeated.
const SECONDS: f64 = 0.7;

/// The work of which instructions are counted.
fn works() -> Vec<Work> {
    let ball_work = |name: &str, is_each: bool| {
        Work::new(name, move || {
            let (mesh, settings) = (ball(50), Settings::default());
            let (faces, shape) = (mesh.face_count(), Shape::mesh_axis_aligned(mesh));
            (faces, move || {
                let mut sink = Count::default();
                let report = match is_each {
                    true => Each::default().run(&shape, &settings, &mut sink),
                    false => Together::default().run(&shape, &settings, &mut sink),
                };
                drop(report.expect("no error"));
            })
        })
    };
    let boxes = Work::new("faces of boxes", || {
        let settings = Settings { repeats: Repeats::Direct, ..Settings::default() };
        let row = Shape::cuboid(1000.0, 1.0, 1.0);
        (6000, move || drop(Boxes::default().run(&row, &settings, &mut Count::default()).expect("no error")))
    });
    let buffers = Work::new("each, in buffers", || {
        let (mesh, settings) = (ball(50), Settings::default());
        let (faces, shape) = (mesh.face_count(), Shape::mesh_axis_aligned(mesh));
        (faces, move || {
            let mut sink = Buffers::new();
            drop(Each::default().run(&shape, &settings, &mut sink).expect("no error"));
            assert_eq!(sink.triangle_count(), faces);
        })
    });
    let small = |name: &str, each: usize, run: fn(&Shape, &Settings) -> usize| {
        Work::new(name, move || {
            let settings = Settings { repeats: Repeats::Direct, ..Settings::default() };
            let row = Shape::cuboid(1000.0, 1.0, 1.0);
            (each * 1000, move || assert_eq!(run(&row, &settings), each * 1000))
        })
    };
    let cylinders = small("faces of cylinders", 14, |row, settings| {
        let mut sink = Count::default();
        drop(Cylinders::default().run(row, settings, &mut sink).expect("no error"));
        sink.0
    });
    let spheres = small("faces of spheres", 72, |row, settings| {
        let mut sink = Count::default();
        drop(Spheres::default().run(row, settings, &mut sink).expect("no error"));
        sink.0
    });
    vec![ball_work("together", false), ball_work("each", true), buffers, boxes, cylinders, spheres]
}

fn main() {
    if counted("Components", "face", &works()) {
        return;
    }
    balls();
    boxes();
}

fn balls() {
    let settings = Settings::default();
    let columns =
        ["ball", "together / by hand", "each / by hand", "faces", "by hand, ns a face", "together, ns", "each, ns"];
    let mut table = Table::new("Components of a mesh", &columns);
    for rows in [50, 158, 500] {
        let mesh = ball(rows);
        let faces = mesh.face_count();
        let shape = Shape::mesh_axis_aligned(mesh.clone());
        let run = |work: &dyn Fn(&mut Count)| {
            let mut sink = Count::default();
            work(&mut sink);
            assert_eq!(sink.0, faces);
        };
        let best = fastest(
            SECONDS,
            [
                &mut || _ = black_box(by_hand(black_box(&mesh))),
                &mut || run(&|sink| drop(Together::default().run(&shape, &settings, sink).expect("no error"))),
                &mut || run(&|sink| drop(Each::default().run(&shape, &settings, sink).expect("no error"))),
            ],
        );
        let [hand, together, each] = best.map(|time| nanoseconds_each(time, faces));
        let ratios = [together / hand, each / hand].map(|ratio| number(ratio, 2));
        let times = [hand, together, each].map(|time| number(time, 1));
        table.row(&format!("{rows} rows"), &[&ratios[..], &[faces.to_string()], &times].concat());
    }
    table.print();
}

fn boxes() {
    // With templates, a box would cost no more than its leaves, independent of its rule.
    let settings = Settings { repeats: Repeats::Direct, ..Settings::default() };
    let row = Shape::cuboid(1000.0, 1.0, 1.0);
    let run = |expected: usize, work: &dyn Fn(&mut Count)| {
        let mut sink = Count::default();
        work(&mut sink);
        assert_eq!(sink.0, expected);
    };
    let [boxes, whole, asked, nothing]: [Duration; 4] = fastest(
        SECONDS,
        [
            &mut || run(6000, &|sink| drop(Boxes::default().run(&row, &settings, sink).expect("no error"))),
            &mut || run(1000, &|sink| drop(Whole::default().run(&row, &settings, sink).expect("no error"))),
            &mut || run(0, &|sink| drop(Asked::default().run(&row, &settings, sink).expect("no error"))),
            &mut || run(0, &|sink| drop(Nothing::default().run(&row, &settings, sink).expect("no error"))),
        ],
    );
    let mut table = Table::new("Components of a box", &["all six faces", "ns a box"]);
    let each = |more: Duration, less: Duration| [number(nanoseconds_each(more.saturating_sub(less), 1000), 0)];
    table.row("asked for their width", &each(asked, nothing));
    table.row("handed out", &each(boxes, whole));
    table.print();
}
