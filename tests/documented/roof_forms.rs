//! *roofHip, roofGable, roofPyramid, roofShed and roofRidge operations*: scopes, heights, edges and the order of faces.

use cga::glam::DVec3;
use cga::{Mesh, MeshBuilder, Model, Shape, cga};

cga! {
    grammar Forms = r##"
    attr n = 0
    attr a = 30

    # Arguments that are left out.
    @StartRule
    Hip --> [ roofHip(45) Roof. ] roofHip(byAngle, 45, 0, false) Roof.
    @StartRule
    Gable --> [ roofGable(45) Roof. ] roofGable(byAngle, 45, 0, 0, false) Roof.
    @StartRule
    Pyramid --> [ roofPyramid(45) Roof. ] roofPyramid(byAngle, 45) Roof.
    @StartRule
    Shed --> [ roofShed(45) Roof. ] roofShed(byAngle, 45, 0) Roof.

    @StartRule
    Turned --> rotateScope(0, 30, 0) roofHip(45) Roof.
    @StartRule
    High --> roofHip(byHeight, 4, 1) Roof.
    @StartRule
    HighGable --> roofGable(byHeight, 4, 1) Roof.
    @StartRule
    FromEdge --> roofShed(a, n) comp(f) { isTagged("roof.top") : Top. }
    @StartRule
    Between --> roofRidge(byAngle, 45) comp(f) { isTagged("roof.top") = Top. | isTagged("roof.side.inner") : Inner. }
    @StartRule
    Verges --> roofGable(30, 2, 1) comp(f) { isTagged("roof.side") : Side. }
    @StartRule
    ShedEaves --> roofShed(30) comp(e) { eave : Bar("eave") | ridge : Bar("ridge") | hip : Bar("hip") }
    Bar(name) --> s('1, 0.1, 0.1) primitiveCube() print(name) Bar.
    @StartRule
    Back --> roofGable(30, 0, -1) comp(f) { isTagged("roof.top") : Top. | isTagged("roof.side") : Side. | isTagged("roof.bottom") : Bottom. }
    @StartRule
    Inside --> roofHip(30, -1) comp(f) { isTagged("roof.top") : Top. | isTagged("roof.bottom") : Bottom. }
    @StartRule
    Two --> roofHip(45) comp(f) { all : Face. }
    "##;
}

fn outline(points: &[[f64; 2]]) -> Shape {
    Shape::footprint(points, &[]).expect("an outline")
}

fn rectangle() -> Shape {
    outline(&[[0.0, 0.0], [10.0, 0.0], [10.0, -8.0], [0.0, -8.0]])
}

fn l_lot() -> Shape {
    outline(&[[0.0, 0.0], [4.0, 0.0], [4.0, -6.0], [10.0, -6.0], [10.0, -10.0], [0.0, -10.0]])
}

fn form(grammar: Forms, rule: &str, shape: &Shape) -> Model {
    let model = grammar.generate_from(rule, shape).expect("a model");
    assert!(model.faults().is_empty(), "{:?}", model.faults());
    model
}

/// The corners of the faces of a leaf, in the world.
fn corners(leaf: &cga::LeafView<'_>) -> Vec<DVec3> {
    let (mesh, place) = leaf.mesh();
    mesh.corners().iter().map(|point| place.transform_point3(mesh.points()[*point as usize])).collect()
}

/// A face of a quadrilateral that rises towards the back, by 6 m in 8.
fn slope() -> Shape {
    let ring = [[0.0, 0.0, 0.0], [10.0, 0.0, 0.0], [10.0, 6.0, -8.0], [0.0, 6.0, -8.0]].map(DVec3::from_array);
    Shape::mesh_axis_aligned(Mesh::from_polygon(&ring, &[]).expect("a face"))
}

/// The numbers are angles without a word, and roofs have no overhang without one.
#[test]
fn arguments_that_are_left_out_have_their_defaults() {
    for rule in ["Hip", "Gable", "Pyramid", "Shed"] {
        let model = form(Forms::default(), rule, &rectangle());
        let [short, long] = &model.leaves().collect::<Vec<_>>()[..] else { panic!("{rule}") };
        assert_eq!((corners(short), short.scope()), (corners(long), long.scope()), "{rule}");
    }
}

/// "The y axis is the face normal, the x axis is the old one projected": a square of 10 m on a slope, with a pyramid on it.
#[test]
fn the_scope_of_a_roof_stands_on_the_face() {
    let normal = DVec3::new(0.0, 0.8, 0.6);
    let model = form(Forms::default(), "Hip", &slope());
    let scope = model.leaves().next().expect("a roof").scope();
    let near = |a: DVec3, b: DVec3| assert!((a - b).length() < 1e-9, "{a} {b}");
    near(scope.axes.y_axis, normal);
    near(scope.axes.x_axis, DVec3::X);
    near(scope.axes.z_axis, DVec3::X.cross(normal));
    near(scope.size, DVec3::new(10.0, 5.0, 10.0));
    // The corner with the smallest coordinates: at the back, on the left, at the bottom.
    near(scope.origin, DVec3::new(0.0, 6.0, -8.0));
    let turned = form(Forms::default(), "Turned", &slope());
    let scope = turned.leaves().next().expect("a roof").scope();
    let x = DVec3::new(0.75f64.sqrt(), 0.0, -0.5);
    near(scope.axes.x_axis, (x - normal * x.dot(normal)).normalize());
    near(scope.axes.y_axis, normal);
}

/// The highest point has the height, on the narrow and on the wide end of a trapezoid, and overhangs are below the face.
#[test]
fn a_height_is_that_of_the_highest_point() {
    let trapezoid = outline(&[[0.0, 0.0], [24.0, 0.0], [24.0, -10.0], [0.0, -18.0]]);
    for shape in [trapezoid, l_lot(), rectangle()] {
        for rule in ["High", "HighGable"] {
            let model = form(Forms::default(), rule, &shape);
            let bounds = model.bounds();
            assert!((bounds.high.y - 4.0).abs() < 1e-9 && bounds.low.y < -0.1, "{rule} {bounds:?}");
            // The scope begins where the overhang ends.
            let scope = model.leaves().next().expect("a roof").scope();
            assert!((scope.origin - bounds.low).length() < 1e-9 && (scope.size - bounds.size()).length() < 1e-9);
        }
    }
}

/// The plane rises, or falls, from the chosen edge: each corner is as high as it is far from the edge, times the tangent.
#[test]
fn a_shed_is_low_at_its_edge() {
    let lots = [rectangle(), l_lot(), outline(&[[0.0, 0.0], [9.0, 2.0], [12.0, -7.0], [2.0, -11.0]])];
    for lot in lots {
        let place = lot.scope().frame();
        let ring: Vec<DVec3> = lot.to_mesh().points().iter().map(|at| place.to_world(*at)).collect();
        let count = ring.len();
        for n in 0..count {
            let [from, to] = [ring[n], ring[(n + 1) % count]];
            let inwards = DVec3::Y.cross(to - from).normalize();
            let least = ring.iter().map(|at| (*at - from).dot(inwards)).fold(f64::INFINITY, f64::min);
            let is_lowest = -1e-9 < least;
            for (a, index) in [(30.0, n as f64), (30.0, n as f64 - count as f64), (-20.0, n as f64)] {
                let model = form(Forms { n: index, a }, "FromEdge", &lot);
                let tops: Vec<_> = model.leaves().collect();
                assert_eq!(tops.len(), 1);
                let slope = libm::tan(f64::to_radians(a));
                let found = corners(&tops[0]);
                assert_eq!(found.len(), count, "one polygon, also over a concave face");
                for at in &found {
                    let height = ((*at - from).dot(inwards) - least) * slope;
                    assert!((at.y - height).abs() < 1e-9, "{index} {a}: {at}, not {height}");
                }
                assert!(!is_lowest || found.iter().filter(|at| at.y.abs() < 1e-9).count() >= 2);
                let area = lot.to_mesh().area() / libm::cos(f64::to_radians(a));
                assert!((tops[0].area() - area).abs() < 1e-9);
            }
        }
    }
}

/// The planes begin at the two outermost points across the ridge, half way between which it is.
#[test]
fn a_ridge_is_half_way_between_the_outermost_corners() {
    let lot = outline(&[[0.0, 0.0], [9.0, 2.0], [12.0, -7.0], [6.0, -12.0], [-3.0, -5.0]]);
    let model = form(Forms::default(), "Between", &lot);
    let top = model.leaves_of("Top").next().expect("both planes");
    // The scope's x axis is along the first edge.
    let across = |at: &DVec3| lot.scope().frame().to_local(*at).z;
    let ring = lot.to_mesh();
    let low = ring.points().iter().map(|at| at.z).fold(f64::INFINITY, f64::min);
    let high = ring.points().iter().map(|at| at.z).fold(f64::NEG_INFINITY, f64::max);
    let found = corners(&top);
    for at in &found {
        let height = (across(at) - low).min(high - across(at));
        assert!((at.y - height).abs() < 1e-9, "{at}, not {height}");
    }
    let half = 0.5 * (high - low);
    assert!(found.iter().any(|at| (at.y - half).abs() < 1e-9));
    assert!(found.iter().filter(|at| at.y.abs() < 1e-9).count() == 3, "one outermost edge, and one corner");
}

/// The sides of a courtyard that pass under the ridge have a corner at it.
#[test]
fn sides_under_a_ridge_are_pentagons() {
    let hole = vec![[3.0, -2.0], [7.0, -2.0], [7.0, -6.0], [3.0, -6.0]];
    let yard = Shape::footprint(&[[0.0, 0.0], [10.0, 0.0], [10.0, -8.0], [0.0, -8.0]], &[hole]).expect("a yard");
    let model = form(Forms::default(), "Between", &yard);
    let mut sides: Vec<Vec<DVec3>> = model.leaves_of("Inner").map(|leaf| corners(&leaf)).collect();
    sides.sort_by_key(Vec::len);
    assert_eq!(sides.iter().map(Vec::len).collect::<Vec<_>>(), [4, 4, 5, 5]);
    for side in &sides[2..] {
        assert!(side.iter().any(|at| (*at - DVec3 { y: 4.0, z: -4.0, ..*at }).length() < 1e-9), "{side:?}");
    }
}

/// Overhangs pass in front of the pediments.
#[test]
fn pediments_stay_over_their_edges() {
    let model = form(Forms::default(), "Verges", &rectangle());
    let places: Vec<f64> = model
        .leaves()
        .map(|leaf| {
            let found = corners(&leaf);
            assert!(found.iter().all(|at| (at.x - found[0].x).abs() < 1e-9 && -1e-9 < at.y));
            (found[0].x * 1e6).round() / 1e6
        })
        .collect();
    assert_eq!(places, [10.0, 0.0]);
}

/// The faces over two lots: first the faces of the first lot, in the order of its edges, each with its bottom.
#[test]
fn roof_faces_follow_the_edges_of_all_faces() {
    let mut builder = MeshBuilder::new();
    let mut places = Vec::new();
    for x in [0.0, 20.0] {
        let ring = [[x, 0.0, 0.0], [x + 10.0, 0.0, 0.0], [x + 10.0, 0.0, -8.0], [x, 0.0, -8.0]].map(DVec3::from_array);
        places.extend((0..4).map(|k| [ring[k], ring[(k + 1) % 4]]));
        let points = ring.map(|at| builder.point(at));
        builder.face(&points, &[], cga::mesh::FaceTag::PLAIN);
    }
    let model = form(Forms::default(), "Two", &Shape::mesh(builder.build().expect("two lots")));
    let faces: Vec<Vec<DVec3>> = model.leaves().map(|leaf| corners(&leaf)).collect();
    assert_eq!(faces.len(), 10);
    let tops = faces[..4].iter().chain(&faces[5..9]);
    assert!(tops.zip(&places).all(|(face, edge)| face[..2] == *edge));
    assert!(faces[4].iter().chain(&faces[9]).all(|at| at.y == 0.0));
}

/// A negative overhang takes the planes back: published rules leave the pediments as parapets with `roofGable(angle, 0, -w)`.
#[test]
fn a_negative_overhang_takes_the_planes_back() {
    let cos = libm::cos(30f64.to_radians());
    let model = form(Forms::default(), "Back", &rectangle());
    // The ridge is along the 10 metres; each plane begins and ends a metre behind its pediment.
    let area = |model: &Model, rule: &str| model.leaves_of(rule).map(|leaf| leaf.area()).sum::<f64>();
    assert_eq!(["Top", "Side", "Bottom"].map(|rule| model.count(rule)), [2, 2, 1]);
    assert!((area(&model, "Top") - 8.0 * 8.0 / cos).abs() < 1e-9 && (area(&model, "Bottom") - 80.0).abs() < 1e-9);
    assert!((area(&model, "Side") - 2.0 * 0.5 * 8.0 * 4.0 * libm::tan(30f64.to_radians())).abs() < 1e-9);
    // A metre on the planes is less as seen from above.
    let model = form(Forms::default(), "Inside", &rectangle());
    let (width, depth) = (10.0 - 2.0 * cos, 8.0 - 2.0 * cos);
    assert!((area(&model, "Top") - width * depth / cos).abs() < 1e-9);
    let lowest = corners(&model.leaves_of("Top").next().expect("a plane")).iter().map(|p| p.y).fold(f64::MAX, f64::min);
    assert!((lowest - 0.5).abs() < 1e-9);
}

/// An eave is the low border of a roof (*comp operation*), so a shed has one.
#[test]
fn the_upper_edge_of_a_shed_is_no_eave() {
    let model = form(Forms::default(), "ShedEaves", &rectangle());
    assert_eq!(model.report().prints().iter().map(|print| print.to_string()).collect::<Vec<_>>(), ["eave"]);
}
