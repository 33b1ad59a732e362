//! *roofHip, roofGable, roofPyramid, roofShed and roofRidge operations*: numbers that follow from the pages.

use cga::{Model, Settings, Shape, cga};

use cga_tests::pages::example::Example;
use cga_tests::pages::roofs as pages;

cga! {
    @Allow(undefined_rule)
    grammar Roofs = r##"
    attr a = 45
    attr x = 0
    attr y = 0
    attr n = 0
    attr h = 4
    attr even = false
    attr turn = 0

    @StartRule
    Hip --> roofHip(a, x, even) Roof
    @StartRule
    HipHeight --> roofHip(byHeight, h, x, even) Roof
    @StartRule
    Gable --> roofGable(a, x, y, even) Roof
    @StartRule
    GableHeight --> roofGable(byHeight, h, 0, 0, even) Roof
    @StartRule
    GableAlong --> roofGable(a, x, y, even, n) Roof
    @StartRule
    Pyramid --> roofPyramid(a) Roof
    @StartRule
    PyramidHeight --> roofPyramid(byHeight, h) Roof
    @StartRule
    Shed --> roofShed(a, n) Roof
    @StartRule
    ShedHeight --> roofShed(byHeight, h, n) Roof
    @StartRule
    Ridge --> rotateScope(0, turn, 0) roofRidge(byAngle, a) Roof
    @StartRule
    RidgeHeight --> roofRidge(byHeight, h) Roof

    Roof --> [ Whole. ]
             [ comp(f) { all : Face. } ]
             [ comp(f) { isTagged("roof.top") : Top. | isTagged("roof.bottom") : Bottom. | isTagged("roof.side.outer") : Outer.
                       | isTagged("roof.side.inner") : Inner. | isTagged("roof.side") : Side. } ]
             comp(e) { eave : primitiveCube Eave. | hip : primitiveCube Hip_. | valley : primitiveCube Valley. | ridge : primitiveCube Ridge_. }
    "##;
}

fn rectangle() -> Shape {
    outline(&[[0.0, 0.0], [10.0, 0.0], [10.0, -8.0], [0.0, -8.0]])
}

fn outline(points: &[[f64; 2]]) -> Shape {
    Shape::footprint(points, &[]).expect("an outline")
}

fn l_lot() -> Shape {
    outline(&[[0.0, 0.0], [4.0, 0.0], [4.0, -6.0], [10.0, -6.0], [10.0, -10.0], [0.0, -10.0]])
}

fn run(grammar: Roofs, rule: &str, shape: &Shape) -> Model {
    let model = grammar.generate_from(rule, shape).expect("a model");
    assert!(model.faults().is_empty(), "{:?}", model.faults());
    model
}

fn rounded(number: f64) -> f64 {
    (number * 1e3).round() / 1e3
}

/// The areas of the leaves of a rule.
fn areas(model: &Model, rule: &str) -> Vec<f64> {
    model.leaves_of(rule).map(|leaf| rounded(leaf.area())).collect()
}

fn size(model: &Model) -> [f64; 3] {
    let leaf = model.leaves_of("Whole").next().expect("a leaf");
    leaf.scope().size.to_array().map(rounded)
}

fn volume(model: &Model) -> f64 {
    rounded(model.leaves_of("Whole").next().expect("a leaf").volume())
}

fn counts(model: &Model) -> [usize; 4] {
    ["Eave", "Hip_", "Valley", "Ridge_"].map(|rule| model.count(rule))
}

/// *roofHip operation*: a ridge 2 m long and 4 m high.
#[test]
fn a_hip_roof_over_a_rectangle() {
    let model = run(Roofs::default(), "Hip", &rectangle());
    assert_eq!(size(&model), [10.0, 4.0, 8.0]);
    assert_eq!((volume(&model), counts(&model)), (rounded(4.0 * (8.0 * 2.0 / 2.0 + 8.0 * 8.0 / 3.0)), [4, 4, 0, 1]));
    let root = 2f64.sqrt();
    // Each face in the order of its edge, then the bottom.
    assert_eq!(areas(&model, "Face"), [24.0 * root, 16.0 * root, 24.0 * root, 16.0 * root, 80.0].map(rounded));
    assert_eq!((model.count("Top"), areas(&model, "Bottom")), (4, vec![80.0]));
    let same = run(Roofs { h: 4.0, ..Roofs::default() }, "HipHeight", &rectangle());
    assert_eq!((areas(&same, "Face"), size(&same)), (areas(&model, "Face"), size(&model)));
}

/// *roofHip operation*: an exact square has one apex, also with collinear corners.
#[test]
fn a_hip_roof_over_a_square() {
    let model = run(Roofs::default(), "Hip", &outline(&[[0.0, 0.0], [8.0, 0.0], [8.0, -8.0], [0.0, -8.0]]));
    assert_eq!((size(&model), volume(&model)), ([8.0, 4.0, 8.0], rounded(256.0 / 3.0)));
    assert_eq!((model.count("Top"), counts(&model)), (4, [4, 4, 0, 0]));
    let divided = [[0.0, 0.0], [4.0, 0.0], [8.0, 0.0], [8.0, -8.0], [3.0, -8.0], [0.0, -8.0]];
    let model = run(Roofs::default(), "Hip", &outline(&divided));
    assert_eq!((size(&model), volume(&model), model.count("Top")), ([8.0, 4.0, 8.0], rounded(256.0 / 3.0), 6));
}

/// *roofHip operation*: the overhang is measured on the planes, and is part of the faces.
#[test]
fn a_hip_roof_with_an_overhang() {
    let model = run(Roofs { a: 30.0, x: 2.0, ..Roofs::default() }, "Hip", &rectangle());
    assert_eq!(size(&model), [13.464, 3.309, 11.464]);
    assert_eq!((model.count("Face"), model.count("Top"), counts(&model)), (5, 4, [4, 4, 0, 1]));
    let first = model.leaves_of("Face").next().expect("a face");
    // x along the eave, y up the slope.
    assert_eq!([first.scope().size.x, first.scope().size.y].map(rounded), [13.464, rounded(2.0 + 8.0 / 3f64.sqrt())]);
}

/// *roofHip operation*, *roofGable operation*: `even` makes the ridge of a trapezoid level, at the mean of its heights.
#[test]
fn even_makes_ridges_level() {
    let trapezoid = outline(&[[0.0, 0.0], [24.0, 0.0], [24.0, -10.0], [0.0, -18.0]]);
    let ridge = |even: bool, rule: &str, shape: &Shape| {
        let model = run(Roofs { even, ..Roofs::default() }, rule, shape);
        let scope = model.leaves_of("Ridge_").next().expect("a ridge").scope();
        [scope.origin.y, scope.origin.y + scope.axes.x_axis.y * scope.size.x].map(rounded)
    };
    for rule in ["Hip", "Gable"] {
        let uneven = ridge(false, rule, &trapezoid);
        assert!(0.5 < (uneven[0] - uneven[1]).abs(), "{uneven:?}");
        let even = ridge(true, rule, &trapezoid);
        assert!((even[0] - even[1]).abs() < 1e-3 && (even[0] - (uneven[0] + uneven[1]) / 2.0).abs() < 2e-3, "{even:?}");
        assert_eq!(ridge(true, rule, &rectangle()), ridge(false, rule, &rectangle()));
    }
}

/// *roofHip operation*, *roofGable operation*: "There is exactly one roof face per Top shape edge", "the roof faces are non-planar now".
#[test]
fn even_roofs_have_one_face_for_each_edge() {
    let odd = outline(&[[0.0, 0.0], [12.0, 0.0], [12.0, -5.0], [0.0, -9.0]]);
    for x in [0.0, 0.5, -0.5] {
        let model = run(Roofs { x, even: true, ..Roofs::default() }, "Hip", &odd);
        assert_eq!((model.count("Face"), model.count("Top")), (5, 4), "{x}");
        // *comp operation*: eaves are horizontal, also where a negative overhang takes bent faces back.
        assert_eq!(counts(&model), [4, 4, 0, 1], "{x}");
    }
    let model = run(Roofs { even: true, ..Roofs::default() }, "Gable", &odd);
    assert_eq!((model.count("Face"), model.count("Top"), model.count("Side")), (5, 2, 2));

    cga! {
        grammar Even = r##"
        @StartRule
        Whole --> roofHip(45, 0, true) print(geometry.nFaces) print(geometry.nEdges) W.
        @StartRule
        Parts --> roofHip(45, 0, true) split(x) { 3 : split(y) { '0.4 : P. | ~1 : P. } | ~1 : split(z) { 2.5 : P. }* }
        @StartRule
        Turned --> roofHip(45, 0, true) rotateScope(0, 30, 0) split(x) { 3 : P. | ~1 : split(z) { 2.5 : P. }* }
        @StartRule
        Mirrored --> roofHip(45, 0, true) mirror(true, false, false) W.
        @StartRule
        Reversed --> roofHip(45, 0, true) reverseNormals() W.
        @StartRule
        Convex --> roofHip(45, 0, true) convexify() W.
        @StartRule
        Bands --> roofHip(45, 0, true) setupProjection(0, world.xz, 1, 1) projectUV(0) split(u, uvSpace, 0) { 2.5 : P. }*
        @StartRule
        Back --> roofGable(15, 0, -0.3, true) W.
        @StartRule
        Two --> inline(append) { [ roofHip(45, 0, true) W. ] [ r(90, 0, 0) t('3, 0, 0) roofHip(45, 0, true) W. ] } W.
        "##;
    }
    let model = |rule: &str| Even::default().generate_from(rule, &odd).expect("a model");
    let volume = |rule: &str| model(rule).leaves().map(|leaf| leaf.volume()).sum::<f64>();
    let area = |rule: &str| model(rule).leaves().map(|leaf| leaf.area()).sum::<f64>();
    // A face has one surface, whatever way it is turned, beside other roofs, and in all files.
    let whole = (volume("Whole"), area("Whole"));
    for (rule, count, sense) in
        [("Mirrored", 1.0, 1.0), ("Reversed", 1.0, -1.0), ("Convex", 1.0, 1.0), ("Two", 2.0, 1.0)]
    {
        assert!((volume(rule) - sense * count * whole.0).abs() < 1e-9, "{rule}: {} of {}", volume(rule), whole.0);
        assert!((area(rule) - count * whole.1).abs() < 1e-9, "{rule}: {} of {}", area(rule), whole.1);
    }
    assert!(model("Back").faults().is_empty(), "{:?}", model("Back").faults());
    assert!((area("Bands") - whole.1).abs() < 1e-9, "{} of {}", area("Bands"), whole.1);
    let text = model("Whole").to_obj("a.mtl").0;
    // The bottom and the planar faces are polygons, and the two bent ones are two triangles each.
    assert_eq!(text.lines().filter(|line| line.starts_with("f ")).count(), 7);
    assert_eq!(model("Whole").prints().iter().map(|print| print.to_string()).collect::<Vec<_>>(), ["5", "9"]);
    for rule in ["Parts", "Turned"] {
        assert!((volume(rule) - volume("Whole")).abs() < 1e-9, "{rule}: {} of {}", volume(rule), volume("Whole"));
    }
}

/// *roofHip operation*, *roofGable operation*: a height is the height of the highest point, also of a level ridge.
#[test]
fn level_ridges_have_the_height() {
    let trapezoid = outline(&[[0.0, 0.0], [24.0, 0.0], [24.0, -10.0], [0.0, -18.0]]);
    for rule in ["HipHeight", "GableHeight"] {
        for even in [false, true] {
            let model = run(Roofs { h: 4.0, even, ..Roofs::default() }, rule, &trapezoid);
            assert_eq!(size(&model)[1], 4.0, "{rule} {even}");
        }
    }
}

/// *comp operation*: the planes at a collinear corner are coplanar, so their common edge does not count as a hip.
#[test]
fn a_corner_in_a_side_has_no_hip() {
    let divided = outline(&[[0.0, 0.0], [5.0, 0.0], [10.0, 0.0], [10.0, -8.0], [0.0, -8.0]]);
    for (rule, edges) in [("Hip", [5, 4, 0, 2]), ("Gable", [3, 0, 0, 2])] {
        let model = run(Roofs::default(), rule, &divided);
        assert_eq!(counts(&model), edges, "{rule}");
    }
}

/// *roofHip operation*, *roofGable operation*: the L of the pictures.
#[test]
fn roofs_over_an_l() {
    let model = run(Roofs::default(), "Hip", &l_lot());
    assert_eq!((model.count("Top"), counts(&model)), (6, [6, 5, 1, 2]));
    let model = run(Roofs::default(), "Gable", &l_lot());
    assert_eq!((model.count("Top"), areas(&model, "Side"), counts(&model)), (4, vec![4.0, 4.0], [4, 1, 1, 2]));
}

/// *roofGable operation*: two slopes and two upright sides at the short edges, also where an edge is divided.
#[test]
fn a_gable_roof_over_a_rectangle() {
    let model = run(Roofs::default(), "Gable", &rectangle());
    let slope = rounded(40.0 * 2f64.sqrt());
    assert_eq!(areas(&model, "Face"), [slope, 16.0, slope, 16.0, 80.0]);
    assert_eq!((areas(&model, "Side"), counts(&model)), (vec![16.0, 16.0], [2, 0, 0, 1]));
    assert_eq!((size(&model), volume(&model)), ([10.0, 4.0, 8.0], 160.0));
    let same = run(Roofs { h: 4.0, ..Roofs::default() }, "GableHeight", &rectangle());
    assert_eq!(areas(&same, "Face"), areas(&model, "Face"));
    // Collinear corners at an end: each edge has its part of the pediment.
    let divided = outline(&[[0.0, 0.0], [10.0, 0.0], [10.0, -3.0], [10.0, -8.0], [0.0, -8.0]]);
    let model = run(Roofs::default(), "Gable", &divided);
    assert_eq!(areas(&model, "Side"), [4.5, 11.5, 16.0]);
    assert_eq!((model.count("Top"), volume(&model)), (2, 160.0));
}

/// *roofGable operation*: `overhangX` and `overhangY`, together and alone.
#[test]
fn a_gable_roof_with_overhangs() {
    let model = run(Roofs { a: 30.0, x: 2.0, y: 1.0, ..Roofs::default() }, "Gable", &rectangle());
    assert_eq!(size(&model), [12.0, 3.309, 11.464]);
    let slope = rounded(12.0 * (2.0 + 8.0 / 3f64.sqrt()));
    let pediment = rounded(16.0 / 3f64.sqrt());
    assert_eq!(areas(&model, "Face"), [slope, pediment, slope, pediment, 80.0]);
    assert_eq!(counts(&model), [2, 0, 0, 1]);
    for (x, y, size_of) in [(2.0, 0.0, [10.0, 3.309, 11.464]), (0.0, 1.0, [12.0, 2.309, 8.0])] {
        let model = run(Roofs { a: 30.0, x, y, ..Roofs::default() }, "Gable", &rectangle());
        assert_eq!((size(&model), model.count("Face")), (size_of, 5));
    }
    let model = run(Roofs { a: 30.0, x: 2.0, y: 1.0, ..Roofs::default() }, "Gable", &l_lot());
    assert_eq!((model.count("Top"), model.count("Side"), counts(&model)), (4, 2, [4, 1, 1, 2]));
}

/// *roofGable operation*: an edge index gives the direction of the ridge; on a square it runs along the first edge.
#[test]
fn the_ridge_of_a_gable_follows_an_edge() {
    let square = outline(&[[0.0, 0.0], [8.0, 0.0], [8.0, -8.0], [0.0, -8.0]]);
    let sides = |grammar: Roofs, rule: &str, shape: &Shape| areas(&run(grammar, rule, shape), "Face");
    let root = 2f64.sqrt();
    let along = [32.0 * root, 16.0, 32.0 * root, 16.0, 64.0].map(rounded);
    assert_eq!(sides(Roofs::default(), "Gable", &square), along);
    assert_eq!(sides(Roofs::default(), "GableAlong", &square), along);
    let across = [16.0, 32.0 * root, 16.0, 32.0 * root, 64.0].map(rounded);
    assert_eq!(sides(Roofs { n: 1.0, ..Roofs::default() }, "GableAlong", &square), across);
    assert_eq!(sides(Roofs { n: -1.0, ..Roofs::default() }, "GableAlong", &square), across);
    let across = [25.0, 40.0 * root, 25.0, 40.0 * root, 80.0].map(rounded);
    assert_eq!(sides(Roofs { n: 3.0, ..Roofs::default() }, "GableAlong", &rectangle()), across);
}

/// *roofPyramid operation*: the apex, by angle at the first edge and by height.
#[test]
fn a_pyramid_over_the_mean_of_the_corners() {
    let model = run(Roofs::default(), "Pyramid", &rectangle());
    assert_eq!((size(&model), volume(&model), model.count("Top")), ([10.0, 4.0, 8.0], rounded(320.0 / 3.0), 4));
    assert_eq!(counts(&model), [4, 4, 0, 0]);
    let second = 8.0 * (25.0f64 + 16.0).sqrt() / 2.0;
    assert_eq!(areas(&model, "Face")[..2], [rounded(20.0 * 2f64.sqrt() * 2f64.sqrt() / 2f64.sqrt()), rounded(second)]);
    let turned = outline(&[[10.0, 0.0], [10.0, -8.0], [0.0, -8.0], [0.0, 0.0]]);
    assert_eq!(rounded(size(&run(Roofs::default(), "Pyramid", &turned))[1]), 5.0);
    let divided = outline(&[[0.0, 0.0], [5.0, 0.0], [10.0, 0.0], [10.0, -8.0], [0.0, -8.0]]);
    let model = run(Roofs { h: 4.0, ..Roofs::default() }, "PyramidHeight", &divided);
    assert_eq!((volume(&model), model.count("Top")), (rounded(320.0 / 3.0), 5));
    // The apex is 3.2 m from the divided edge.
    assert_eq!(areas(&model, "Face")[0], rounded(2.5 * (3.2f64 * 3.2 + 16.0).sqrt()));
    // The apex is in line with the first edge and 4 m from the second: with 45 degrees it is as high.
    let hooked = outline(&[[0.0, -3.0], [3.0, -3.0], [3.0, 0.0], [18.0, 0.0], [18.0, -6.0], [0.0, -6.0]]);
    let model = run(Roofs::default(), "Pyramid", &hooked);
    assert_eq!((rounded(size(&model)[1]), model.count("Top")), (4.0, 6));
}

/// *roofShed operation*: the edge index, the angle, also a negative one, and the height.
#[test]
fn a_shed_rises_from_an_edge() {
    let model = run(Roofs::default(), "Shed", &rectangle());
    assert_eq!(size(&model), [10.0, 8.0, 8.0]);
    assert_eq!(areas(&model, "Face"), [rounded(80.0 * 2f64.sqrt()), 32.0, 80.0, 32.0, 80.0]);
    assert_eq!((areas(&model, "Outer"), model.count("Inner"), volume(&model)), (vec![32.0, 80.0, 32.0], 0, 320.0));
    let same = run(Roofs { h: 8.0, ..Roofs::default() }, "ShedHeight", &rectangle());
    assert_eq!(areas(&same, "Face"), areas(&model, "Face"));
    let model = run(Roofs { a: 10.0, n: 3.0, ..Roofs::default() }, "Shed", &l_lot());
    assert_eq!((model.count("Top"), model.count("Outer"), model.count("Face")), (1, 5, 7));
    let last = run(Roofs { n: -1.0, ..Roofs::default() }, "Shed", &rectangle());
    assert_eq!(areas(&last, "Face"), areas(&run(Roofs { n: 3.0, ..Roofs::default() }, "Shed", &rectangle()), "Face"));
    // A plane that falls: the roof is below.
    let model = run(Roofs { a: -45.0, ..Roofs::default() }, "Shed", &rectangle());
    assert_eq!((volume(&model), size(&model), rounded(model.bounds().low.y)), (320.0, [10.0, 8.0, 8.0], -8.0));
}

/// *roofShed operation*, *roofRidge operation*: the inner sides of a courtyard.
#[test]
fn holes_have_inner_sides() {
    let hole = vec![[3.0, -2.0], [7.0, -2.0], [7.0, -6.0], [3.0, -6.0]];
    let yard = Shape::footprint(&[[0.0, 0.0], [10.0, 0.0], [10.0, -8.0], [0.0, -8.0]], &[hole]).expect("a yard");
    let model = run(Roofs::default(), "Shed", &yard);
    assert_eq!((model.count("Top"), model.count("Outer")), (1, 3));
    assert_eq!(areas(&model, "Top"), [rounded(64.0 * 2f64.sqrt())]);
    let mut inner = areas(&model, "Inner");
    inner.sort_by(f64::total_cmp);
    assert_eq!(inner, [8.0, 16.0, 16.0, 24.0]);
    let model = run(Roofs::default(), "Ridge", &yard);
    assert_eq!((model.count("Top"), areas(&model, "Outer")), (2, vec![16.0, 16.0]));
    let mut inner = areas(&model, "Inner");
    inner.sort_by(f64::total_cmp);
    // Those across the ridge are pentagons.
    assert_eq!(inner, [8.0, 8.0, 12.0, 12.0]);
    // The skeleton of a courtyard: each of the eight edges has its plane, and the ridge goes around.
    let model = run(Roofs::default(), "Hip", &yard);
    assert_eq!((model.count("Top"), model.count("Bottom")), (8, 1));
    assert_eq!(size(&model), [10.0, 1.5, 8.0]);
}

/// *roofRidge operation*: the ridge along the scope's x axis, turned by an angle, and by height.
#[test]
fn a_ridge_along_the_x_axis() {
    let model = run(Roofs::default(), "Ridge", &rectangle());
    let slope = rounded(40.0 * 2f64.sqrt());
    assert_eq!((areas(&model, "Top"), areas(&model, "Outer")), (vec![slope, slope], vec![16.0, 16.0]));
    assert_eq!((size(&model), volume(&model)), ([10.0, 4.0, 8.0], 160.0));
    let same = run(Roofs { h: 4.0, ..Roofs::default() }, "RidgeHeight", &rectangle());
    assert_eq!(areas(&same, "Face"), areas(&model, "Face"));
    let model = run(Roofs { turn: 90.0, ..Roofs::default() }, "Ridge", &rectangle());
    assert_eq!((size(&model)[1], areas(&model, "Outer")), (5.0, vec![25.0, 25.0]));
    // Diagonally: the outermost points are two corners.
    let model = run(Roofs { turn: 45.0, ..Roofs::default() }, "Ridge", &rectangle());
    assert_eq!((model.count("Top"), model.count("Outer")), (2, 4));
    assert_eq!(size(&model)[1], rounded(9.0 / 2f64.sqrt()));
}

/// *Component tags: roof edges*: the U of the picture.
#[test]
fn roof_edges_of_a_u() {
    let u =
        [[0.0, 0.0], [6.0, 0.0], [6.0, -10.0], [16.0, -10.0], [16.0, 0.0], [22.0, 0.0], [22.0, -18.0], [0.0, -18.0]];
    let model = run(Roofs::default(), "Hip", &outline(&u));
    assert_eq!(counts(&model)[0], 8);
    assert_eq!(counts(&model)[2], 2);
    assert_eq!(model.count("Top"), 8);
    let model = run(Roofs::default(), "Gable", &outline(&u));
    assert_eq!((counts(&model)[0], counts(&model)[2], areas(&model, "Side")), (6, 2, vec![9.0, 9.0]));
}

/// The size of the roof of an example, which its last leaf has.
fn size_of(example: &Example, rule: &str) -> [f64; 3] {
    let model = example.model(&Settings::default());
    assert!(model.faults().is_empty(), "{}: {:?}", example.title, model.faults());
    let leaf = model.leaves_of(rule).last().expect("a roof");
    leaf.scope().size.to_array().map(rounded)
}

/// The lot is an L of 30 by 26 m with wings 12 m wide. Eaves are 2 cos 30 outside and 1 m below, verges 1 m outside.
#[test]
fn examples_have_the_sizes_of_their_rules() {
    let (tan30, out) = (1.0 / 3f64.sqrt(), 3f64.sqrt());
    assert_eq!(
        size_of(&pages::hip::EXAMPLE, "Roof"),
        [30.0 + 2.0 * out, 6.0 * tan30 + 1.0, 26.0 + 2.0 * out].map(rounded)
    );
    assert_eq!(size_of(&pages::gable::EXAMPLE, "Roof"), [31.0 + out, 6.0 * tan30 + 1.0, 27.0 + out].map(rounded));
    let shed = 30.0 * libm::tan(10f64.to_radians());
    assert_eq!(size_of(&pages::shed::EXAMPLE, "Roof"), [30.0, shed, 26.0].map(rounded));
    // The mean of the corners is (10.6, -9.2).
    let height = (20.0 * 9.2 + 2.0 * 10.6) / 404f64.sqrt() * tan30;
    assert_eq!(size_of(&pages::pyramid::EXAMPLE, "Roof")[1], rounded(height));
    assert_eq!(size_of(&pages::ridge::EXAMPLE, "Top")[1], rounded(13.0 * tan30));
    assert_eq!(size_of(&pages::ridge_across::EXAMPLE, "Top")[1], rounded(15.0 * tan30));
    assert_eq!(size_of(&pages::ridge_diagonal::EXAMPLE, "Top")[1], rounded(0.5 * 56.0 / 2f64.sqrt() * tan30));
    // Verges 1 m beyond both ends of the trapezoid, eaves 1 m down the planes.
    assert_eq!(size_of(&pages::hip_uneven::EXAMPLE, "Roof")[0], rounded(24.0 + 2f64.sqrt()));
    assert_eq!(size_of(&pages::gable_uneven::EXAMPLE, "Roof")[0], 26.0);
    for [uneven, even] in [
        [pages::hip_uneven::EXAMPLE, pages::hip_even::EXAMPLE],
        [pages::gable_uneven::EXAMPLE, pages::gable_even::EXAMPLE],
    ] {
        let [uneven, even] = [size_of(&uneven, "Roof"), size_of(&even, "Roof")];
        assert!(uneven[0] == even[0] && even[1] < uneven[1], "{uneven:?} {even:?}");
    }
}

#[test]
fn examples_have_the_parts_of_their_pictures() {
    let counts = |example: &Example| {
        let model = example.model(&Settings::default());
        ["Blue_", "Yellow_", "Red_", "Green_", "Bar", "Tiles_"].map(|rule| model.count(rule))
    };
    assert_eq!(counts(&pages::tags_hip::EXAMPLE), [1, 0, 0, 4, 0, 0]);
    assert_eq!(counts(&pages::tags_gable::EXAMPLE), [1, 2, 0, 2, 0, 0]);
    assert_eq!(counts(&pages::tags_pyramid::EXAMPLE), [1, 0, 0, 4, 0, 0]);
    assert_eq!(counts(&pages::tags_shed::EXAMPLE), [1, 3, 4, 1, 0, 0]);
    assert_eq!(counts(&pages::tags_ridge::EXAMPLE), [1, 2, 4, 2, 0, 0]);
    assert_eq!(counts(&pages::edges_pyramid::EXAMPLE), [0, 0, 0, 0, 8, 0]);
    assert_eq!(counts(&pages::edges_shed::EXAMPLE), [0, 0, 0, 0, 1, 0]);
    assert_eq!(counts(&pages::edges_hip::EXAMPLE), [0, 0, 0, 0, 21, 0]);
    assert_eq!(counts(&pages::edges_gable::EXAMPLE), [0, 0, 0, 0, 15, 0]);
    assert_eq!(counts(&pages::trim_hip::EXAMPLE), [0, 0, 0, 0, 0, 6]);
    assert_eq!(counts(&pages::trim_gable::EXAMPLE), [0, 0, 0, 0, 0, 4]);
    assert_eq!(counts(&pages::trim_pyramid::EXAMPLE), [0, 0, 0, 0, 0, 5]);
}

cga! {
    @Allow(undefined_rule)
    grammar Above = r##"
    attr form = 0
    attr over = 0.3

    @StartRule
    Plain --> Roof
    @StartRule
    Face --> extrude(3) comp(f) { top : Roof }
    @StartRule
    Twice --> extrude(3) comp(f) { top : extrude(1) comp(f) { top : extrude(1) comp(f) { top : Roof } } }
    @StartRule
    Changed --> extrude(3) modify(f) { top : extrude(1) X. } comp(f) { top : Roof }

    Roof --> set(trim.horizontal, true) Form
    Form -->
        case form == 0: roofHip(40, over) Parts
        case form == 1: roofGable(40, over, over) Parts
        case form == 2: roofGable(40, over, over, false, 0) Parts
        case form == 3: roofPyramid(40) Parts
        case form == 4: roofShed(40) Parts
        else: roofRidge(byAngle, 40) Parts
    Parts --> comp(f) { all : [ Slab ] Bars } comp(e) { all : Bar }
    Slab --> s('2, '2, 0.6) center(xyz) primitiveCube() S.
    Bars --> extrude(0.2) comp(f) { all : s('1.5, '1.5, 0.2) center(xyz) primitiveCube() B. }
    Bar --> s('1.2, 0.1, 0.1) center(x) primitiveCube() E.
    @StartRule
    Gutters --> extrude(8) comp(f) { top : roofHip(40, 0.3) comp(e) { eave : s('1, 0.1, 0.1) primitiveCube() E. | all : NIL } }
    "##;
}

/// The pictures of *roofHip*, *roofGable* and *roofPyramid* with trim planes have a roof over the top of a mass and level planes
/// switched on: planes at hips, valleys and ridges, and none at the walls below.
#[test]
fn planes_of_the_face_below_cut_nothing_of_its_roof() {
    let areas = |grammar: &Above, rule: &str, shape: &Shape| {
        let model = grammar.generate_from(rule, shape).expect("a model");
        assert!(model.faults().is_empty(), "{:?}", model.faults());
        ["S", "B", "E"].map(|leaf| model.leaves_of(leaf).map(|leaf| rounded(leaf.area())).collect::<Vec<_>>())
    };
    let eaves = areas(&Above::default(), "Gutters", &Shape::rectangle(20.0, 15.0));
    // From corner to corner of the overhang: 20.46 m and 15.46 m.
    let gutter = |side: f64| rounded(0.4 * (side + 0.6 * libm::cos(40f64.to_radians())) + 0.02);
    assert_eq!(eaves[2], [20.0, 15.0, 20.0, 15.0].map(gutter));
    for shape in [Shape::rectangle(20.0, 15.0), l_lot()] {
        for form in 0..6 {
            for over in [0.0, 0.3, -0.2] {
                let grammar = Above { form: form.into(), over };
                if form == 2 && shape.to_mesh().points().len() != 4 {
                    // A ridge along an edge is for convex faces.
                    continue;
                }
                let plain = areas(&grammar, "Plain", &shape);
                assert!(plain.iter().all(|areas| !areas.is_empty()), "{form}");
                for rule in ["Face", "Twice", "Changed"] {
                    assert_eq!(areas(&grammar, rule, &shape), plain, "{rule} {form} {over}");
                }
            }
        }
    }
}
