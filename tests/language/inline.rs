//! *Rule inlining*: `inline` with leaves that are appended.

use cga::glam::DVec3;
use cga::{Color, Error, LimitKind, Limits, Model, Settings, Shape, cga};

use crate::{clean, leaves, lines, sum, written};

cga! {
    grammar Inlined = r##"
    # The examples of the page, as far as they run.
    @StartRule
    Topology -->
        primitiveCube
        print("start: " + geometry.nVertices)
        inline comp(f) { all: SetColor }
        print("inline: " + geometry.nVertices)
    rampValue = comp.index/comp.total
    SetColor -->
        set(material.opacity, 0.9)
        color(colorRamp("spectrum", rampValue))

    @StartRule
    Concept --> inline Volumes Colorize
    Colorize --> color(1,1,0) Yellow.
    Volumes --> split(x) { '0.5: A | '0.5: B }
    A --> split(z) { '0.5: Sphere | '0.5: Cone }
    B --> split(z) { '0.5: Cylinder | '0.5: Cone }
    Sphere --> primitiveSphere
    Cylinder --> primitiveCylinder
    Cone --> primitiveCone

    # One leaf is taken as it is.
    attr kept = 1
    @StartRule
    Single --> inline Only print(kept) print(scope.sx) print(scope.ry) print(split.index) X.
    Only --> split(x) { '0.5 : set(kept, 2) r(0, 30, 0) color("#ff0000") Y. | ~1 : NIL }

    # Attributes that leaves have in common, and others.
    @StartRule
    Common --> inline { set(kept, 5) split(x) { '0.5 : Y. | ~1 : Z. } } print(kept) X.
    @StartRule
    Differing --> color("#00ff00") inline split(x) { '0.5 : set(kept, 3) color("#ff0000") Y. | ~1 : Z. } print(kept) X.
    @StartRule
    Nothing --> inline split(x) { 1 : NIL }* print(geometry.area) print(scope.sx) X.

    # Edges and points.
    @StartRule
    Edges --> inline comp(e) { all : E. } print(geometry.nEdges) print(geometry.nFaces) print(scope.sx) X.
    @StartRule
    Points --> inline { scatter(scope, 5, uniform) { P. } } print(geometry.nVertices) X.

    # Nested, with arguments, and behind changes of the shape.
    @StartRule
    Nested --> s('2, '1, '1) inline Outer(3) comp(f) { all : Face. }
    Outer(n) --> case n == 0 : Y. else : inline { Part(n) t(0, 1, 0) Outer(n - 1) } Z.
    Part(n) --> s('1, n, '1) primitiveCube

    # Later steps read what inlined rules have reported.
    @StartRule
    Seeds --> inline { X. } report("a", rand(1)) inline { report("b", rand(1)) X. } Y(1)
    Y(_n) --> report("c", rand(1)) Z.
    "##;
}

fn run(rule: &str) -> Model {
    let settings = Settings { start: Some(rule.to_owned()), ..Settings::default() };
    clean(Inlined::default().generate_with(&Shape::rectangle(20.0, 10.0), &settings).expect("a model"))
}

#[test]
fn appended_faces_share_no_vertices() {
    let model = run("Topology");
    assert_eq!(written(&model), ["\"start: 8\"", "\"inline: 24\""]);
    let [leaf] = &model.leaves().collect::<Vec<_>>()[..] else { panic!("{:?}", leaves(&model)) };
    // Each face has the material of its leaf.
    let colors = leaf.mesh().0.material_list().len();
    assert_eq!((leaf.mesh().0.face_count(), colors), (6, 6));
}

#[test]
fn an_inlined_rule_is_an_operation() {
    let model = run("Concept");
    assert_eq!(leaves(&model), ["Yellow"]);
    let leaf = model.leaves().next().expect("a leaf");
    assert_eq!(leaf.material().color(), Color::new(1.0, 1.0, 0.0));
    assert_eq!((leaf.scope().size.x, leaf.scope().size.z), (20.0, 10.0));
}

#[test]
fn a_single_leaf_is_taken_as_it_is() {
    let model = run("Single");
    assert_eq!(lines(&model), ["2", "10", "30", "-1"]);
    let leaf = model.leaves().next().expect("a leaf");
    assert_eq!((leaf.rule(), leaf.material().color(), leaf.area()), ("X", Color::new(1.0, 0.0, 0.0), 100.0));
}

#[test]
fn attributes_of_all_leaves_are_taken() {
    assert_eq!(lines(&run("Common")), ["5"]);
}

#[test]
fn different_materials_are_written_to_the_faces() {
    let model = run("Differing");
    assert_eq!(lines(&model), ["1"]);
    let leaf = model.leaves().next().expect("a leaf");
    let (mesh, _) = leaf.mesh();
    let color = |face: usize| mesh.materials::<cga::Material>()[mesh.face(face).tag().material as usize].color();
    assert_eq!([color(0), color(1)], [Color::new(1.0, 0.0, 0.0), Color::new(0.0, 1.0, 0.0)]);
    assert_eq!((leaf.area(), leaf.scope().size), (200.0, DVec3::new(20.0, 0.0, 10.0)));
}

#[test]
fn without_leaves_nothing_is_left() {
    let model = run("Nothing");
    assert_eq!((lines(&model), leaves(&model).len()), (vec!["0".to_owned(), "20".to_owned()], 0));
}

#[test]
fn edges_and_points_are_joined_too() {
    assert_eq!(lines(&run("Edges")), ["4", "0", "20"]);
    assert_eq!(lines(&run("Points")), ["5"]);
}

#[test]
fn inlined_rules_may_be_nested() {
    let model = run("Nested");
    // Three cubes of 6 faces, and the lot itself.
    assert_eq!(model.count("Face"), 3 * 6 + 1);
}

#[test]
fn seeds_do_not_depend_on_the_leaves_of_the_inlined_rule() {
    let model = run("Seeds");
    let [a, b, c] = ["a", "b", "c"].map(|key| sum(&model, key).expect("a report"));
    assert!(a != b && b != c && c != a, "{a} {b} {c}");
}

#[test]
fn leaves_of_inlined_rules_count_for_the_limits() {
    cga! { grammar Many = r#"Lot --> inline split(x) { 0.001 : X. }* Y."#; }
    let lot = Shape::rectangle(20.0, 10.0);
    let ends = |limits: Limits| {
        let settings = Settings { limits, ..Settings::default() };
        match Many::default().generate_with(&lot, &settings) {
            Err(Error::Limit { what, .. }) => Some(what),
            _ => None,
        }
    };
    assert_eq!(ends(Limits::default()), None);
    assert_eq!(ends(Limits { shapes: 1000, ..Limits::default() }), Some(LimitKind::Shapes));
    assert_eq!(ends(Limits { waiting: 1000, ..Limits::default() }), Some(LimitKind::Waiting));
    assert_eq!(ends(Limits { vertices: 1000, ..Limits::default() }), Some(LimitKind::Vertices));
}
