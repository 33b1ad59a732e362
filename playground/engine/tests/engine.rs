//! The engine of the page gives the files of compiled rules, and survives mistakes.

use std::collections::BTreeSet;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::Duration;

use cga_playground::catalog::{entries, entry};
use cga_playground::chain::Trees;
use cga_playground::compiled;
use cga_playground::engine::{Answer, Engine};
use cga_playground::lot::Lot;
use cga_playground::request::Request;
use serde_json::{Value, json};

/// A clock that stands still: runs take as long as they need, whatever else the machine does.
fn clock() -> Duration {
    Duration::ZERO
}

/// A clock on which a second passes between two looks.
fn fast_clock() -> Duration {
    static SECONDS: AtomicU64 = AtomicU64::new(0);
    Duration::from_secs(SECONDS.fetch_add(1, Ordering::Relaxed))
}

/// A request for the page's own rules.
fn own(rules: &str) -> Request {
    Request { rules: Some(rules.to_owned()), ..Request::of("house") }
}

fn facts(answer: &Answer) -> &Value {
    answer.facts.as_ref().unwrap_or_else(|| panic!("{answer:?}"))
}

#[test]
fn names_differ() {
    let names: BTreeSet<&str> = entries().iter().map(|entry| entry.name()).collect();
    assert_eq!(names.len(), entries().len());
    assert!(entry("tower").is_some() && entry("towre").is_none());
}

#[test]
fn loaded_rules_give_the_files_of_compiled_rules() {
    let mut engine = Engine::new(clock);
    for entry in entries() {
        let name = entry.name();
        let request = Request { seed: Some(entry.seed() + 1), ..Request::of(name) };
        let answer = engine.answer(&request);
        assert_eq!((answer.findings.as_slice(), &answer.error), (&[][..], &None), "{name}");
        assert_eq!(facts(&answer)["faults"], json!([]), "{name}");
        let own = engine.last().expect("a run").glb().expect("a file");
        assert!(own == compiled::glb(&request).expect("a file"), "{name}");
    }
}

/// A reset of an attribute goes to its default, so the page would show a reset that changes nothing.
#[test]
fn grammars_begin_with_their_defaults() {
    let mut engine = Engine::new(clock);
    for entry in entries() {
        let answer = engine.answer(&Request::of(entry.name()));
        for attribute in facts(&answer)["attributes"].as_array().expect("a list") {
            assert_eq!(attribute["value"], attribute["default"], "{}: {}", entry.name(), attribute["name"]);
        }
    }
}

#[test]
fn each_leaf_has_a_line() {
    let mut engine = Engine::new(clock);
    for entry in entries() {
        let answer = engine.answer(&Request::of(entry.name()));
        let lines = entry.rules().lines().count() as u64;
        for rule in facts(&answer)["rules"].as_array().expect("a list") {
            let shown = rule["lines"].as_array().expect("a list");
            let exist = shown.iter().all(|line| (1..=lines).contains(&line.as_u64().unwrap_or_default()));
            assert!(!shown.is_empty() && exist, "{}: {rule}", entry.name());
        }
    }
}

#[test]
fn a_mistake_keeps_the_last_run() {
    let mut engine = Engine::new(clock);
    assert_eq!(facts(&engine.answer(&own("Lot --> extrude(3) Mass.")))["report"]["leaves"], 1);
    let answer = engine.answer(&own("Lot --> extrude(height) Mass."));
    assert!(answer.facts.is_none() && answer.findings.iter().any(|finding| finding.is_error), "{answer:?}");
    assert_eq!(engine.last().map(|run| run.model.len()), Some(1));
    let answer = engine.answer(&own("Lot --> extrude(3) split(y) { ~1 : A. | ~1 : B. }"));
    assert_eq!(facts(&answer)["report"]["leaves"], 2);
}

#[test]
fn values_that_rules_do_not_take_are_named() {
    let mut engine = Engine::new(clock);
    let rules =
        "@Range(min = 1, max = 9) attr height = 3\nattr wide = 2\nLot --> extrude(height) s('1, '1, wide) Mass.";
    let values = json!({ "height": 90, "wide": 5, "nothing": 1 }).as_object().cloned().unwrap_or_default();
    let answer = engine.answer(&Request { values, ..own(rules) });
    assert_eq!(answer.refused.keys().collect::<Vec<_>>(), ["height", "nothing"]);
    assert_eq!(facts(&answer)["used"], json!({ "height": [3.0], "wide": [5.0] }));
}

#[test]
fn endless_rules_end() {
    let mut engine = Engine::new(fast_clock);
    for rules in [
        "Lot --> extrude(3) A\nA --> s('1, '1, '1) [ A ] A",
        "f(n) = case n < 0 : 0 else : f(n + 1) + f(n + 1)\nLot --> extrude(f(1)) Mass.",
        "Lot --> split(x) { 0.00001 : A. }*",
    ] {
        let answer = engine.answer(&own(rules));
        assert!(answer.error.is_some() || answer.facts.is_none() || facts(&answer)["faults"] != json!([]), "{rules}");
    }
    let slow = "Lot --> split(x) { 0.01 : split(z) { 0.01 : extrude(1) comp(f) { all : A. } }* }*";
    let why = engine.answer(&own(slow)).error.expect("an error");
    assert!(why.contains("was ended after 10 seconds"), "{why}");
}

#[test]
fn a_lot_and_a_start_rule_are_chosen() {
    let mut engine = Engine::new(clock);
    let rules = "Lot --> extrude(3) Mass.\nOther --> extrude(9) Tall.";
    let request = Request { lot: Some(Lot::Rectangle(4.0, 5.0)), start: Some("Other".into()), ..own(rules) };
    let answer = engine.answer(&request);
    assert_eq!(
        (&facts(&answer)["high"], &facts(&answer)["rules"][0]["name"]),
        (&json!([4.0, 9.0, 5.0]), &json!("Tall"))
    );
    // A start rule that is not in the rules any more leaves the choice to the rules.
    let answer = engine.answer(&Request { rules: Some("Lot --> extrude(3) Mass.".into()), ..request });
    assert_eq!(facts(&answer)["high"], json!([4.0, 3.0, 5.0]));
}

#[test]
fn a_part_has_its_chain_of_rules() {
    let mut engine = Engine::new(clock);
    let rules = "attr height = 6\nLot --> extrude(height) split(y) { ~3 : Floor(split.index) }*\nFloor(n) --> s('1, '1, 2 + n) Mass.";
    engine.answer(&own(rules));
    let run = engine.last().expect("a run");
    let chain = Trees::default().chain(run, 1, clock).expect("a chain");
    let chain: Value = serde_json::from_str(&chain).expect("JSON");
    let names: Vec<&Value> = chain["steps"].as_array().expect("a list").iter().map(|step| &step["rule"]).collect();
    assert_eq!(names, ["Lot", "Floor", "Mass"]);
    assert_eq!((&chain["lot"], &chain["attributes"]), (&json!(0), &json!({ "height": 6.0 })));
    let floor = &chain["steps"][1];
    assert_eq!(
        (&floor["lines"], &floor["size"], &floor["origin"]),
        (&json!([3]), &json!([20.0, 3.0, 15.0]), &json!([0.0, 3.0, 0.0]))
    );
    assert_eq!(floor["arguments"], json!([1.0]));
    assert_eq!((&floor["number"], &floor["siblings"]), (&json!(1), &json!(2)));
    assert!(Trees::default().chain(run, 7, clock).is_err());
    // Each leaf of a scene with many lots has one.
    engine.answer(&Request::of("massing"));
    let run = engine.last().expect("a run");
    let mut trees = Trees::default();
    for (leaf, view) in run.model.leaves().enumerate().step_by(97) {
        let chain: Value = serde_json::from_str(&trees.chain(run, leaf, clock).expect("a chain")).expect("JSON");
        let last = chain["steps"].as_array().and_then(|steps| steps.last()).expect("a step");
        assert_eq!((&last["rule"], &last["isLeaf"]), (&json!(view.rule()), &json!(true)));
    }
}

#[test]
fn files_have_the_model() {
    let mut engine = Engine::new(clock);
    engine.answer(&own("Lot --> extrude(3) split(x) { ~1 : A. | ~1 : B. }"));
    let run = engine.last().expect("a run");
    let by_rule = run.glb_by_rule().expect("a file");
    assert!(by_rule.starts_with(b"glTF") && by_rule != run.glb().expect("a file"));
    let (obj, mtl) = run.obj("house.mtl");
    assert!(obj.starts_with("mtllib house.mtl") && obj.contains("g A") && mtl.contains("newmtl"), "{obj}");
}

#[test]
fn small_models_are_shown_without_cracks() {
    let mut engine = Engine::new(clock);
    // Two bays beside four: corners lie inside of edges.
    let bays = "split(z) { ~1 : split(x) { { '0.5 : A. }* } | ~1 : split(x) { { '0.25 : B. }* } }";
    engine.answer(&own(&format!("Lot --> {bays}")));
    let run = engine.last().expect("a run");
    assert!(run.glb().expect("a file").len() < run.view_glb().expect("a file").len());
    engine.answer(&own(&format!("Lot --> split(x) {{ {{ '0.0005 : Row }}* }} Row --> {bays}")));
    let run = engine.last().expect("a run");
    assert_eq!(run.model.len(), 12_000);
    assert_eq!(run.glb().expect("a file"), run.view_glb().expect("a file"));
}
