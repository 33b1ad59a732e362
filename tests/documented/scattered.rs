//! *scatter operation*.

use cga::glam::DVec3;
use cga::{Model, Settings, Shape, cga};

use cga_tests::pages::scattering;

/// The positions of the points of an example, relative to the initial scope: shares of its size.
fn shares(number: usize) -> Vec<DVec3> {
    let example = scattering::ALL[number];
    let (model, start) = (example.model(&Settings::default()), (example.start)());
    assert_eq!(model.leaves().len(), 100);
    let outline = start.to_mesh();
    // The outline is convex and has one face.
    let inside = |at: DVec3| {
        let corners: Vec<DVec3> = outline.corners().iter().map(|point| outline.points()[*point as usize]).collect();
        let is_left = |edge: usize| {
            let (a, b) = (corners[edge], corners[(edge + 1) % corners.len()]);
            0.0 <= (b - a).cross(at - a).y
        };
        (0..corners.len()).all(is_left)
    };
    let scope = *start.scope();
    let share = |leaf: cga::LeafView<'_>| {
        let at = scope.frame().to_local(leaf.scope().origin);
        assert!(inside(at) && (leaf.size() - DVec3::new(0.2, 0.3, 0.1)).length() < 1e-12, "{at}");
        at / DVec3 { y: 1.0, ..scope.size }
    };
    model.leaves().map(share).collect()
}

fn mean(points: &[DVec3]) -> DVec3 {
    points.iter().sum::<DVec3>() / points.len() as f64
}

#[test]
fn all_points_are_on_the_outline() {
    let [uniform, gaussian, left] = [0, 1, 2].map(shares);
    let spread = |points: &[DVec3]| points.iter().map(|at| (*at - mean(points)).length_squared()).sum::<f64>() / 100.0;
    assert!(spread(&left) < spread(&gaussian) && spread(&gaussian) < spread(&uniform));
    // Deviations of 0.16 and 0.1 along both axes, cut off by the outline.
    assert!((mean(&gaussian) - DVec3::new(0.5, 0.0, 0.5)).length() < 0.08, "{}", mean(&gaussian));
    assert!(mean(&left).x < 0.3 && (mean(&left).z - 0.5).abs() < 0.2, "{}", mean(&left));
}

cga! {
    grammar Strewn = r##"
    @StartRule
    Points --> scatter(surface, 20, uniform) { print(scope.sx + scope.sy + scope.sz) print(geometry.nVertices) Point. }
    @StartRule
    OnFaces --> extrude(5) scatter(surface, 40, uniform) { primitiveCube s(1, 0.1, 1) center(xz) Mark }
    Mark --> case comp.index == -1 : X. else : Y.
    @StartRule
    Inside --> extrude(5) scatter(volume, 40, gaussian) { primitiveCube s(0.1, 0.1, 0.1) X. }
    @StartRule
    Differ --> scatter(scope, 2, uniform) { Put } scatter(scope, 2, uniform) { Put }
    Put --> report("draw", rand(1)) primitiveCube X.
    "##;
}

fn run(rule: &str) -> Model {
    let model = Strewn::default().generate_from(rule, &Shape::rectangle(10.0, 8.0)).expect("a model");
    assert!(model.faults().is_empty(), "{:?}", model.faults());
    model
}

/// "The children shape's scope sizes are set to 0", "geometry only contains one vertex".
#[test]
fn points_are_vertices_without_extent() {
    let printed: Vec<String> = run("Points").prints().iter().map(|line| line.value.to_string()).collect();
    assert_eq!(printed, ["0", "1"].repeat(20));
}

#[test]
fn marks_lie_on_the_faces() {
    let model = run("OnFaces");
    assert_eq!(model.count("X"), 40);
    for leaf in model.leaves() {
        let up = leaf.scope().axes.y_axis;
        assert_eq!(up.abs().max_element(), 1.0);
        let foot = leaf.scope().frame().to_world(DVec3::new(0.5, 0.0, 0.5)) * up;
        let side = up * DVec3::new(10.0, 5.0, 8.0).max(DVec3::ZERO);
        assert!((foot - side.max(DVec3::ZERO)).length() < 1e-9, "{foot}");
    }
}

#[test]
fn gaussian_points_fill_the_volume() {
    let model = run("Inside");
    let origins: Vec<DVec3> = model.leaves().map(|leaf| leaf.scope().origin).collect();
    assert_eq!(origins.len(), 40);
    assert!(origins.iter().all(|at| 0.0 < at.y && at.y < 5.0));
    assert!((mean(&origins).y - 2.5).abs() < 0.5);
}

/// Every point has a seed of its own, and so has each use of the operation.
#[test]
fn points_draw_their_own_numbers() {
    let model = run("Differ");
    let places: Vec<DVec3> = model.leaves().map(|leaf| leaf.scope().origin).collect();
    assert!((1..4).all(|at| !places[..at].contains(&places[at])));
    assert_eq!(model.reported("draw").map(|it| it.summary().count), Some(4));
}

/// Rules with findings of the codes `no_faces` and `selector_hidden`: the run makes nothing there either.
#[test]
fn points_have_vertices_alone_and_faces_of_footprints_look_up() {
    cga! { grammar Found = r#"
        @Allow(no_faces)
        @StartRule
        Points --> scatter(surface, 3, uniform) { Parts s(1, 2, 3) Parts comp(v) { all : primitiveCube() Vertex. } }
        @Allow(no_faces)
        Parts -->
            comp(f) { all : A. } comp(e) { all : A. } comp(fe) { all : A. } comp(h) { all : A. }
            setback(0.1) { all : A. | remainder : A. } shapeO(1, 1, 1, 1) { shape : A. | remainder : A. }
            innerRectangle(scope) { shape : A. | remainder : A. }
            splitAndSetbackPerimeter(0) { 1 : 1 : A. }* { remainder : A. }
        @Allow(selector_hidden)
        @StartRule
        Ground --> footprint() comp(f) { side : A. | bottom : A. | nutant : A. | aslant : A. | top : Top. } NIL
        @Allow(too_many_pieces)
        @StartRule
        Many --> splitAndSetbackPerimeter(0) { '0.00199 : 1 : A. }* { remainder : Rest. }
    "#; }
    let rules = |rule: &str, shape: &Shape| {
        let model = Found::default().generate_from(rule, shape).expect("no limit");
        let mut rules: Vec<&str> = model.leaves().map(|leaf| leaf.rule()).collect();
        rules.dedup();
        (rules.join(" "), model.len(), model.faults().len())
    };
    for shape in
        [Shape::cuboid(4.0, 5.0, 6.0), Shape::rectangle(8.0, 9.0), Shape::cuboid(4.0, 5.0, 6.0).held_as_meshes()]
    {
        assert_eq!(rules("Points", &shape), ("Vertex".into(), 3, 0));
        assert_eq!(rules("Ground", &shape), ("Top".into(), 1, 0));
    }
    let lot = Shape::rectangle(90.0, 80.0);
    // More than 500 sections make none.
    assert_eq!(rules("Many", &lot), ("Rest".into(), 1, 1));
}
