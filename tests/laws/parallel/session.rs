//! Sessions: runs that share what is made once.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;

use cga::glam::DAffine3;
use cga::{Error, Flow, Grammar, Leaf, Limits, Mesh, Model, Settings, Shape, Sink, cga};

use super::grammars::{cases, lots, settings};

#[test]
fn runs_of_a_session_are_those_of_their_own() {
    for (grammar, shapes) in cases() {
        let mut session = grammar.session(&settings()).expect("a session");
        for shape in shapes.iter().take(30) {
            let mut model = Model::new();
            let report = session.run(shape, &mut model).expect("no limit");
            let alone = grammar.generate_with(shape, &settings()).expect("no limit");
            assert!(model.to_glb().expect("a file") == alone.to_glb().expect("a file"));
            assert_eq!(format!("{report:?}"), format!("{:?}", alone.report()));
        }
    }
}

#[test]
fn a_session_fills_one_sink_as_single_runs_do() {
    for (grammar, shapes) in cases() {
        let settings = settings();
        let mut session = grammar.session(&settings).expect("a session");
        let (mut shared, mut single) = (Model::new(), Model::new());
        for shape in shapes.iter().take(30) {
            assert!(session.run(shape, &mut shared).is_ok());
            assert!(grammar.run(shape, &settings, &mut single).is_ok());
        }
        // Instances in the file do not depend on where meshes are kept.
        assert!(shared.to_glb().expect("a file") == single.to_glb().expect("a file"));
    }
}

cga! {
    grammar Pieces;
    Lot --> split(x) { { 1 : A. }* }
}

#[test]
fn a_session_goes_on_after_an_error() {
    let settings = Settings { limits: Limits { shapes: 10, ..Limits::default() }, ..Settings::default() };
    let grammar = Pieces::default();
    let mut session = grammar.session(&settings).expect("a session");
    assert_eq!(session.settings().limits.shapes, 10);
    assert!(matches!(session.generate(&Shape::cuboid(20.0, 1.0, 1.0)), Err(Error::Limit { .. })));
    assert!(matches!(session.generate(&Shape::cuboid(f64::NAN, 1.0, 1.0)), Err(Error::Shape(_))));
    assert_eq!(session.generate(&Shape::cuboid(5.0, 1.0, 1.0)).expect("no limit").len(), 5);
}

#[test]
fn a_session_of_a_grammar_by_pointer_checks_when_it_opens() {
    let wrong = Settings { start: Some("Nowhere".into()), ..Settings::default() };
    let grammar: Box<dyn Grammar> = Box::new(Pieces::default());
    assert!(matches!(grammar.session(&wrong), Err(Error::StartRule { .. })));
    let mut model = Model::new();
    let mut session = grammar.session(&Settings::default()).expect("a session");
    for lot in lots(2) {
        assert!(session.run(&lot, &mut model).is_ok());
    }
    assert_eq!(model.len(), 28);
}

cga! {
    grammar Painted;
    Lot  --> split(x) { { 1 : Tile }* }
    Tile --> color("#ff0000") split(z) { 1 : A. | ~1 : B }
    B    --> color("#00ff00") C.
}

/// Panics at a leaf.
struct Fragile(usize);

impl Sink for Fragile {
    fn mesh(&mut self, _: &Leaf<'_>, _: &Arc<Mesh>, _: &DAffine3) -> Flow {
        self.0 = self.0.checked_sub(1).expect("a sound sink");
        Flow::Continue(())
    }
}

#[test]
fn a_sink_that_panics_leaves_no_mark_in_its_session() {
    let (grammar, settings, shape) = (Painted::default(), Settings::default(), Shape::rectangle(4.0, 3.0));
    let mut session = grammar.session(&settings).expect("a session");
    let materials = |model: &Model| model.leaves().map(|leaf| leaf.material().clone()).collect::<Vec<_>>();
    let before = materials(&session.generate(&shape).expect("no limit"));
    for leaves in [0, 1, 3, 7] {
        let run = catch_unwind(AssertUnwindSafe(|| session.run(&shape, &mut Fragile(leaves))));
        assert!(run.is_err());
        assert_eq!(materials(&session.generate(&shape).expect("no limit")), before, "after {leaves} leaves");
    }
}
