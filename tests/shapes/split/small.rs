//! Where recursive splits end.

use cga::{Limits, Model, Settings, Shape, cga};

cga! {
    grammar Small = r#"
    # *Subdivision split*: "The recursion stops when the geometry gets too small for a further split."
    @StartRule Golden --> split(x) { '0.382 : A | '0.618 : B }
    A --> split(x) { '0.382 : A | '0.618 : C }
    B --> split(x) { '0.382 : B | '0.618 : D }
    C --> split(x) { '0.382 : Green. | '0.618 : Yellow. }
    D --> split(x) { '0.382 : Green. | '0.618 : Yellow. }
    @StartRule Halves --> split(x) { ~1 : Halves | ~1 : NIL }
    @StartRule Both --> split(x) { '0.03 : Both | ~1 : NIL } split(y) { '0.03 : Both | ~1 : NIL }
    @StartRule Full --> split(x) { ~1 : split(y) { ~1 : split(z) { ~1 : Full | ~1 : Full } } }
    @StartRule Grown --> s(5, 1, 1) primitiveCube() Halves
    @StartRule Same --> split(x) { ~1 : Same }
    @StartRule Thin --> split(x) { scope.sx - 0.0001 : Thin }
    "#;
}

fn run(rule: &str, shape: &Shape) -> Model {
    let model = Small::default().generate_from(rule, shape).unwrap();
    assert!(model.faults().is_empty(), "{rule}: {:?}", model.faults());
    model
}

/// A millionth of the initial shape, and at most a tenth of a millimetre.
#[test]
fn recursion_ends_when_a_piece_is_too_small_to_be_split() {
    for (length, smallest) in [(1.0, 1e-6), (5.0, 5e-6), (1e-3, 1e-9), (1e6, 1e-4), (1e9, 1e-4)] {
        let model = run("Halves", &Shape::cuboid(length, 1.0e-12, 1.0e-12));
        let last = model.leaves().next().unwrap().size().x;
        assert!(model.len() == 1 && last <= smallest && smallest < 2.0 * last, "{length}: ends at {last}");
    }
    let model = run("Golden", &Shape::cuboid(5.0, 1.0, 1.0));
    // Both A and B are split fourteen times before they are shorter than 5e-6. What each split cuts off is split into a
    // green and a yellow piece, except for the last C, which is too short itself.
    let (green, yellow) = (model.count("Green"), model.count("Yellow"));
    assert_eq!((green, yellow, model.len()), (27, 27, 57), "{:?}", model.counts());
    assert!((model.volume() - 5.0).abs() < 1e-9, "nothing is lost");
}

/// A run may start from a point, and make everything itself.
#[test]
fn a_run_from_a_point_ends_at_a_tenth_of_a_millimetre() {
    let model = run("Grown", &Shape::point([1.0, 2.0, 3.0]));
    let last = model.leaves().next().unwrap().size().x;
    assert!(last <= 1e-4 && 1e-4 < 2.0 * last, "ends at {last}");
}

#[test]
fn every_axis_has_its_own_end() {
    let model = run("Both", &Shape::cuboid(1.0, 1.0, 1.0));
    // Four times along each axis, in any order.
    assert_eq!(model.len(), 70);
    assert!(model.leaves().all(|leaf| leaf.size().x <= 1e-6 && leaf.size().y <= 1e-6));
}

/// A split whose part is the whole never gets there: the limit of depth ends it.
#[test]
fn what_does_not_shrink_ends_at_the_limit_of_depth() {
    for rule in ["Same", "Full"] {
        let limits = Limits { depth: 200, shapes: 100_000, ..Limits::default() };
        let settings = Settings { start: Some(rule.into()), limits, ..Settings::default() };
        let error = Small::default().generate_with(&Shape::cuboid(1.0, 1.0, 1.0), &settings).unwrap_err();
        assert!(matches!(error, cga::Error::Limit { .. }), "{rule}: {error}");
    }
}

/// As deep as the limit allows, on a thread with little stack.
#[test]
fn deep_recursive_splits_need_no_stack() {
    let run = || {
        let limits = Limits { depth: 20_000, ..Limits::default() };
        let settings = Settings { start: Some("Thin".into()), limits, ..Settings::default() };
        let model = Small::default().generate_with(&Shape::cuboid(1.0, 1.0, 1.0), &settings).unwrap();
        assert!(model.leaves().all(|leaf| leaf.size().x <= 1.1e-4));
        model.len()
    };
    let thread = std::thread::Builder::new().stack_size(1 << 20).spawn(run).unwrap();
    assert_eq!(thread.join().unwrap(), 1);
}
