//! Numbers of parts, what is evaluated when and on what, and what goes on afterwards.

use cga::{Model, Shape, cga};

use super::values;

cga! {
    grammar Order = r##"
    # *split operation*: "Index and total are global"; the first is the lowest (*split attribute*).
    @StartRule Tens --> split(x) { '0.1 : A | '0.1 : B }*
    A --> print("A " + split.index) print("total " + split.total) A.
    B --> print("B " + split.index) print("total " + split.total) B.
    @StartRule Up --> split(y) { 2 : print("index " + split.index) print("y " + scope.ty) X. }*
    @StartRule Turn --> split(y) { 2 : r(0, 360 * split.index / split.total, 0) X. }*
    @StartRule Dropped --> split(x) { 0 : I | 2 : I | -1 : I | ~1 : I | 3 : I | 5 : I }
    @StartRule Groups --> split(x) { 1 : I | { ~1 : I | { ~1 : I }* }* | 1 : I }
    I --> print("index " + split.index) print("total " + split.total) I.

    # Inherited until the next split, through successors, brackets and comps.
    @StartRule Inherited --> split(x) { ~1 : NIL | ~1 : t(0, 1, 0) Deeper }
    Deeper --> [ I ] comp(f) { top : I } split(y) { ~1 : I | ~1 : NIL | ~1 : NIL } I
    @StartRule Before --> I

    # Sizes belong to the written slots: one draw each, on the whole shape, whatever the repetitions.
    @StartRule Draws --> split(x) { { rand(1, 2) : print("size " + scope.sx) A. | rand(1, 2) : print("other " + scope.sx) B. }* }
    @StartRule OnTheWhole --> split(x) { scope.sx / 5 : A. | scope.sy : B. | split.index + 2 : C. | ~1 : D. }

    # Operations of a slot run on the part, in the context of the rule: its parameters, its locals.
    @StartRule Context --> Own(2)
    Own(n) with ( m := n + 1 ) --> split(x) { n : s('1, m, '1) A. | ~1 : s(n, '1, '1) t(scope.sx, 0, 0) B. }

    # The shape goes on as it was.
    @StartRule After --> color("#ff0000") split(x) { 1 : color("#00ff00") t(0, 5, 0) A. }* print("index " + split.index) s('0.5, '1, '1) B.
    @StartRule Nothing --> split(x) { 0 : A. | -1 : B. }
    @StartRule Only --> split(x) { ~1 : NIL }
    @StartRule Room --> split(x) { { '0.1 : A. | 0 : B. | 0 : B. | 0 : B. | 0 : B. }* }
    @StartRule RoomByArea --> splitArea(x) { { '0.1 : A. | 0 : B. | 0 : B. | 0 : B. | 0 : B. }* }
    @StartRule Seeds --> split(x) { ~1 : print("drawn " + rand(1)) A. }*
    "##;
}

fn run(rule: &str, shape: &Shape) -> Model {
    let model = Order::default().generate_from(rule, shape).unwrap();
    assert!(model.faults().is_empty(), "{rule}: {:?}", model.faults());
    model
}

fn names(model: &Model) -> Vec<&str> {
    model.leaves().map(|leaf| leaf.rule()).collect()
}

#[test]
fn index_and_total_run_through_the_repetitions() {
    let model = run("Tens", &Shape::cuboid(10.0, 1.0, 1.0));
    assert_eq!(values(&model, "A"), [0.0, 2.0, 4.0, 6.0, 8.0]);
    assert_eq!(values(&model, "B"), [1.0, 3.0, 5.0, 7.0, 9.0]);
    assert_eq!(values(&model, "total"), [10.0; 10]);
}

#[test]
fn the_first_slice_is_the_lowest() {
    let model = run("Up", &Shape::cuboid(3.0, 20.0, 3.0));
    assert_eq!(values(&model, "index"), (0..10).map(f64::from).collect::<Vec<_>>());
    assert_eq!(values(&model, "y"), (0..10).map(|index| 2.0 * f64::from(index)).collect::<Vec<_>>());
}

#[test]
fn slices_turn_by_their_share_of_a_full_turn() {
    let model = run("Turn", &Shape::cuboid(1.0, 18.0, 1.0));
    assert_eq!(model.count("X"), 9);
    for (index, leaf) in model.leaves().enumerate() {
        let angle = (40.0 * index as f64).to_radians();
        let x = leaf.scope().axes.x_axis;
        assert!((x.x - libm::cos(angle)).abs() < 1e-12 && (x.z + libm::sin(angle)).abs() < 1e-12, "{index}: {x}");
    }
}

/// *split operation*: slots without room are not made and not counted.
#[test]
fn slots_that_make_nothing_are_not_counted() {
    let model = run("Dropped", &Shape::cuboid(9.0, 1.0, 1.0));
    assert_eq!((values(&model, "index"), values(&model, "total")), (vec![0.0, 1.0, 2.0], vec![3.0; 3]));
}

#[test]
fn groups_inside_groups_count_on() {
    let model = run("Groups", &Shape::cuboid(10.0, 1.0, 1.0));
    let index = values(&model, "index");
    assert_eq!(index, (0..index.len()).map(|at| at as f64).collect::<Vec<_>>());
    assert_eq!(values(&model, "total"), vec![index.len() as f64; index.len()]);
    assert!(4 < index.len());
}

#[test]
fn index_and_total_are_inherited_until_the_next_split() {
    let model = run("Inherited", &Shape::cuboid(2.0, 1.0, 1.0));
    // Bracket, comp, the split inside, and the shape itself behind it.
    assert_eq!(values(&model, "index"), [1.0, 1.0, 0.0, 1.0]);
    assert_eq!(values(&model, "total"), [2.0, 2.0, 3.0, 2.0]);
    let model = run("Before", &Shape::cuboid(2.0, 1.0, 1.0));
    assert_eq!((values(&model, "index"), values(&model, "total")), (vec![-1.0], vec![0.0]));
}

/// The sizes belong to the split and not to its repetitions (inferred from the compiled form, where the tree of sizes is
/// built before it is expanded).
#[test]
fn sizes_are_drawn_once_a_written_slot() {
    for seed in 0..20 {
        let model = run("Draws", &Shape::cuboid(40.0, 1.0, 1.0).seed(seed));
        for name in ["size", "other"] {
            let drawn = values(&model, name);
            // The last one may be cut.
            assert!(8 < drawn.len() && drawn[1..drawn.len() - 1].iter().all(|size| *size == drawn[0]), "{drawn:?}");
        }
        assert_ne!(values(&model, "size")[0], values(&model, "other")[0], "a draw each");
    }
}

#[test]
fn sizes_are_computed_on_the_whole_shape() {
    let model = run("OnTheWhole", &Shape::cuboid(10.0, 3.0, 1.0));
    let lengths: Vec<f64> = model.leaves().map(|leaf| leaf.size().x).collect();
    assert_eq!(lengths, [2.0, 3.0, 1.0, 4.0]);
}

#[test]
fn operations_of_a_slot_run_on_the_part_with_the_rules_own_names() {
    let model = run("Context", &Shape::cuboid(10.0, 1.0, 1.0));
    let [a, b] = [0, 1].map(|at| model.leaves().nth(at).unwrap());
    assert_eq!((a.rule(), a.size().to_array()), ("A", [2.0, 3.0, 1.0]));
    assert_eq!((b.rule(), b.size().to_array(), b.scope().origin.x), ("B", [2.0, 1.0, 1.0], 4.0));
}

#[test]
fn the_shape_goes_on_unchanged() {
    let model = run("After", &Shape::cuboid(2.0, 1.0, 1.0));
    assert_eq!(names(&model), ["A", "A", "B"]);
    assert_eq!(values(&model, "index"), [-1.0], "and has no number");
    let last = model.leaves().nth(2).unwrap();
    assert_eq!((last.size().to_array(), last.scope().origin.to_array()), ([1.0; 3], [0.0; 3]));
    assert_eq!(last.material().color, Some(cga::Color::new(1.0, 0.0, 0.0)));
}

/// A shape without children is a leaf, and so is one whose split has made none. `NIL` is a child that vanished.
#[test]
fn a_split_that_makes_nothing_leaves_the_shape() {
    assert_eq!(names(&run("Nothing", &Shape::cuboid(2.0, 1.0, 1.0))), ["Nothing"]);
    assert!(run("Only", &Shape::cuboid(2.0, 1.0, 1.0)).is_empty());
}

#[test]
fn every_part_has_a_seed_of_its_own_that_does_not_depend_on_the_others() {
    let drawn = |length: f64| values(&run("Seeds", &Shape::cuboid(length, 1.0, 1.0).seed(7)), "drawn");
    let (four, six) = (drawn(4.0), drawn(6.0));
    assert_eq!(four, six[..4], "two more at the end change nothing");
    let mut sorted = six.clone();
    sorted.sort_by(f64::total_cmp);
    sorted.dedup();
    assert_eq!(sorted.len(), 6);
}

/// The limit counts what is made, and not slots that get no room.
#[test]
fn slots_without_room_count_for_no_limit() {
    let outline = [[0.0, 4.0], [6.0, 4.0], [6.0, 0.0], [0.0, 1.0]];
    for rule in ["Room", "RoomByArea"] {
        let limits = cga::Limits { shapes: 25, ..cga::Limits::default() };
        let settings = cga::Settings { start: Some(rule.into()), limits, ..cga::Settings::default() };
        let shape = Shape::footprint(&outline, &[]).unwrap();
        assert_eq!(Order::default().generate_with(&shape, &settings).unwrap().count("A"), 10, "{rule}");
    }
}
