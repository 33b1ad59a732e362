//! Operations that change meshes, together with others: recomposition, normals, templates.

use cga::glam::DVec3;
use cga::sink::buffers::Buffers;
use cga::{Model, Repeats, Settings, Shape, cga};

cga! {
    grammar Operations = r##"
    @StartRule
    Apart --> primitiveSphere(24, 12) inline(append) comp(f) { all : X. } setNormals(soft) X.
    @StartRule
    Merged --> primitiveSphere(24, 12) inline(append) comp(f) { all : X. } cleanupGeometry(vertices, 0) setNormals(soft) X.
    @StartRule
    Divided --> inline(append) split(x) { 0.7 : split(y) { 1.1 : X. | ~1 : X. } | ~1 : X. } cleanupGeometry(all, 0) X.
    @StartRule
    Joined --> inline(append) split(x) { { 1.5 : X. }* } cleanupGeometry(all, 0) X.
    @StartRule
    Rows --> split(x) { { 0.5 : cleanupGeometry(all, 0.1) X. }* }
    @StartRule
    Reduced --> split(x) { { 1.5 : reduceGeometry(0.25) X. }* }
    @StartRule
    Rectified --> split(x) { { 1.5 : rectify(20) X. }* }
    @StartRule
    Smooth --> split(x) { { 1.5 : setNormals(soft) X. }* }
    @StartRule
    Edited --> modify(f) { top : tag("a") split(x) { ~1 : X. | ~1 : X. } } cleanupGeometry(all, 0) comp(f) { isTagged("a") : A. | all : B. }
    # Parts that change are connected again, as far as their points are left.
    @StartRule
    Inside --> inline(recompose) comp(f) { top : cleanupGeometry(all, 1) X. | all : reduceGeometry(0.25) rectify(10) setNormals(conform) X. } X.
    @StartRule
    InsideRound --> primitiveSphere(24, 12) modify(f) { all : cleanupGeometry(all, 0.3) X. } cleanupGeometry(all, 0.01) X.
    "##;
}

fn shape() -> Shape {
    Shape::cuboid(6.0, 4.0, 2.0)
}

fn run(rule: &str, shape: &Shape, repeats: Repeats) -> Model {
    let settings = Settings { repeats, start: Some(rule.into()), ..Settings::default() };
    let model = Operations::default().generate_with(shape, &settings).expect("a model");
    assert!(model.faults().is_empty(), "{rule}: {:?}", model.faults());
    model
}

fn model(rule: &str) -> Model {
    run(rule, &shape(), Repeats::Kept)
}

/// "The soft and auto modes require disconnected shapes to be combined and duplicate vertices to be merged" (*setNormals
/// operation*).
#[test]
fn normals_are_smooth_where_vertices_are_merged() {
    let centre = DVec3::new(3.0, 2.0, 1.0);
    for (rule, points, is_smooth) in [("Apart", 24 * 10 * 4 + 24 * 2 * 3, false), ("Merged", 24 * 11 + 2, true)] {
        let model = model(rule);
        let (mesh, _) = model.leaves().next().expect("a leaf").mesh();
        assert_eq!((mesh.points().len(), mesh.is_closed()), (points, is_smooth), "{rule}");
        assert_eq!(mesh.normals().len(), if is_smooth { mesh.corners().len() } else { 0 });
        for (corner, normal) in mesh.corners().iter().zip(mesh.normals()) {
            let outwards = (mesh.points()[*corner as usize] - centre) / DVec3::new(9.0, 4.0, 1.0);
            assert!(0.97 < outwards.normalize().dot(*normal), "{normal}");
        }
    }
}

#[test]
fn parts_that_touch_become_one_body() {
    // Four boxes in a row, whose walls between them vanish.
    let joined = model("Joined");
    let (mesh, _) = joined.leaves().next().expect("a leaf").mesh();
    assert_eq!((mesh.face_count(), mesh.points().len(), mesh.volume()), (6, 8, 48.0));
    // Faces with other tags stay divided from those without, and the halves of the top are one again.
    let edited = model("Edited");
    assert_eq!(["A", "B"].map(|rule| edited.count(rule)), [1, 5]);
}

#[test]
fn results_do_not_depend_on_templates_or_boxes() {
    for rule in ["Divided", "Joined", "Rows", "Reduced", "Rectified", "Smooth", "Edited", "Inside", "InsideRound"] {
        let vertices = |shape: &Shape, repeats: Repeats| {
            let mut buffers = Buffers::new();
            assert!(run(rule, shape, repeats).replay(&mut buffers).is_continue());
            buffers.vertices().to_vec()
        };
        let expected = vertices(&shape(), Repeats::Kept);
        assert!(!expected.is_empty());
        let meshes = shape().held_as_meshes();
        for (shape, repeats) in [(shape(), Repeats::Again), (shape(), Repeats::Direct), (meshes, Repeats::Kept)] {
            let found = vertices(&shape, repeats);
            assert_eq!(found.len(), expected.len(), "{rule}");
            for (a, b) in found.iter().flatten().zip(expected.iter().flatten()) {
                assert!((a - b).abs() < 1e-5, "{rule} {repeats:?}: {a} {b}");
            }
        }
    }
}
