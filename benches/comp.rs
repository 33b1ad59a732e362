//! The component split: a large mesh by direction, and boxes, whose faces need no mesh.
//!
//! `cargo bench --bench comp`. Beside each other: the grammar, and a loop by hand that computes each face's normal and sorts
//! the face into a list of its direction.

use std::f64::consts::{PI, TAU};
use std::hint::black_box;
use std::sync::Arc;
use std::time::{Duration, Instant};

use cga::glam::{DAffine3, DVec3};
use cga::{Cuboid, Flow, Leaf, Mesh, Quad, Settings, Shape, Sink, cga};
use cga_runtime::mesh::{FaceTag, MeshBuilder};

cga! {
    /// Every face alone.
    grammar Each;
    Ball --> comp(f) { top : Top. | side : Side. | all : Rest. }
}

cga! {
    /// The faces of a direction together.
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
    /// The same, and every face asked for its width; one that no box has would be handed out.
    grammar Asked;
    attr n = 1000
    Row --> split(x) { ~(scope.sx / n) : comp(f) { front : Face | side : Face | all : Face } }*
    Face --> case scope.sx > 2 : Wide. else : NIL
}

cga! {
    /// Rows of boxes of which nothing is left.
    grammar Nothing;
    attr n = 1000
    Row --> split(x) { ~(scope.sx / n) : Box }*
    Box --> case scope.sx > 2 : Wide. else : NIL
}

cga! {
    /// Rows of boxes that are left alone.
    grammar Whole;
    attr n = 1000
    Row --> split(x) { ~(scope.sx / n) : Box. }*
}

/// Counts the faces it gets.
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
                builder.face(&[a, b, c], &[], FaceTag::PLAIN);
            }
            if j != rows - 1 {
                builder.face(&[a, c, d], &[], FaceTag::PLAIN);
            }
        }
    }
    builder.build().expect("a ball")
}

/// Each face's normal, and a list for each direction.
fn by_hand(mesh: &Mesh) -> [Vec<u32>; 3] {
    let mut lists = [Vec::new(), Vec::new(), Vec::new()];
    for face in mesh.faces() {
        let [a, b, c] = [0, 1, 2].map(|i| mesh.points()[face.outer()[i] as usize]);
        let normal = (b - a).cross(c - a).normalize();
        let list = if normal.x.abs().max(normal.z.abs()) < normal.y { 0 } else { 1 + usize::from(0.98 < -normal.y) };
        lists[list].push(face.index() as u32);
    }
    lists
}

fn best(runs: u32, mut work: impl FnMut()) -> Duration {
    let time = |work: &mut dyn FnMut()| {
        let start = Instant::now();
        work();
        start.elapsed()
    };
    (0..runs).map(|_| time(&mut work)).min().unwrap_or_default()
}

fn main() {
    // `-- box` leaves the balls out.
    if !std::env::args().any(|arg| arg == "box") {
        balls();
    }
    boxes();
}

fn balls() {
    let settings = Settings::default();
    println!("ball, ns a face          faces     by hand   together       each");
    for rows in [50, 158, 500] {
        let mesh = ball(rows);
        let faces = mesh.face_count();
        let shape = Shape::mesh_axis_aligned(mesh.clone());
        let per_face = |time: Duration| time.as_secs_f64() * 1e9 / faces as f64;
        let hand = best(10, || _ = black_box(by_hand(black_box(&mesh))));
        let run = |work: &dyn Fn(&mut Count)| {
            best(10, || {
                let mut sink = Count::default();
                work(&mut sink);
                assert_eq!(sink.0, faces);
            })
        };
        let together = run(&|sink| drop(Together::default().generate_into(&shape, &settings, sink).expect("no error")));
        let each = run(&|sink| drop(Each::default().generate_into(&shape, &settings, sink).expect("no error")));
        println!(
            "                     {faces:9} {:11.1} {:10.1} {:10.1}",
            per_face(hand),
            per_face(together),
            per_face(each)
        );
    }
}

fn boxes() {
    let settings = Settings::default();
    let row = Shape::cuboid(1000.0, 1.0, 1.0);
    let count = |expected: usize, work: &dyn Fn(&mut Count)| {
        best(200, || {
            let mut sink = Count::default();
            work(&mut sink);
            assert_eq!(sink.0, expected);
        })
    };
    let boxes = count(6000, &|sink| drop(Boxes::default().generate_into(&row, &settings, sink).expect("no error")));
    let whole = count(1000, &|sink| drop(Whole::default().generate_into(&row, &settings, sink).expect("no error")));
    let asked = count(0, &|sink| drop(Asked::default().generate_into(&row, &settings, sink).expect("no error")));
    let nothing = count(0, &|sink| drop(Nothing::default().generate_into(&row, &settings, sink).expect("no error")));
    let each = |more: Duration, less: Duration| (more - less).as_secs_f64() * 1e9 / 1000.0;
    println!(
        "box, ns for all six faces: asked for their width {:.0}, handed out {:.0}",
        each(asked, nothing),
        each(boxes, whole)
    );
}
