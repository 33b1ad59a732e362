//! Every operation in every form compiles to Rust that runs.

use cga::{Error, Grammar, Limits, Settings, Shape, cga};

/// Its assets are not there, and some of its operations have no effect, as the warnings say.
#[allow(deprecated)]
mod every {
    cga::cga! {
        pub grammar Every in "language/every_operation.cga";
    }
}

/// Rows of roofs over roofs end at a limit.
#[test]
fn every_operation_runs() {
    let every = every::Every::default();
    let limits = Limits { vertices: 20_000, ..Limits::default() };
    for rule in every.start_rules() {
        let settings = Settings { start: Some(rule.name.to_string()), limits, ..Settings::default() };
        match every.generate_with(&Shape::rectangle(10.0, 8.0), &settings) {
            Ok(model) => assert!(model.leaves().all(|leaf| leaf.area().is_finite()), "{}", rule.name),
            Err(error) => assert!(matches!(error, Error::Limit { .. }), "{}: {error}", rule.name),
        }
    }
}

cga! {
    grammar Labels;
    Lot --> label("lot") extrude(3) label("mass") comp(f) { top : label("top") Roof. | side : Wall label("wall") }
    Wall --> X. label("after")
}

#[test]
fn labels_change_nothing() {
    let model = Labels::default().generate(&Shape::rectangle(4.0, 3.0)).expect("no limit");
    assert_eq!((model.count("Roof"), model.count("X"), model.faults().len()), (1, 4, 0));
}
