//! Scope, pivot and geometry of the parts.

use std::f64::consts::SQRT_2;

use cga::glam::DVec3;
use cga::{Model, Shape, cga};

use super::values;

/// The area of a regular octagon that is four metres across.
const OCTAGON: f64 = 32.0 * (SQRT_2 - 1.0);

cga! {
    grammar Parts = r#"
    @StartRule Low  --> split(x) { 2 : A. | ~1 : B. }
    @StartRule Adj  --> split(x) { ~1 : A. | ~1 : B. | ~1 : C. }
    @StartRule NoAdj --> split(x, noAdjust) { ~1 : A. | ~1 : B. | ~1 : C. }
    @StartRule Tiles --> split(x, noAdjust) { ~1 : split(z, noAdjust) { ~1 : print("area " + scope.sx * scope.sz) A. }* }*
    @StartRule Drum --> primitiveCylinder(8) split(y) { ~1 : split(x) { '0.25 : A. | ~1 : B. | '0.25 : C. } }
    @StartRule Negative --> s('-1, '1, '-1) split(x) { 2 : A. | ~1 : B. } split(z) { 1 : C. }
    @StartRule NegativeMesh --> primitiveCylinder(8) s('-1, '1, '1) split(x) { '0.25 : A. | ~1 : B. }
    @StartRule Across --> split(y) { 1 : A. | ~1 : B. }
    @StartRule Thick --> s('1, 3, '1) split(y) { 1 : A. | ~1 : B. }
    @StartRule ThickOpen --> s('1, 3, '1) split(y, noAdjust) { 1 : A. | ~1 : B. }
    @StartRule Turned --> r(0, 90, 0) t(1, 0, 0) split(z) { 1 : r(0, 45, 0) A. | ~1 : B. }
    @StartRule Gap --> split(x) { 2.5 : print("wide " + scope.sx) print("faces " + geometry.nFaces) A. }*
    @StartRule GapOpen --> split(x, noAdjust) { 2.5 : print("wide " + scope.sx) print("faces " + geometry.nFaces) A. }*
    @StartRule Fill --> split(x) { 2.5 : primitiveCube() A. }*

    @StartRule Wire --> split(x) { 1 : Piece | ~1 : Piece }
    @StartRule WireAcross --> split(y) { ~1 : NIL } Piece
    @StartRule WireThick --> s('1, 2, '1) split(y) { 1 : Piece }*
    Piece --> print("at " + scope.tx) print("long " + scope.sx) print("high " + scope.sy)
        print("edges " + geometry.nEdges) print("ends " + geometry.nVertices) NIL
    @StartRule Dot --> s(3, 0, 0) split(x) { 1 : Piece }*
    "#;
}

fn run(rule: &str, shape: &Shape) -> Model {
    let model = Parts::default().generate_from(rule, shape).unwrap();
    assert!(model.faults().is_empty(), "{rule}: {:?}", model.faults());
    model
}

/// Rule, low corner and size of each leaf's scope.
fn scopes(model: &Model) -> Vec<(&str, [f64; 3], [f64; 3])> {
    model.leaves().map(|leaf| (leaf.rule(), leaf.scope().origin.to_array(), leaf.size().to_array())).collect()
}

/// Two squares of 2, 6 metres apart: nothing in the middle.
fn two_squares() -> Shape {
    let mut builder = cga::MeshBuilder::new();
    for x in [0.0, 8.0] {
        let corners = [[x, 0.0, 2.0], [x + 2.0, 0.0, 2.0], [x + 2.0, 0.0, 0.0], [x, 0.0, 0.0]];
        let face = corners.map(|corner| builder.point(corner));
        builder.face(&face, &[], cga::mesh::FaceTag::PLAIN);
    }
    Shape::mesh(builder.build().unwrap())
}

/// A U, open to the back: 6 wide, 4 deep, arms of 1 and a base of 1.
fn u() -> Shape {
    let outline = [[0.0, 4.0], [6.0, 4.0], [6.0, 0.0], [5.0, 0.0], [5.0, 3.0], [1.0, 3.0], [1.0, 0.0], [0.0, 0.0]];
    Shape::footprint(&outline, &[]).unwrap()
}

/// *split operation*: pivot and orientation stay, and the scope is the slot.
#[test]
fn a_part_has_its_slot_as_scope_and_the_pivot_of_the_whole() {
    let shape = Shape::cuboid(5.0, 3.0, 2.0).at([1.0, 1.0, 1.0]);
    let model = run("Low", &shape);
    assert_eq!(scopes(&model), [("A", [1.0; 3], [2.0, 3.0, 2.0]), ("B", [3.0, 1.0, 1.0], [3.0, 3.0, 2.0])]);
    // Turned by 90 degrees about the corner, one along the new x axis, and cut along the new z axis.
    let model = run("Turned", &Shape::cuboid(5.0, 3.0, 2.0));
    let [a, b] = [0, 1].map(|at| model.leaves().nth(at).unwrap().scope());
    let near = |a: DVec3, b: [f64; 3]| (a - DVec3::from_array(b)).length() < 1e-12;
    assert!(near(a.origin, [0.0, 0.0, -1.0]) && near(b.origin, [1.0, 0.0, -1.0]), "{a:?} {b:?}");
    assert!(near(b.axes.x_axis, [0.0, 0.0, -1.0]) && a.size == DVec3::new(5.0, 3.0, 1.0), "{a:?} {b:?}");
}

/// *splitArea operation*: the pictures of adjust and noAdjust.
#[test]
fn adjusted_scopes_are_bounding_boxes_and_others_tile_the_parent() {
    let model = run("Adj", &u());
    assert_eq!(
        scopes(&model).iter().map(|leaf| leaf.2).collect::<Vec<_>>(),
        [[2.0, 0.0, 4.0], [2.0, 0.0, 1.0], [2.0, 0.0, 4.0]]
    );
    assert_eq!(scopes(&model)[1].1, [2.0, 0.0, 3.0]);
    for leaf in model.leaves() {
        assert_eq!((leaf.bounds().low, leaf.bounds().size()), (leaf.scope().origin, leaf.size()));
    }
    let model = run("NoAdj", &u());
    assert_eq!(
        scopes(&model),
        [
            ("A", [0.0; 3], [2.0, 0.0, 4.0]),
            ("B", [2.0, 0.0, 0.0], [2.0, 0.0, 4.0]),
            ("C", [4.0, 0.0, 0.0], [2.0, 0.0, 4.0])
        ]
    );
    assert_eq!(model.leaves().nth(1).unwrap().bounds().low.z, 3.0, "the geometry stays where it is");
    // 24 tiles of a square metre, twelve of them with geometry.
    let model = run("Tiles", &u());
    assert_eq!(
        (values(&model, "area"), model.len(), model.area()),
        (vec![1.0; 24], 12, 12.0),
        "no gaps, nothing twice"
    );
}

#[test]
fn a_cut_cylinder_shrinks_to_what_is_left_of_it() {
    // Eight sides, one of them in front: the corners at the left are cut off at 45 degrees.
    let model = run("Drum", &Shape::cuboid(4.0, 1.0, 4.0));
    let depths: Vec<f64> = model.leaves().map(|leaf| leaf.size().z).collect();
    let at_quarter = 4.0 * SQRT_2 - 2.0;
    assert!((depths[0] - at_quarter).abs() < 1e-12 && (depths[2] - at_quarter).abs() < 1e-12, "{depths:?}");
    assert_eq!(depths[1], 4.0);
    assert!((model.volume() - OCTAGON).abs() < 1e-12);
}

/// A negative size runs the other way from the scope's origin, and so do the parts.
#[test]
fn a_mirrored_scope_is_split_from_its_origin() {
    let model = run("Negative", &Shape::cuboid(5.0, 1.0, 3.0));
    assert_eq!(
        scopes(&model),
        [
            ("A", [0.0; 3], [-2.0, 1.0, -3.0]),
            ("B", [-2.0, 0.0, 0.0], [-3.0, 1.0, -3.0]),
            ("C", [0.0; 3], [-5.0, 1.0, -1.0])
        ]
    );
    let model = run("NegativeMesh", &Shape::cuboid(4.0, 1.0, 4.0));
    let [a, b] = [0, 1].map(|at| model.leaves().nth(at).unwrap());
    assert_eq!((a.bounds().low.x, a.bounds().high.x, b.bounds().low.x), (-1.0, 0.0, -4.0));
    let quarter = 4.0 * SQRT_2 - 3.0;
    assert!((a.volume().abs() - quarter).abs() < 1e-12 && (b.volume().abs() - OCTAGON + quarter).abs() < 1e-12);
}

/// Where there is no extent there is nothing to divide: the shape stays, and is a leaf.
#[test]
fn without_an_extent_along_the_axis_the_shape_stays_whole() {
    let model = run("Across", &Shape::rectangle(3.0, 2.0));
    assert_eq!(scopes(&model), [("Across", [0.0; 3], [3.0, 0.0, 2.0])]);
}

/// A face in a scope that `s` has made thick: it stands at the low end, and the other slots are empty.
#[test]
fn a_face_in_a_thick_scope_is_in_the_first_part() {
    let model = run("Thick", &Shape::rectangle(3.0, 2.0));
    assert_eq!(scopes(&model), [("A", [0.0; 3], [3.0, 0.0, 2.0])], "shrunk to the face");
    let model = run("ThickOpen", &Shape::rectangle(3.0, 2.0));
    assert_eq!(scopes(&model), [("A", [0.0; 3], [3.0, 1.0, 2.0])], "as thick as its slot");
}

/// Inferred: see `Parts::geometry`.
#[test]
fn a_slot_without_geometry_is_a_part_without_geometry() {
    for rule in ["Gap", "GapOpen"] {
        let model = run(rule, &two_squares());
        assert_eq!(values(&model, "faces"), [1.0, 0.0, 0.0, 1.0], "{rule}: the two in the middle are empty");
        let edge = if rule == "Gap" { 2.0 } else { 2.5 };
        assert_eq!(values(&model, "wide"), [edge, 2.5, 2.5, edge]);
        assert_eq!(model.leaves().count(), 2, "{rule}: nothing to be seen in the middle");
    }
    let model = run("Fill", &two_squares());
    let places: Vec<f64> = model.leaves().map(|leaf| leaf.scope().origin.x).collect();
    assert_eq!(places, [0.0, 2.5, 5.0, 8.0]);
}

/// Since 2025.0 edges and vertices can be split (*CGA changelog*).
#[test]
fn edge_and_vertex_shapes_are_split() {
    let line = Shape::line([1.0, 2.0, 3.0], [1.0, 2.0, -1.0]).unwrap();
    let model = run("Wire", &line);
    assert_eq!(values(&model, "at"), [0.0, 1.0], "from the pivot, along the line");
    assert_eq!(values(&model, "long"), [1.0, 3.0]);
    assert_eq!((values(&model, "edges"), values(&model, "ends")), (vec![1.0; 2], vec![2.0; 2]));
    // It has no extent across: nothing is made, and the line goes on.
    assert_eq!(values(&run("WireAcross", &line), "long"), [4.0]);
    let model = run("WireThick", &line);
    assert_eq!(values(&model, "high"), [0.0, 1.0], "the line is in the low part, and that shrinks to it");
    assert_eq!(values(&model, "edges"), [1.0, 0.0]);
    let model = run("Dot", &Shape::point([1.0, 2.0, 3.0]));
    assert_eq!((values(&model, "ends"), values(&model, "edges")), (vec![1.0, 0.0, 0.0], vec![0.0; 3]));
    assert_eq!(values(&model, "long"), [0.0, 1.0, 1.0]);
    for to in [[1.0, 2.0, 3.0], [f64::NAN; 3], [1e200, 1e200, 0.0], [1.0, 2.0, f64::INFINITY]] {
        assert!(Shape::line([1.0, 2.0, 3.0], to).is_err(), "{to:?}");
    }
    assert!(Shape::line([0.0; 3], [1e-200, 0.0, 0.0]).is_err(), "as long as nothing");
    assert!(Parts::default().generate_from("Dot", &Shape::point([f64::NAN; 3])).is_err());
}

#[test]
fn the_axes_of_a_line_are_as_upright_as_it_lets_them_be() {
    for to in
        [[3.0, 0.0, 0.0], [0.0, 0.0, -2.0], [1.0, 2.0, 3.0], [0.0, 4.0, 0.0], [0.0, -4.0, 0.0], [-1e-9, 1.0, 1e-9]]
    {
        let line = Shape::line([0.0; 3], to).unwrap();
        let (axes, size) = (line.scope().axes, line.scope().size);
        assert!((axes.transpose() * axes).abs_diff_eq(cga::glam::DMat3::IDENTITY, 1e-12), "{to:?}: {axes}");
        assert!((axes.determinant() - 1.0).abs() < 1e-12, "{to:?}: right-handed");
        assert!((axes.x_axis * size.x - DVec3::from_array(to)).length() < 1e-12, "{to:?}");
        assert!(axes.z_axis.y.abs() < 1e-12, "{to:?}: z is level");
        assert!(to[1].abs() == 4.0 || 0.0 < axes.y_axis.y, "{to:?}: y is up");
    }
}
