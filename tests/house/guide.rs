//! The guide: its rules are the rules of the examples that make its pictures, and its questions have answers.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use super::links::slug;
use cga_tests::tree::root;
use cga_tests::tutorial::{Declaration, INLINE, declarations, steps, text};

fn read(path: impl AsRef<Path>) -> String {
    let path = root().join(path);
    fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// Declarations by name, with single spaces.
fn by_name(list: Vec<Declaration>) -> BTreeMap<String, String> {
    let text = |lines: &[String]| lines.join(" ").split_whitespace().collect::<Vec<_>>().join(" ");
    list.into_iter().map(|declaration| (declaration.name, text(&declaration.lines))).collect()
}

/// So a reader has the rules that make the pictures.
#[test]
fn the_rules_of_each_step_lead_to_its_example() {
    for step in steps() {
        let number = step.number;
        let picture = format!("[step-{number:02}]");
        assert!(step.text.starts_with(&format!("{number}. ")) && step.text.contains(&picture), "{}", step.text);
        let example = read(format!("examples/guide/step_{number:02}.rs"));
        let (_, rules) = example.split_once("pub grammar House;\n").expect("a grammar");
        let rules = rules.trim_end().strip_suffix("\n}").expect("an end");
        assert_eq!(step.rules.iter().find(|own| own.lines.concat().contains("-->")).expect("a rule").name, "Lot");
        assert_eq!(by_name(step.rules), by_name(declarations(rules)), "step {number}");
    }
}

/// Step 11 says which characters to change.
#[test]
fn the_rule_file_of_the_tutorial_has_the_rules_of_the_last_step() {
    let last = steps().pop().expect("a step");
    let lines: Vec<String> = last.rules.into_iter().flat_map(|declaration| declaration.lines).collect();
    let rules = lines.join("\n").replace("^1", "'1");
    let file: String = read("docs/guide/house.cga").lines().skip(1).map(|line| format!("    {line}\n")).collect();
    assert_eq!(by_name(declarations(&rules)), by_name(declarations(&file)));
    assert_eq!(text().matches("\n## ").count(), INLINE + 3);
}

/// Each question with a word of its answer.
const QUESTIONS: [(&str, &str); 16] = [
    ("a mesh of my own", "Assets::below"),
    ("one mesh for each material", "Granularity::Material"),
    ("images on walls and roofs", "setupProjection"),
    ("The model has faults", "FaultKind::Asset"),
    ("keep its random values", "Shape::seed"),
    ("a simpler model for the distance", "attr level"),
    ("heights and colours from a table", "Grammars"),
    ("take changed rules", "Live::new"),
    ("into my engine", "bevy_cga"),
    ("from Python", "pycga.RuleFile"),
    ("3D Tiles of a city", "cga-city"),
    ("bound time and memory", "Watch::deadline"),
    ("know which face it has", "isTagged"),
    ("streets and junctions", "Network::new"),
    ("a format of my own", "impl Sink for"),
    ("move over from CityEngine", "cga check"),
];

/// From the README in two clicks: to the page of questions, or to the page of the answer, and to the answer.
#[test]
fn each_question_is_answered_at_most_two_clicks_from_the_readme() {
    assert!(read("README.md").contains("[questions]: docs/guide/questions.md"), "the first click");
    let page = read("docs/guide/questions.md");
    let questions: Vec<&str> = page.lines().filter_map(|line| line.strip_prefix("- ")).collect();
    assert_eq!(questions.len(), QUESTIONS.len());
    for (question, (words, answer)) in questions.into_iter().zip(QUESTIONS) {
        assert!(question.contains(words), "{question}: {words}");
        let label = question.rsplit_once('[').expect("a link").1.trim_end_matches(']');
        let target = page.lines().find_map(|line| line.strip_prefix(&format!("[{label}]: "))).expect("a definition");
        let (file, anchor) = target.split_once('#').unwrap_or((target, ""));
        let text = read(PathBuf::from("docs/guide").join(file));
        let section = section(&text, anchor).unwrap_or_else(|| panic!("{file} has no heading {anchor}"));
        assert!(section.contains(answer), "{target} does not mention {answer}");
    }
}

/// The text below a heading, to the next one of its level.
fn section(text: &str, anchor: &str) -> Option<String> {
    if anchor.is_empty() {
        return Some(text.into());
    }
    text.split("\n## ").find(|part| slug(part.lines().next().unwrap_or_default()) == anchor).map(str::to_owned)
}
