//! Extreme numbers, depths and limits.

use cga::glam::{DAffine3, DVec3};
use cga::{Error, LimitKind, Limits, Model, Repeats, Settings, Shape, cga};

fn names(model: &Model) -> Vec<&str> {
    model.leaves().map(|leaf| leaf.rule()).collect()
}

cga! {
    /// Small rules that each go to one edge.
    @Allow(rule_not_reached)
    grammar Edges;
    @StartRule
    NegativeExtrude --> extrude(-0.3) comp(f) { front : Aa. | side = Bb. }
    NegativeMesh --> s(^1, ^1, 0.3) primitiveCylinder(4) s(^1, -1, ^1) comp(f) { top : Top. | bottom : Bottom. }
    Down       --> Level(700)
    Level(n)   --> case n == 0 : End. else : split(x) { ~1 : t(0, 0, 0) Level(n - 1) }
    BadSizes   --> split(x) { ln(-1) : B. | ~1 : C. | exp(1000) : D. }
    BadIndex   --> comp(f) { ln(-1) : Z. | all = X. }
    Beyond     --> s(1e300, 1e300, 1e300) s(^1e300, ^1e300, ^1e300) A.
    Away       --> t(1e308, 0, 0) t(1e308, 0, 0) A.
    FlatBox    --> primitiveCube s(^1, 0, ^1) s(^1, 2, ^1) A.
    FlatMesh   --> primitiveCylinder s(^1, 0, ^1) s(^1, 2, ^1) A.
    FlatRound  --> primitiveCylinder(16, 0, 5) s(2, ^1, 2) A.
    SmallThing --> s(0.05, 1, 1) split(x) { 0.01 : B. }*
}

#[test]
fn selectors_see_a_mirrored_shape_as_if_it_were_not() {
    // *extrude operation*: on an upright façade the face at its lower edge is the front of a negative extrusion.
    let facade = Shape::mesh(
        cga::Mesh::from_polygon(&[[0.0; 3], [4.0, 0.0, 0.0], [4.0, 3.0, 0.0], [0.0, 3.0, 0.0]].map(Into::into), &[])
            .unwrap(),
    );
    let mesh = Edges::default().generate(&facade).unwrap();
    assert_eq!(names(&mesh), ["Aa", "Bb"]);
    let front = mesh.leaves().next().unwrap().bounds();
    assert_eq!((front.low.y, front.high.y), (0.0, 0.0));
    let side = mesh.leaves().nth(1).unwrap();
    assert!((side.area() - (4.0 * 0.3 + 2.0 * 3.0 * 0.3)).abs() < 1e-12, "three faces: {}", side.area());

    let turned = Edges::default().generate_from("NegativeMesh", &Shape::cuboid(1.0, 1.0, 1.0)).unwrap();
    let heights: Vec<f64> = turned.leaves().map(|leaf| leaf.bounds().high.y).collect();
    assert_eq!(heights, [0.0, -1.0], "top above bottom, in the world");
}

#[test]
fn a_block_is_no_level_of_its_own() {
    let model = Edges::default().generate_from("Down", &Shape::cuboid(1.0, 1.0, 1.0)).unwrap();
    assert_eq!(names(&model), ["End"]);
    let limits = Limits { depth: 300, ..Limits::default() };
    let settings = Settings { start: Some("Down".into()), limits, ..Settings::default() };
    match Edges::default().generate_with(&Shape::cuboid(1.0, 1.0, 1.0), &settings) {
        Err(Error::Limit { what: LimitKind::Depth, limit: 300, trail }) => {
            assert!(trail.iter().all(|rule| !rule.contains('/')), "only rules that were written: {trail:?}");
        }
        other => panic!("{other:?}"),
    }
}

#[test]
fn numbers_that_are_none_leave_a_fault() {
    let faults = |rule: &str| {
        let model = Edges::default().generate_from(rule, &Shape::cuboid(4.0, 3.0, 2.0)).unwrap();
        assert!(model.leaves().all(|leaf| leaf.scope().size.is_finite() && leaf.scope().origin.is_finite()), "{rule}");
        model.faults().len()
    };
    assert_eq!([faults("BadSizes"), faults("BadIndex"), faults("Beyond"), faults("Away")], [2, 1, 2, 2]);
}

#[test]
fn what_is_flat_stays_flat() {
    for rule in ["FlatBox", "FlatMesh", "FlatRound"] {
        let model = Edges::default().generate_from(rule, &Shape::cuboid(4.0, 3.0, 2.0)).unwrap();
        assert!(model.volume().abs() < 1e-12, "{rule}: {}", model.volume());
    }
}

#[test]
fn small_things_on_a_large_site_are_split_like_others() {
    let model = Edges::default().generate_from("SmallThing", &Shape::cuboid(60_000.0, 1.0, 1.0)).unwrap();
    assert_eq!(names(&model), ["B"; 5]);
}

#[test]
fn nothing_reaches_the_sink_after_a_limit() {
    let rules = cga! { Lot --> primitiveCylinder(64) split(x) { ~1 : A. | ~1 : A. } };
    for shapes in [1000, u64::MAX] {
        let limits = Limits { vertices: 10, shapes, ..Limits::default() };
        let mut model = Model::new();
        let result = rules.run(&Shape::cuboid(1.0, 1.0, 1.0), &Settings { limits, ..Settings::default() }, &mut model);
        assert!(matches!(result, Err(Error::Limit { what: LimitKind::Vertices, .. })), "{result:?}");
        assert!(model.is_empty());
    }
}

#[test]
fn bytes_are_counted_before_memory_is_taken() {
    let rules = cga! {
        @StartRule
        Boxes --> split(x) { { 0.01 : X. }* }
        @StartRule
        Rows --> split(x) { { 0.1 : Row }* }
        Row --> split(y) { { 0.1 : X. }* }
        @StartRule
        Slices --> primitiveSphere(200, 100) split(x) { { 0.0001 : X. }* }
        @StartRule
        Sides --> primitiveSphere(100, 50) comp(f) { all : X. }
        @StartRule
        Balls --> split(x) { { 0.05 : primitiveSphere(40, 20) setupProjection(0, scope.xy, 1, 1) projectUV(0) X. }* }
    };
    let ends = |start: &str, bytes: u64, repeats: Repeats| {
        let limits = Limits { bytes, ..Limits::default() };
        let settings = Settings { start: Some(start.to_owned()), limits, repeats, ..Settings::default() };
        match rules.generate_with(&Shape::cuboid(10.0, 10.0, 10.0), &settings) {
            Err(Error::Limit { what, limit, .. }) => Some((what, limit)),
            other => other.map(|_| None).expect("a model or a limit"),
        }
    };
    // A box of each rule, and its parts; a mesh of 4 vertices a face, and its leaves.
    let boxes = Limits::BYTES_A_SHAPE * 1001;
    let sides = Limits::BYTES_A_SHAPE * 5001;
    for repeats in [Repeats::Kept, Repeats::Again, Repeats::Direct] {
        assert_eq!(ends("Boxes", boxes, repeats), None);
        assert_eq!(ends("Boxes", boxes - 1, repeats), Some((LimitKind::Bytes, boxes - 1)));
        let rows = Limits::BYTES_A_SHAPE * (1 + 100 + 100 * 100);
        assert_eq!(ends("Rows", rows, repeats), None);
        assert_eq!(ends("Rows", rows - 1, repeats), Some((LimitKind::Bytes, rows - 1)));
        // 100,000 slices of 20,000 faces would take gigabytes.
        assert_eq!(ends("Slices", 100_000_000, repeats), Some((LimitKind::Bytes, 100_000_000)));
        assert_eq!(ends("Sides", sides, repeats), Some((LimitKind::Bytes, sides)));
        // Each of 200 leaves has 3,000 vertices of its own, as texture coordinates depend on its place.
        assert_eq!(ends("Balls", 12_000_000, repeats), Some((LimitKind::Bytes, 12_000_000)));
        assert_eq!(ends("Balls", 200_000_000, repeats), None);
        // The faces of the ball are counted with the primitive and with its components.
        let faces = 2 * Limits::BYTES_A_VERTEX * 20_000;
        assert_eq!(ends("Sides", sides + faces + Limits::BYTES_A_MESH * 5002, repeats), None);
    }
    let limits = Limits::default();
    assert!(Limits::BYTES_A_SHAPE * limits.shapes <= limits.bytes, "boxes reach the limit of shapes first");
}

/// The vertices of the 10 parts. A small primitive counts for nothing.
#[test]
fn a_cut_may_use_the_whole_limit_of_vertices() {
    let rules = cga! { Lot --> primitiveCylinder(4) split(x) { { ^0.1 : X. }* } };
    let ends = |vertices: u64| {
        let limits = Limits { vertices, ..Limits::default() };
        let result = rules.generate_with(&Shape::cuboid(1.0, 1.0, 1.0), &Settings { limits, ..Settings::default() });
        result.map(|model| model.len())
    };
    let needed = (1..1000).find(|vertices| ends(*vertices).is_ok()).expect("a limit that suffices");
    let corners: u64 = {
        let model = rules.generate(&Shape::cuboid(1.0, 1.0, 1.0)).expect("no limit");
        model.leaves().map(|leaf| leaf.mesh().0.corners().len() as u64).sum()
    };
    assert_eq!(needed, corners);
}

#[test]
fn growth_without_end_is_an_error_and_not_a_hang() {
    let lot = Shape::rectangle(10.0, 10.0);
    let what = |result: Result<Model, Error>| match result {
        Err(Error::Limit { what, .. }) => what,
        other => panic!("{:?}", other.map(|model| model.len())),
    };
    let twice = cga! { @Allow(endless_rules) Lot --> Lot Lot };
    assert_eq!(what(twice.generate(&lot)), LimitKind::Waiting);
    let faces = cga! { @Allow(endless_rules) Lot --> extrude(1) Lot };
    assert_eq!(what(faces.generate(&lot)), LimitKind::Vertices);
    let calls = cga! { f(x) = case x < 2 : 1 else : f(x - 1) + f(x - 2) Lot --> extrude(f(100)) A. };
    assert_eq!(what(calls.generate(&lot)), LimitKind::Calls);
}

#[test]
fn an_attribute_more_changes_no_other() {
    let shape = Shape::cuboid(1.0, 1.0, 1.0).seed(5);
    let one = cga! { attr b = rand(0, 100) Lot --> s(b, 1, 1) A. };
    let two = cga! { attr a = rand(0, 100) attr b = rand(0, 100) Lot --> s(b, 1 + a * 0, 1) A. };
    let width = |model: Model| model.leaves().next().unwrap().size().x;
    assert_eq!(width(one.generate(&shape).unwrap()), width(two.generate(&shape).unwrap()));
}

#[test]
fn operations_on_the_way_to_a_rule_change_no_random_numbers_below() {
    let shape = Shape::cuboid(4.0, 1.0, 1.0).seed(3);
    let plain = cga! { Lot --> split(x) { { 1 : A(rand) }* } A(n) --> s(n, rand, 1) B. };
    let coloured = cga! { Lot --> split(x) { { 1 : color("#ff0000") A(rand) }* } A(n) --> s(n, rand, 1) B. };
    let sizes = |model: Model| model.leaves().map(|leaf| leaf.size().to_array()).collect::<Vec<_>>();
    let expected = sizes(plain.generate(&shape).unwrap());
    assert_eq!(expected, sizes(coloured.generate(&shape).unwrap()));
    assert!(expected.windows(2).all(|pair| pair[0] != pair[1]));
}

#[test]
fn an_old_default_outside_of_its_range_runs() {
    cga! {
        grammar Old;
        @Allow(stray_default)
        @Range(1, 10)
        attr height = 24
        Lot --> extrude(height) A.
    }
    let lot = Shape::rectangle(1.0, 1.0);
    assert!(Old::default().generate(&lot).is_ok());
    assert!(Old { height: 5.0 }.generate(&lot).is_ok());
    assert!(Old { height: 25.0 }.generate(&lot).is_err());
}

#[test]
fn an_initial_shape_without_meaning_is_refused_when_a_run_begins() {
    let run = |shape: Shape| match Edges::default().generate_from("NegativeMesh", &shape) {
        Err(Error::Shape(message)) => message,
        other => panic!("{other:?}"),
    };
    for odd in [f64::NAN, f64::INFINITY, 1e200] {
        for shape in [
            Shape::rectangle(odd, 8.0),
            Shape::rectangle(8.0, odd),
            Shape::cuboid(odd, 1.0, 1.0),
            Shape::cuboid(1.0, odd, 1.0),
            Shape::cuboid(1.0, 1.0, odd),
        ] {
            assert_eq!(run(shape), "a size or position of the initial shape is NaN, infinite or too large");
        }
    }
    for odd in [f64::NAN, f64::INFINITY] {
        for mesh in [Shape::mesh, Shape::mesh_axis_aligned] {
            let cube = Shape::cuboid(1.0, 1.0, 1.0).to_mesh();
            let mapped = cube.map(&DAffine3::from_translation(DVec3::new(odd, 0.0, 0.0)));
            assert_eq!(run(mesh(mapped)), "a coordinate of the initial shape is NaN or infinite");
        }
    }
    let negative = |sizes| format!("the initial shape has a negative size: {sizes}");
    assert_eq!(run(Shape::rectangle(-3.0, 8.0)), negative("[-3, 0, 8]"));
    assert_eq!(run(Shape::cuboid(3.0, -1.0, 8.0)), negative("[3, -1, 8]"));
    // Without a size along an axis a shape is flat, which splits and components know.
    let zero = [Shape::cuboid(6.0, 4.0, 0.0), Shape::rectangle(0.0, 8.0), Shape::point([0.0; 3])];
    for shape in zero.into_iter().chain(Shape::line([0.0; 3], [1.0, 0.0, 0.0])) {
        assert!(Edges::default().generate_from("NegativeMesh", &shape).is_ok());
    }
}
