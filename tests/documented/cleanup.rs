//! *cleanupGeometry operation*, and the examples of other pages that clean up.

use std::sync::Arc;

use cga::{Mesh, Model, Settings, Shape};

use cga_tests::pages::cleanup as pages;
use cga_tests::pages::example::Example;

fn model(example: &Example) -> Model {
    let model = example.model(&Settings::default());
    assert!(model.faults().is_empty(), "{}: {:?}", example.title, model.faults());
    model
}

/// The mesh of the first leaf.
fn mesh(example: &Example) -> Arc<Mesh> {
    let model = model(example);
    let (mesh, _) = model.leaves().next().expect("a leaf").mesh();
    assert_eq!(mesh.check(), [], "{}", example.title);
    mesh
}

fn counts(mesh: &Mesh) -> [usize; 2] {
    [mesh.face_count(), mesh.points().len()]
}

/// "Mild cleanup removes most disturbing edges." "Increasing the tolerance gets rid of the remaining nasty edges."
#[test]
fn triangles_of_a_house_become_its_walls() {
    let [before, mild, more] =
        [pages::house::EXAMPLE, pages::house_0::EXAMPLE, pages::house_0_1::EXAMPLE].map(|example| mesh(&example));
    assert_eq!(counts(&before), [156, 80]);
    // The bends of the roof stay.
    assert_eq!(counts(&mild), [9, 14]);
    assert_eq!(counts(&more), [7, 10]);
    for made in [&mild, &more] {
        assert!(made.is_closed());
    }
    assert!((mild.volume() - before.volume()).abs() < 1e-9);
    assert!((more.volume() - (30.0 + 9.0) * 10.0).abs() < 1e-9);
}

/// "Tagged edges and edges between coplanar faces with different tags are kept."
#[test]
fn borders_of_an_offset_merge_where_their_edges_have_no_tags() {
    let [kept, merged] = [pages::kept::EXAMPLE, pages::merged::EXAMPLE].map(|example| model(&example));
    let counts = |model: &Model| ["FaceA", "FaceB", "Face"].map(|rule| model.count(rule));
    assert_eq!(counts(&kept), [4, 2, 1]);
    assert_eq!(counts(&merged), [1, 1, 1]);
    let area = |model: &Model, rule: &str| model.leaves_of(rule).map(|leaf| leaf.area()).sum::<f64>();
    for rule in ["FaceA", "FaceB", "Face"] {
        assert!((area(&kept, rule) - area(&merged, rule)).abs() < 1e-9);
    }
    // The mitres with the tags of vertices are gone, except where the two faces meet.
    let uprights = |model: &Model| ["UprightA", "UprightB"].map(|rule| model.count(rule));
    assert_eq!((uprights(&kept), uprights(&merged)), ([3, 1], [0, 0]));
}

#[test]
fn a_recomposed_split_becomes_one_polygon() {
    let f = mesh(&pages::f_shape::EXAMPLE);
    assert_eq!((counts(&f), f.area()), ([1, 10], 600.0));
}

/// "Merge the yellow and green faces and tag the edges." "The edge tags from Step 2 are automatically propagated to the new faces."
#[test]
fn a_layout_is_edited_with_its_tags() {
    let tagged = model(&pages::layout_2::EXAMPLE);
    let count = |rule: &str| tagged.count(rule);
    assert_eq!(["Yellow", "Blue", "Green"].map(count), [0, 1, 1]);
    assert_eq!(["YellowEdge", "BlueEdge", "GreenEdge"].map(count), [3, 5, 4]);
    let built = model(&pages::layout_3::EXAMPLE);
    // Three walls of the house, and three borders of the yard.
    assert_eq!(["Yellow", "Blue", "Green"].map(|rule| built.count(rule)), [6, 7, 5]);
}

#[test]
fn walls_between_outsets_are_merged() {
    let model = model(&pages::outsets::EXAMPLE);
    assert_eq!(["Blue", "Green"].map(|rule| model.count(rule)), [6, 3]);
    let (walls, _) = model.leaves_of("White").next().expect("walls").mesh();
    // The outsets are in front of the house, as in both pictures: three trapezoids of 2 m and 1 m, 0.75 m deep.
    let area: f64 =
        ["White", "Blue", "Green"].map(|rule| model.leaves_of(rule).map(|leaf| leaf.area()).sum()).iter().sum();
    let floor = 8.0 * 12.0 + 3.0 * 0.75 * (2.02 + 1.0) / 2.0;
    let around = 2.0 * 8.0 + 12.0 + (12.0 - 3.0 * 2.02) + 3.0 * (1.0 + 2.0 * libm::hypot(0.51, 0.75));
    assert!((area - (2.0 * floor + 3.0 * around)).abs() < 1e-6, "{area}");
    assert!((model.bounds().low.x - (5.0 - 0.75)).abs() < 1e-9, "{}", model.bounds().low);
    // The top, the bottom, three sides, and four walls beside the outsets.
    assert_eq!(walls.face_count(), 9);
    // A lot that is one metre wider. The building is 3 m high: its volume is 334.19, and 313.81 if the outsets go into the house.
    let wider = (pages::outsets::EXAMPLE.run)(&Shape::rectangle(14.0, 12.0), &Settings::default()).expect("a facade");
    let (walls, placement) = wider.leaves_of("White").next().expect("walls").mesh();
    let walls = walls.map(&placement);
    let ground: f64 = walls.faces().filter(|face| face.normal().y < -0.5).map(|face| face.area()).sum();
    assert!((3.0 * ground - 3.0 * (9.0 * 12.0 + 3.0 * 0.75 * (2.02 + 1.0) / 2.0)).abs() < 1e-6, "{ground}");
}

/// "Each iteration splits every edge into three parts and collapses the last segment."
#[test]
fn corners_are_cut_again_and_again() {
    let smooth = mesh(&pages::smooth::EXAMPLE);
    assert_eq!(counts(&smooth), [1, (18 + 4) * 8]);
    assert_eq!(smooth.face(0).holes().len(), 1);
}
