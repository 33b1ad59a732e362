//! The order of faces and vertices, which `comp` counts and sinks keep. A box is numbered as the mesh that it stands for;
//! `tests/laws` compares the two in random programs.

use cga::glam::DVec3;
use cga::{Grammar, Model, Shape, cga};

use super::{mesh, run};

cga! {
    @Allow(rule_not_reached)
    grammar Order = r#"
    @StartRule
    Cube --> primitiveCube() X.
    CubeFaces --> primitiveCube() comp(f) { all : X. }
    CubeVertices --> primitiveCube() comp(v) { all : s(0.1, 0.1, 0.1) primitiveCube() X. }
    OldCube --> i("builtin:cube") X.
    Extruded --> extrude(3) X.
    ExtrudedFaces --> extrude(3) comp(f) { all : X. }
    Storeys --> extrude(3) split(y) { ~1 : Faces | ~1 : Faces | ~1 : Faces }
    Bays --> extrude(3) split(x) { ~1 : Faces | ~1 : Faces }
    Faces --> comp(f) { all : X. }
    Halves --> split(x) { ~1 : Vertices | ~1 : Vertices }
    Vertices --> comp(v) { all : s(0.1, 0.1, 0.1) primitiveCube() X. }
    "#;
}

const UP: DVec3 = DVec3::Y;
const DOWN: DVec3 = DVec3::NEG_Y;
const FRONT: DVec3 = DVec3::Z;
const BACK: DVec3 = DVec3::NEG_Z;
const RIGHT: DVec3 = DVec3::X;
const LEFT: DVec3 = DVec3::NEG_X;

fn model(start: &str, shape: &Shape) -> Model {
    run(&Order::default() as &dyn Grammar, start, shape)
}

/// Where the leaves look.
fn normals(model: &Model) -> Vec<DVec3> {
    model.leaves().map(|leaf| leaf.scope().axes.z_axis + 0.0).collect()
}

/// Vertices in the world and faces as numbers of vertices, of the only leaf.
fn numbers(model: &Model) -> (Vec<[f64; 3]>, Vec<Vec<u32>>) {
    let leaf = model.leaves().next().expect("a leaf");
    let (mesh, placement) = leaf.mesh();
    let points = mesh.points().iter().map(|&point| placement.transform_point3(point).to_array()).collect();
    (points, mesh.faces().map(|face| face.outer().to_vec()).collect())
}

#[test]
fn a_cube_is_bottom_top_front_right_back_left() {
    let cube = Shape::cuboid(1.0, 1.0, 1.0);
    for start in ["Cube", "OldCube"] {
        let (points, faces) = numbers(&model(start, &cube));
        let floor = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 0.0, 1.0], [0.0, 0.0, 1.0]];
        assert_eq!(points[..4], floor);
        assert_eq!(points[4..], floor.map(|[x, _, z]| [x, 1.0, z]));
        assert_eq!(faces[..3], [[0, 1, 2, 3], [7, 6, 5, 4], [3, 2, 6, 7]]);
        assert_eq!(faces[3..], [[2, 1, 5, 6], [1, 0, 4, 5], [0, 3, 7, 4]]);
    }
    assert_eq!(normals(&model("CubeFaces", &cube)), [DOWN, UP, FRONT, RIGHT, BACK, LEFT]);
}

#[test]
fn an_extruded_lot_is_bottom_top_and_the_sides_from_the_first_edge_on() {
    let lot = Shape::rectangle(4.0, 5.0);
    let (points, faces) = numbers(&model("Extruded", &lot));
    let outline = [[0.0, 0.0, 5.0], [4.0, 0.0, 5.0], [4.0, 0.0, 0.0], [0.0, 0.0, 0.0]];
    assert_eq!(points[..4], outline);
    assert_eq!(points[4..], outline.map(|[x, _, z]| [x, 3.0, z]));
    assert_eq!(faces[..3], [[1, 0, 3, 2], [4, 5, 6, 7], [0, 1, 5, 4]]);
    assert_eq!(faces[3..], [[1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]]);
    assert_eq!(normals(&model("ExtrudedFaces", &lot)), [DOWN, UP, FRONT, RIGHT, BACK, LEFT]);
}

#[test]
fn the_bottom_keeps_the_first_edge_of_the_lot_reversed() {
    // A corner more, on the last edge, makes the second lot a mesh.
    let corners = [[0.0, 0.0, 5.0], [4.0, 0.0, 5.0], [4.0, 0.0, 0.0], [0.0, 0.0, 0.0], [0.0, 0.0, 2.0]];
    let lots = [Shape::rectangle(4.0, 5.0), Shape::mesh(mesh(&corners, &[&[0, 1, 2, 3, 4]]))];
    for lot in lots {
        let model = model("ExtrudedFaces", &lot);
        let bottom = model.leaves().next().expect("the bottom");
        assert_eq!(bottom.scope().origin, DVec3::new(4.0, 0.0, 5.0));
        assert_eq!((bottom.scope().axes.x_axis, bottom.scope().axes.z_axis), (LEFT, DOWN));
    }
}

#[test]
fn faces_of_parts_are_where_the_cut_puts_them() {
    // *CGA changelog 2025.1*: a part without anything of the first face begins with the cap.
    let sides = [FRONT, RIGHT, BACK, LEFT];
    let storeys: [&[DVec3]; 3] = [&[DOWN], &[DOWN], &[DOWN, UP]];
    let tops: [&[DVec3]; 3] = [&[UP], &[UP], &[]];
    let expected = storeys.iter().zip(tops).flat_map(|(first, last)| [first, &sides[..], last].concat());
    let lot = Shape::rectangle(4.0, 5.0);
    assert_eq!(normals(&model("Storeys", &lot)), expected.collect::<Vec<_>>());
    let [left, right] = [[DOWN, UP, FRONT, BACK, LEFT, RIGHT], [DOWN, UP, FRONT, RIGHT, BACK, LEFT]];
    assert_eq!(normals(&model("Bays", &lot)), [left, right].concat());
}

#[test]
fn vertices_of_parts_are_numbered_as_those_of_the_mesh() {
    let places = |model: &Model| model.leaves().map(|leaf| leaf.scope().origin.to_array()).collect::<Vec<_>>();
    let lot = Shape::rectangle(4.0, 2.0);
    let halves = places(&model("Halves", &lot));
    assert_eq!(halves, places(&model("Halves", &lot.clone().held_as_meshes())));
    // Vertices of the lot come before vertices of the cut.
    assert_eq!(halves[..4], [[0.0, 0.0, 2.0], [0.0, 0.0, 0.0], [2.0, 0.0, 2.0], [2.0, 0.0, 0.0]]);
    assert_eq!(places(&model("CubeVertices", &lot.at([1.0, 0.0, 0.0])))[1], [5.0, 0.0, 0.0]);
}

#[test]
fn sinks_keep_the_order_of_faces_and_vertices() {
    let model = model("Extruded", &Shape::rectangle(4.0, 5.0));
    let (obj, _) = model.to_obj("box.mtl");
    let faces: Vec<&str> = obj.lines().filter(|line| line.starts_with("f ")).collect();
    assert_eq!(faces, ["f 2 1 4 3", "f 5 6 7 8", "f 1 2 6 5", "f 2 3 7 6", "f 3 4 8 7", "f 4 1 5 8"]);
    let first = obj.lines().find(|line| line.starts_with("v ")).expect("a vertex");
    assert_eq!(first, "v 0 0 5");
    let mut buffers = cga::sink::buffers::Buffers::new();
    let _ = model.replay(&mut buffers);
    let normals: Vec<&[f32]> = buffers.vertices().chunks(4).map(|face| &face[0][3..]).collect();
    assert_eq!(normals[..2], [[0.0, -1.0, 0.0], [0.0, 1.0, 0.0]]);
    assert_eq!(buffers.vertices()[0][..3], [4.0, 0.0, 5.0]);
}
