//! Every run can be stopped: watches are asked before and inside long operations.

use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, OnceLock};
use std::time::Duration;

use cga::{Error, Grammar, Settings, Shape, Text, Watch, cga};
use cga_lang::ops::{Changes, Operation, all_operations};
use cga_tests::stopped::{Every, MOST_UNITS, bounds, rules, shapes, sphere};

/// The operations that may read or change a whole mesh.
fn whole_operations() -> impl Iterator<Item = &'static Operation> {
    all_operations().filter(|operation| operation.changes == Changes::Whole && operation.old.is_none())
}

#[test]
fn every_operation_that_is_not_slim_has_a_row() {
    let text = include_str!("../rules/one_operation.cga");
    for operation in whole_operations() {
        let name = operation.name;
        let is_call =
            |at: usize| !text[..at].ends_with(char::is_alphanumeric) && text[at + name.len()..].starts_with(['(', ' ']);
        let is_there = text.match_indices(name).any(|(at, _)| is_call(at));
        assert!(is_there, "`{name}` has no rule in tests/rules/one_operation.cga");
    }
}

/// A watch whose time ends with the question after number `last`.
pub(crate) fn after(last: u64) -> Watch {
    let count = AtomicU64::new(0);
    Watch::deadline_by(Duration::from_secs(1), move || {
        if count.fetch_add(1, Ordering::Relaxed) <= last { Duration::ZERO } else { Duration::MAX }
    })
}

/// The longest work between two questions, and the number of questions, of a run that is stopped at the question after `last`.
fn questions(rule: &str, shape: &Shape, last: u64) -> (u64, u64) {
    let own: Arc<OnceLock<Watch>> = Arc::default();
    let (count, told, most) = (Arc::new(AtomicU64::new(0)), AtomicU64::new(0), Arc::new(AtomicU64::new(0)));
    let (asked, seen, longest) = (own.clone(), count.clone(), most.clone());
    let watch = Watch::deadline_by(Duration::from_secs(1), move || {
        let work = asked.get().map_or(0, |watch| watch.progress().work);
        longest.fetch_max(work - told.swap(work, Ordering::Relaxed), Ordering::Relaxed);
        if seen.fetch_add(1, Ordering::Relaxed) <= last { Duration::ZERO } else { Duration::MAX }
    });
    let _ = own.set(watch.clone());
    let settings = Settings { start: Some(rule.to_owned()), watch: Some(watch.clone()), ..Settings::default() };
    let model = Every::default().generate_with(shape, &settings);
    let count = count.load(Ordering::Relaxed);
    let is_stopped = last + 1 < count;
    match model {
        Ok(model) => assert_eq!(model.report().stopped, is_stopped, "{rule}"),
        Err(error) => assert!(!is_stopped && matches!(error, Error::Limit { .. }), "{rule}: {error}"),
    }
    (most.load(Ordering::Relaxed), count)
}

#[test]
fn every_operation_asks_its_watch() {
    let shapes = shapes();
    let (rules, bounds) = (rules(), bounds());
    for (number, rule) in rules.iter().enumerate() {
        for (kind, shape) in shapes.iter().enumerate() {
            // Runs are long in a build without optimisation, so each is stopped early, at different questions.
            let (most, count) = questions(rule, shape, 1 + (number + kind) as u64 % 4);
            let bound = bounds[number].1;
            assert!(1 < count && most <= bound, "{rule}: {most} units between two of {count} questions, not {bound}");
        }
    }
}

/// Operations that do not read all faces of the shape of the test again, and why.
const CONSTANT: [(&str, &str); 18] = [
    ("primitiveQuad", "replaces the mesh"),
    ("primitiveDisk", "replaces the mesh"),
    ("primitiveCube", "replaces the mesh"),
    ("primitiveSphere", "replaces the mesh"),
    ("primitiveCylinder", "replaces the mesh"),
    ("primitiveCone", "replaces the mesh"),
    ("taper", "refuses a mesh of several faces"),
    ("resetGeometry", "takes the mesh of the initial shape"),
    ("trim", "finds no trim plane"),
    ("deleteTags", "finds no tags"),
    ("setTagsFromEdgeAttrs", "finds no attributes of edges"),
    ("translate", "moves the scope"),
    ("r", "turns the scope"),
    ("rotate", "turns the scope"),
    ("center", "moves the scope"),
    ("setMaterial", "changes the look"),
    ("resetMaterial", "changes the look"),
    ("i", "replaces the mesh"),
];

/// The rules that begin with an operation.
fn rules_of(operation: &str) -> Vec<&'static str> {
    let lines = include_str!("../rules/one_operation.cga").lines().filter_map(|line| line.split_once(" --> "));
    let begins = |body: &str| body.strip_prefix(operation).is_some_and(|rest| rest.starts_with(['(', ' ']));
    lines.filter(|(rule, body)| rule.starts_with('R') && begins(body)).map(|(rule, _)| rule).collect()
}

/// The work of a run that is stopped after an amount of work, in units.
fn work(rule: &str, shape: &Shape, most: u64) -> u64 {
    let own: Arc<OnceLock<Watch>> = Arc::default();
    let asked = own.clone();
    let watch = Watch::deadline_by(Duration::from_secs(1), move || {
        let work = asked.get().map_or(0, |watch| watch.progress().work);
        if work < most { Duration::ZERO } else { Duration::MAX }
    });
    let _ = own.set(watch.clone());
    let settings = Settings { start: Some(rule.to_owned()), watch: Some(watch.clone()), ..Settings::default() };
    drop(Every::default().generate_with(shape, &settings));
    watch.progress().work
}

/// An operation that reads or makes all faces counts more than their corners, which each operation and each leaf count. It asks once
/// for each 65,536 units.
#[test]
fn every_operation_counts_the_faces_of_a_large_mesh() {
    let shape = sphere(100);
    // The shape is read for the leaf, and for an operation.
    let least = 2 * work("A", &shape, u64::MAX) + 1;
    for operation in whole_operations() {
        let rules = rules_of(operation.name);
        assert!(!rules.is_empty(), "no rule begins with `{}`", operation.name);
        let is_constant = CONSTANT.iter().any(|(name, _)| *name == operation.name);
        for rule in rules {
            let work = work(rule, &shape, least);
            assert_eq!(work < least, is_constant, "`{}` ({rule}): {work} units of at least {least}", operation.name);
        }
    }
}

#[test]
fn every_rule_has_a_bound() {
    let (bounds, rules) = (bounds(), rules());
    assert!(
        bounds.iter().map(|(rule, _)| *rule).eq(rules.iter().map(Text::as_str)),
        "the bench `stopping` writes them"
    );
    for (rule, units) in bounds {
        assert!(units <= MOST_UNITS, "{rule}: {units}");
    }
}

/// What rules read of a large mesh is work, also where no operation follows.
#[test]
fn rules_that_only_measure_are_stopped() {
    let rules = cga! {
        @StartRule
        Loop --> primitiveSphere(100, 50) Measured(0)
        Measured(n) --> case n == 1000 : X. else : report("size", geometry.volume + geometry.area) Measured(n + 1)
        @StartRule
        Calls --> primitiveSphere(100, 50) report("size", sum(0)) X.
        sum(n) = case n == 150 : 0 else : geometry.volume + sum(n + 1)
    };
    for start in ["Loop", "Calls"] {
        let settings = Settings { start: Some(start.to_owned()), watch: Some(after(40)), ..Settings::default() };
        let model = rules.generate_with(&Shape::cuboid(1.0, 1.0, 1.0), &settings).expect("no limit");
        assert!(model.report().stopped && model.report().shapes < 300, "{start}: {}", model.report().shapes);
    }
}

/// Runs a start rule with a limit of bytes.
fn run_with_bytes(rules: &dyn Grammar, start: &str, bytes: u64) -> Result<cga::Model, Error> {
    let limits = cga::Limits { bytes, ..cga::Limits::default() };
    let settings = Settings { start: Some(start.to_owned()), limits, ..Settings::default() };
    rules.generate_with(&Shape::rectangle(1.0, 1.0), &settings)
}

/// Nested calls hold their arguments.
#[test]
fn long_values_of_nested_calls_have_a_limit_in_all() {
    let rules = cga! {
        @StartRule
        Joined --> Longer("x", 0, false)
        @StartRule
        Cut --> Longer("x", 0, true)
        @StartRule
        Listed --> HeldArray([1:4000], 0)
        Longer(text, n, isCut) -->
            case n < 16 : Longer(text + text, n + 1, isCut)
            case isCut : HeldPart(text, 0)
            else : Held(text, 0)
        HeldPart(text, n) --> case n < 300 : [ HeldPart(listFirst(text), n + 1) ] Told(text) else : X.
        HeldArray(array, n) --> case n < 300 : [ HeldArray(.- array, n + 1) ] Told("" + array[0]) else : X.
        Held(text, n) --> case n < 300 : [ Held(text + n, n + 1) ] Told(text) else : X.
        Told(text) --> case text == "" : Y. else : X.
    };
    for start in ["Joined", "Cut", "Listed"] {
        assert!(run_with_bytes(&rules, start, 30_000_000).is_ok(), "{start}");
        let error = run_with_bytes(&rules, start, 10_000_000).expect_err("20 MB of values");
        assert!(matches!(error, Error::Limit { what: cga::LimitKind::Bytes, .. }), "{start}: {error}");
    }
}

fn long_text(length: f64) -> String {
    "x".repeat(length as usize)
}

fn long_list(length: f64) -> Vec<f64> {
    vec![1.0; length as usize]
}

fn long_texts(length: f64) -> [String; 2] {
    [long_text(length), long_text(length)]
}

/// Each call makes a value of its own.
#[test]
fn results_of_rust_functions_have_a_limit_in_all() {
    let rules = cga! {
        @StartRule
        Text --> Text(0)
        @StartRule
        List --> List(0)
        @StartRule
        Texts --> Texts(0)
        @StartRule
        Short --> Short(0)
        Text(n) --> case n < 100 : HeldText(crate::stopping::long_text(100000), n) else : X.
        HeldText(text, n) --> [ Text(n + 1) ] Told(text)
        List(n) --> case n < 100 : HeldList(crate::stopping::long_list(6250), n) else : X.
        HeldList(list, n) --> [ List(n + 1) ] Told("" + list[0])
        Texts(n) --> case n < 100 : HeldTexts(crate::stopping::long_texts(50000), n) else : X.
        HeldTexts(texts, n) --> [ Texts(n + 1) ] Told(texts[0])
        Short(n) --> case n < 100 : HeldShort(crate::stopping::long_text(200), n) else : X.
        HeldShort(text, n) --> [ Short(n + 1) ] Told(text)
        Told(text) --> case text == "" : Y. else : X.
    };
    for start in ["Text", "List", "Texts"] {
        assert!(run_with_bytes(&rules, start, 11_000_000).is_ok(), "{start}");
        let error = run_with_bytes(&rules, start, 9_000_000).expect_err("10 MB of values");
        assert!(matches!(error, Error::Limit { what: cga::LimitKind::Bytes, .. }), "{start}: {error}");
    }
    // 200 bytes a call do not count.
    assert!(run_with_bytes(&rules, "Short", 100_000).is_ok());
}

/// A run in a sink of a run that was stopped has its own watch, or none.
#[test]
fn a_run_within_a_run_that_was_stopped_goes_on() {
    let inner = cga! { Lot --> extrude(3) union { A. | t(1, 0, 0) A. } B. };
    struct Nested<F>(F);
    impl<F: FnMut()> cga::Sink for Nested<F> {
        fn quad(&mut self, _: &cga::Leaf<'_>, _: &cga::Quad) -> cga::Flow {
            (self.0)();
            cga::Flow::Continue(())
        }
        fn cuboid(&mut self, _: &cga::Leaf<'_>, _: &cga::Cuboid) -> cga::Flow {
            (self.0)();
            cga::Flow::Continue(())
        }
        fn mesh(&mut self, _: &cga::Leaf<'_>, _: &std::sync::Arc<cga::Mesh>, _: &cga::glam::DAffine3) -> cga::Flow {
            (self.0)();
            cga::Flow::Continue(())
        }
    }
    let outer = cga! { Lot --> split(x) { { 0.1 : X. }* } };
    let watch = Watch::new();
    let mut lengths = Vec::new();
    let mut sink = Nested(|| {
        watch.stop();
        lengths.push(inner.generate(&Shape::rectangle(2.0, 2.0)).expect("no limit").len());
    });
    let settings = Settings { watch: Some(watch.clone()), ..Settings::default() };
    outer.run(&Shape::rectangle(1.0, 1.0), &settings, &mut sink).expect("no limit");
    assert!(!lengths.is_empty() && lengths.iter().all(|length| *length == 1), "{lengths:?}");
}

#[test]
fn a_deadline_ends_runs() {
    let over = Settings { watch: Some(Watch::deadline(Duration::ZERO)), ..Settings::default() };
    let model = Every::default().generate_with(&Shape::rectangle(1.0, 1.0), &over).expect("no limit");
    assert!(model.report().stopped && model.is_empty());
    let far = Settings { watch: Some(Watch::deadline(Duration::MAX)), ..Settings::default() };
    let model = Every::default().generate_with(&Shape::rectangle(1.0, 1.0), &far).expect("no limit");
    assert!(!model.report().stopped && !model.is_empty());
}
