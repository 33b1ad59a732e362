//! However deep loaded rules go, the stack suffices: also without optimisation, on a thread with two megabytes. The rules are the
//! ones of `tests/language/deep.rs`, and the limits are the same.

use cga::{Error, Grammar, LimitKind, Limits, Model, RuleFile, Settings, Shape};
use cga_tests::inline;
use cga_tests::tree::root;

/// The rules of a grammar there.
fn load(name: &str) -> RuleFile {
    let source = std::fs::read_to_string(root().join("tests/language/deep.rs")).expect("the tests");
    let grammar = inline::named(&source, name);
    RuleFile::loader().named(name).text(&grammar.rules).unwrap_or_else(|error| panic!("{name}: {error}"))
}

/// The rules of a file.
fn open(file: &str) -> RuleFile {
    RuleFile::open(root().join("tests/rules").join(file)).unwrap_or_else(|error| panic!("{error}"))
}

/// Runs on a thread with the stack that threads usually have. Overflowing it would end the whole process.
fn run(mut rules: RuleFile, start: &str, values: &[(&str, f64)], shape: Shape) -> Result<Model, Error> {
    values.iter().for_each(|(name, value)| rules.set(name, (*value).into()).expect("an attribute"));
    let limits = Limits { depth: 1_000_000, ..Limits::default() };
    let start = (!start.is_empty()).then(|| start.to_owned());
    let settings = Settings { limits, start, ..Settings::default() };
    let thread = std::thread::Builder::new().stack_size(2 * 1024 * 1024);
    thread.spawn(move || rules.generate_with(&shape, &settings)).expect("a thread").join().expect("no panic")
}

fn lot() -> Shape {
    Shape::cuboid(8.0, 8.0, 8.0)
}

fn names(model: &Model) -> Vec<&str> {
    model.leaves().map(|leaf| leaf.rule()).collect()
}

#[test]
fn deep_rules_end_where_the_limits_allow_it() {
    assert_eq!(names(&run(load("Down"), "", &[], lot()).expect("no limit")), ["End"]);
    for name in ["Heavy", "Changing"] {
        assert_eq!(run(load(name), "", &[], lot()).expect("no limit").count("End"), 1, "{name}");
    }
    assert_eq!(run(open("chain.cga"), "", &[], lot()).expect("no limit").counts(), [("X", 2000), ("End", 1)]);
}

#[test]
fn functions_nest_as_deep_as_documented() {
    let functions = load("Functions");
    let sum = |depth| run(functions.clone(), "Sum", &[("depth", depth)], lot());
    assert_eq!(sum(1000.0).expect("no limit").leaves().next().expect("a leaf").size().x, 1000.0);
    assert_eq!(names(&run(functions.clone(), "Even", &[("depth", 1001.0)], lot()).expect("no limit")), ["Odd"]);
    let error = sum(1e9).expect_err("too deep");
    assert_eq!(error, Error::Limit { what: LimitKind::Nesting, limit: 1024, trail: vec!["Sum".into()] });
    assert!(run(functions.clone(), "Text", &[("depth", 100.0)], lot()).is_ok());
    let error = run(functions, "Text", &[("depth", 1e9)], lot()).expect_err("too deep");
    assert!(matches!(error, Error::Limit { what: LimitKind::Nesting, limit: 100..1024, .. }), "{error}");
}

#[test]
fn functions_of_components_are_counted_as_what_they_are() {
    let divided = load("Divided");
    let shape = Shape::rectangle(8.0, 8.0);
    for (start, fits) in [("Valued", 100.0), ("Asked", 50.0)] {
        let model = run(divided.clone(), start, &[("depth", fits)], shape.clone()).expect("no limit");
        assert_eq!(model.leaves().next().expect("a leaf").size().x, fits, "{start}");
        let error = run(divided.clone(), start, &[("depth", 1e9)], shape.clone()).expect_err("too deep");
        assert!(matches!(error, Error::Limit { what: LimitKind::Nesting, limit: 50..1024, .. }), "{start}: {error}");
    }
}

#[test]
fn functions_and_rules_with_many_locals_fit_together() {
    let wide = open("wide.cga");
    let deepest = |start: &str| match run(wide.clone(), start, &[("depth", 1e9)], lot()) {
        Err(Error::Limit { what: LimitKind::Nesting, limit, .. }) => limit as f64,
        other => panic!("{start}: {:?}", other.map(|_| ())),
    };
    for start in ["Arrays", "Texts", "Mixed", "Both"] {
        let deepest = deepest(start);
        assert!(run(wide.clone(), start, &[("depth", deepest - 600.0)], lot()).is_ok(), "{start}");
    }
    for start in ["Locals", "Steps"] {
        assert_eq!(names(&run(wide.clone(), start, &[("depth", 0.0)], lot()).expect("no limit")), ["End"], "{start}");
    }
    let model = run(open("functions.cga"), "", &[], lot()).expect("no limit");
    assert_eq!(model.leaves().next().expect("a leaf").size().x, 159.0);
}

#[test]
fn operands_find_stack_or_end_with_an_error() {
    let inlining = load("Inlining");
    for start in ["Recursive", "AfterDeep", "AllTheWay", "Modified"] {
        assert_eq!(names(&run(inlining.clone(), start, &[], lot()).expect("enough stack")), ["End"], "{start}");
    }
    for start in ["Nested", "Recomposed"] {
        let nested = |nested| run(inlining.clone(), start, &[("nested", nested)], lot());
        assert_eq!(names(&nested(12.0).expect("enough stack")), ["End"]);
        let error = nested(100_000.0).expect_err("operands nest too deep");
        assert!(matches!(error, Error::Limit { what: LimitKind::Depth, .. }), "{start}: {error}");
    }
}
