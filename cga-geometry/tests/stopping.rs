//! Operations that take each face alone end between faces.

use std::cell::Cell;
use std::rc::Rc;

use cga_geometry::along_uv::{AlongUv, HeightAlignment, HeightDirection, insert_along_uv};
use cga_geometry::extrude::{Extrude, extrude};
use cga_geometry::mesh::Mesh;
use cga_geometry::offset::{OffsetFaces, offset};
use cga_geometry::primitive;
use cga_geometry::work::Supervisor;

/// The faces of the result, and the number of questions, of an operation that is to end at a question.
fn run(operation: &dyn Fn(&Mesh) -> Mesh, sphere: &Mesh, most: u32) -> (usize, u32) {
    let left = Rc::new(Cell::new(most));
    let count = left.clone();
    let _supervisor = Supervisor::new(move |_| {
        count.set(count.get() - 1);
        count.get() != 0
    });
    (operation(sphere).face_count(), most - left.get())
}

#[test]
fn operations_on_many_faces_ask_and_end() {
    let (sphere, cube) = (primitive::sphere(200, 100), primitive::cube());
    let along = AlongUv {
        set: 0,
        height: 1.0,
        direction: HeightDirection::ScopeY,
        alignment: HeightAlignment::AlignPosition,
        rounding: 0.0,
    };
    let operations: [&dyn Fn(&Mesh) -> Mesh; 4] = [
        &|mesh| extrude(mesh, Extrude::FaceNormal, 0.1),
        &|mesh| extrude(mesh, Extrude::VertexNormal, 0.1),
        &|mesh| offset(mesh, -1e-4, OffsetFaces::All).0,
        &|mesh| insert_along_uv(mesh, &cube, &along, 10_000_000).expect("no limit"),
    ];
    for (number, operation) in operations.into_iter().enumerate() {
        let (faces, questions) = run(operation, &sphere, u32::MAX);
        assert!(0 < faces && 20 < questions, "{number}: {faces} faces, {questions} questions");
        for most in [1, 2, questions / 2] {
            assert_eq!(run(operation, &sphere, most), (0, most), "{number}");
        }
    }
}
