//! *comp operation*, the other examples: how many components of which kind, and what trim planes leave.

use cga::{Model, Settings, Shape, cga};

use cga_tests::pages::components::{
    aligned, border_edges, border_faces, border_vertices, condition, edges, face_edges, face_vertices, kept,
    large_or_border, materials, numbers, own_function, trim_both, trim_vertical, vertices,
};
use cga_tests::pages::example::Example;

fn model(example: &Example) -> Model {
    example.model(&Settings::default())
}

#[test]
fn components_are_counted() {
    // A ball of 16 by 8 faces: two rows look up, and the lowest row has triangles.
    assert_eq!(model(&condition::EXAMPLE).counts(), [("X", 1)]);
    assert_eq!(model(&own_function::EXAMPLE).counts(), [("X", 32 + 16)]);
    // Of 11 faces two have an area of 1, and one is inside.
    assert_eq!(model(&large_or_border::EXAMPLE).counts(), [("X", 8)]);
    assert_eq!(model(&numbers::EXAMPLE).counts(), [("X", 3)]);
    assert_eq!(model(&border_faces::EXAMPLE).counts(), [("FBorder", 36), ("FInside", 64)]);
    assert_eq!(model(&border_edges::EXAMPLE).counts(), [("EBorder", 40), ("EInside", 180)]);
    assert_eq!(model(&border_vertices::EXAMPLE).counts(), [("VBorder", 40), ("VInside", 81)]);
    assert_eq!(model(&edges::EXAMPLE).counts(), [("X", 12)]);
    assert_eq!(model(&face_edges::EXAMPLE).counts(), [("X", 24)]);
    assert_eq!(model(&vertices::EXAMPLE).count("X"), 8);
    assert_eq!(model(&face_vertices::EXAMPLE).count("X"), 5);
    assert_eq!(model(&materials::EXAMPLE).counts(), [("Oranges", 1), ("Trunk", 1)]);
}

/// The inserted cube goes 1 m to both sides of the face. Upright trim planes leave a front of 12 by 10 m, a back of 8 by 10 m and
/// two trapezoids. Level ones as well make the back 8 m high and leave the front half of the trapezoids. Cuts at trim planes
/// stay open.
#[test]
fn trim_planes_cut_what_is_inserted() {
    for (example, area) in
        [(trim_vertical::EXAMPLE, 120.0 + 80.0 + 2.0 * 20.0), (trim_both::EXAMPLE, 120.0 + 64.0 + 2.0 * 11.0)]
    {
        let model = model(&example);
        assert_eq!(model.counts(), [("X", 1)]);
        assert!((model.area() - area).abs() < 1e-9, "{}: {}", example.title, model.area());
    }
}

/// Cubes on edges are centred on them and have the width that the page gives.
#[test]
fn border_cubes_lie_on_their_edges() {
    let model = model(&border_edges::EXAMPLE);
    let bounds = model.bounds();
    for (at, expected) in [(bounds.low, [-0.025, 0.0, -0.025]), (bounds.high, [1.025, 0.05, 1.025])] {
        assert!(at.abs_diff_eq(expected.into(), 1e-9), "{at}");
    }
    let thin = model.leaves_of("EInside").next().expect("an edge inside");
    assert!(thin.size().abs_diff_eq([0.1, 0.01, 0.01].into(), 1e-9), "{}", thin.size());
}

/// In the picture edges of the top and of the bottom run as the sides do, so their cubes are outside. Upright edges run down, as the
/// later one of two sides does: all but the edge between the last side and the first one.
#[test]
fn edges_run_as_their_last_face() {
    let model = model(&edges::EXAMPLE);
    let middle = 0.5 * (model.bounds().low + model.bounds().high);
    let mut upright = Vec::new();
    for leaf in model.leaves_of("X") {
        let scope = leaf.scope();
        let [x, y, z] = [scope.axes.x_axis, scope.axes.y_axis, scope.axes.z_axis];
        assert!(0.0 < z.dot(scope.origin + x * 0.5 * scope.size.x - middle), "{scope:?}");
        match z.y {
            up if 1e-9 < up => assert!(y.y < 0.0, "{scope:?}"),
            up if up < -1e-9 => assert!(0.0 < y.y, "{scope:?}"),
            _ => upright.push(x.y.round()),
        }
    }
    upright.sort_by(f64::total_cmp);
    assert_eq!(upright, [-1.0, -1.0, -1.0, 1.0]);
}

/// The right face leans: its scope follows it, or stays along the lot.
#[test]
fn a_face_has_a_scope_of_its_own_unless_it_keeps_the_lots() {
    let sizes = [aligned::EXAMPLE, kept::EXAMPLE].map(|example| {
        let model = model(&example);
        assert_eq!(model.counts(), [("Right", 1), ("Side", 3)]);
        model.leaves_of("Right").next().expect("the right face").size()
    });
    assert!(sizes[0].abs_diff_eq([libm::hypot(1.5, 6.0), 5.0, 0.0].into(), 1e-9), "{}", sizes[0]);
    assert!(sizes[1].abs_diff_eq([1.5, 5.0, 6.0].into(), 1e-9), "{}", sizes[1]);
}

cga! {
    grammar Planes = r##"
    @StartRule
    Sides --> extrude(2) comp(f) { right : P }
    P --> extrude(0.2) comp(f) { side : s('1.5, '1, 0.2) center(xyz) primitiveCube() X. }
    "##;
}

/// *trim attribute*: the angle is that "to the xz-plane of the pivot", so the planes of the outer `comp` are level for the frames of the
/// inner one, and off. Only the ends are cut, as a published result shows.
#[test]
fn trim_planes_are_classed_by_the_pivot_of_the_moment() {
    let run = |rule: &str| {
        let model = Planes::default().generate_from(rule, &Shape::rectangle(20.0, 15.0)).expect("a model");
        assert!(model.faults().is_empty());
        let of = |leaf: cga::LeafView<'_>| (leaf.mesh().0.points().len(), (leaf.area() * 1e6).round() / 1e6);
        model.leaves_of("X").map(of).collect::<Vec<_>>()
    };
    assert_eq!(run("Sides"), [(8, 12.0), (8, 1.6), (8, 12.0), (8, 1.6)]);
}
