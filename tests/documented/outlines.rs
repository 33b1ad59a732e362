//! *splitArea operation*, on outlines of every kind, however they stand: parts have their share of the area, lie in order
//! along the axis, fill their scopes and leave nothing out.

use cga::glam::{DMat3, DVec3};
use cga::{Axis, LeafView, MeshBuilder, Model, Shape, cga};

use cga_tests::pages::split_area::{block, corner, frame, shapes, triangle};

cga! {
    grammar Areas = r#"
    # How the lot is stretched before it is divided.
    attr wide = 1
    attr deep = 1

    @StartRule
    Whole        --> s('wide, '1, 'deep) P.
    @StartRule
    SevenThree   --> s('wide, '1, 'deep) splitArea(x) { '0.7 : P. | '0.3 : P. }
    @StartRule
    Fifths       --> s('wide, '1, 'deep) splitArea(x) { '0.2 : P. }*
    @StartRule
    FifthsAcross --> s('wide, '1, 'deep) splitArea(z) { '0.2 : P. }*
    @StartRule
    ThreeTenths  --> s('wide, '1, 'deep) splitArea(x) { '0.3 : P. }*
    @StartRule
    Between      --> s('wide, '1, 'deep) splitArea(x) { ~1 : P. | geometry.area/2 : P. | ~1 : P. }
    @StartRule
    Six          --> s('wide, '1, 'deep) splitArea(x) { ~1 : Two | ~1 : Two | ~1 : Two }
    Two          --> splitArea(z) { '0.5 : P. | '0.5 : P. }
    "#;
}

const CASES: [(&str, Axis, &[f64]); 6] = [
    ("SevenThree", Axis::X, &[0.7, 0.3]),
    ("Fifths", Axis::X, &[0.2; 5]),
    ("FifthsAcross", Axis::Z, &[0.2; 5]),
    ("ThreeTenths", Axis::X, &[0.3, 0.3, 0.3, 0.1]),
    ("Between", Axis::X, &[0.25, 0.5, 0.25]),
    ("Six", Axis::X, &[1.0 / 6.0; 6]),
];

fn outline(corners: &[[f64; 2]], holes: &[Vec<[f64; 2]>]) -> Shape {
    Shape::footprint(corners, holes).expect("an outline")
}

/// A tooth every other metre, all of the same height but one.
fn comb() -> Shape {
    let corners = [
        [0.0, 5.0],
        [7.0, 5.0],
        [7.0, 0.0],
        [6.0, 0.0],
        [6.0, 4.0],
        [5.0, 4.0],
        [5.0, 1.0],
        [4.0, 1.0],
        [4.0, 4.0],
        [3.0, 4.0],
        [3.0, 0.0],
        [2.0, 0.0],
        [2.0, 4.0],
        [1.0, 4.0],
        [1.0, 0.0],
        [0.0, 0.0],
    ];
    outline(&corners, &[])
}

/// Two holes beside each other, one a triangle.
fn holes() -> Shape {
    let holes = [vec![[1.0, 1.0], [4.0, 2.0], [2.0, 5.0]], vec![[5.0, 1.0], [6.0, 1.0], [6.0, 6.0], [5.0, 6.0]]];
    outline(&[[0.0, 7.0], [9.0, 8.0], [7.0, 0.0], [0.0, 0.0]], &holes)
}

/// Faces of corners that turn counter-clockwise as seen from above.
fn faces(list: &[&[[f64; 3]]]) -> Shape {
    let mut builder = MeshBuilder::new();
    for face in list {
        let corners: Vec<u32> = face.iter().map(|corner| builder.point(*corner)).collect();
        builder.polygon(&corners);
    }
    Shape::mesh(builder.build().expect("faces"))
}

/// Squares of 1 and 4 with nothing between them where half of the area ends.
fn islands() -> Shape {
    let square = |x: f64, size: f64| [[x, 0.0, size], [x + size, 0.0, size], [x + size, 0.0, 0.0], [x, 0.0, 0.0]];
    faces(&[&square(0.0, 2.0), &square(3.0, 1.0), &square(7.0, 1.0), &square(9.0, 2.0)])
}

/// A parallelogram that slopes in its scope, along both axes of the ground.
fn slope() -> Shape {
    faces(&[&[[0.0, 0.0, 0.0], [10.0, 3.0, 0.0], [12.0, 8.6, -6.0], [2.0, 5.6, -6.0]]])
}

fn lots() -> Vec<(&'static str, Shape)> {
    vec![
        ("rectangle", Shape::rectangle(7.0, 3.0)),
        ("corner", corner()),
        ("triangle", triangle()),
        (
            "u",
            outline(
                &[[0.0, 4.0], [1.0, 4.0], [1.0, 1.0], [5.0, 1.0], [5.0, 4.0], [6.0, 4.0], [6.0, 0.0], [0.0, 0.0]],
                &[],
            ),
        ),
        ("comb", comb()),
        ("frame", frame()),
        ("holes", holes()),
        ("shapes", shapes()),
        ("islands", islands()),
        ("block", block()),
        ("slope", slope()),
    ]
}

/// The same lot turned about an axis through the world's origin, with its scope.
pub(crate) fn turned(lot: &Shape, axis: [f64; 3], degrees: f64) -> Shape {
    let turn = DMat3::from_axis_angle(DVec3::from_array(axis).normalize(), degrees.to_radians());
    let mut scope = *lot.scope();
    scope.origin = turn * scope.origin;
    scope.axes = turn * scope.axes;
    let mut lot = lot.clone();
    lot.set_scope(scope);
    lot
}

fn near(a: f64, b: f64, extent: f64) -> bool {
    (a - b).abs() < 1e-9 * extent
}

/// The box around the geometry of a leaf, in its scope's coordinates.
pub(crate) fn fits(leaf: &LeafView<'_>) -> (DVec3, DVec3) {
    let (mesh, place) = leaf.mesh();
    let frame = leaf.scope().frame();
    let points = mesh.points().iter().map(|point| frame.to_local(place.transform_point3(*point)));
    points.fold((DVec3::INFINITY, -DVec3::INFINITY), |(low, high), point| (low.min(point), high.max(point)))
}

fn run(rules: &Areas, case: &str, lot: &Shape) -> Model {
    let model = rules.generate_from(case, lot).unwrap_or_else(|error| panic!("{case}: {error}"));
    assert!(model.faults().is_empty(), "{case}: {:?}", model.faults());
    model
}

/// All cases on a lot.
#[track_caller]
fn check(name: &str, lot: &Shape, rules: &Areas) {
    let whole = run(rules, "Whole", lot);
    let parent = whole.leaves().next().expect("the lot").scope();
    let extent = parent.size.length();
    for (case, axis, shares) in CASES {
        let model = run(rules, case, lot);
        let areas: Vec<f64> = model.leaves().map(|leaf| leaf.area()).collect();
        let expected: Vec<f64> = shares.iter().map(|share| share * whole.area()).collect();
        let same =
            areas.len() == expected.len() && areas.iter().zip(&expected).all(|(a, b)| near(*a, *b, whole.area()));
        assert!(same, "{case} of {name}: {areas:?}, not {expected:?}");

        let mut end = 0.0;
        for (index, leaf) in model.leaves().enumerate() {
            let place = parent.frame().to_local(leaf.scope().origin);
            let (low, high) = fits(&leaf);
            let fitted =
                low.abs().max_element() < 1e-9 * extent && (high - leaf.size()).abs().max_element() < 1e-9 * extent;
            assert!(fitted, "{case} of {name}: {low} to {high} in {}", leaf.size());
            // Of six parts two each have the same place along x.
            if case != "Six" || index % 2 == 0 {
                let start = place[axis.index()];
                assert!(
                    case == "Six" || end <= start + 1e-9 * extent,
                    "{case} of {name}: part {index} begins at {start}"
                );
                end = start + leaf.size()[axis.index()];
            }
        }
    }
}

#[test]
fn shares_of_outlines_of_every_kind() {
    for (name, lot) in lots() {
        check(name, &lot, &Areas::default());
    }
}

#[test]
fn shares_of_lots_that_are_turned_or_tilted() {
    for (name, lot) in lots() {
        check(name, &turned(&lot.clone().at([3.0, 1.0, -2.0]), [0.0, 1.0, 0.0], 33.0), &Areas::default());
        check(name, &turned(&lot, [1.0, 0.3, -0.2], 50.0), &Areas::default());
        check(name, &turned(&lot, [0.0, 0.0, 1.0], 90.0), &Areas::default());
    }
}

#[test]
fn shares_of_lots_that_were_stretched() {
    for (name, lot) in lots() {
        check(name, &lot, &Areas { wide: 2.5, deep: 0.4 });
        check(name, &turned(&lot, [1.0, 0.3, -0.2], 50.0), &Areas { wide: 0.3, deep: 7.0 });
    }
}
