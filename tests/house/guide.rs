//! The guide: its rules are taken from the examples that make its pictures.

use std::fs;
use std::path::{Path, PathBuf};

use cga_tests::tree::root;

fn read(path: impl AsRef<Path>) -> String {
    let path = root().join(path);
    fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// The code blocks of a text.
fn blocks(text: &str) -> impl Iterator<Item = &str> {
    text.split("```rust\n").skip(1).map(|rest| rest.split("```").next().unwrap_or_default())
}

#[test]
fn the_rules_of_a_step_are_those_of_its_example() {
    let text = read("docs/guide/tutorial.md");
    let steps: Vec<&str> = text.split("\n## ").skip(1).collect();
    assert_eq!(steps.len(), 10);
    for (number, step) in (1..).zip(steps) {
        let example = read(format!("examples/guide/step_{number:02}.rs"));
        assert!(
            step.starts_with(&format!("{number}. ")) && step.contains(&format!("(step-{number:02}.png)")),
            "{step}"
        );
        let rules = blocks(step).next().expect("the rules of the step");
        let mut rest = example.as_str();
        for line in rules.lines().filter(|line| !line.trim().is_empty()) {
            // In this order, with other lines between them.
            let found = rest.find(&format!("{line}\n")).unwrap_or_else(|| panic!("step {number} has no line {line:?}"));
            rest = &rest[found + line.len()..];
        }
    }
}

#[test]
fn links_of_the_guide_lead_to_files() {
    let folder = root().join("docs/guide");
    let files = fs::read_dir(&folder).expect("the guide").map(|entry| entry.expect("an entry").path());
    let texts: Vec<PathBuf> = files.filter(|path| path.extension().is_some_and(|end| end == "md")).collect();
    assert!(texts.len() >= 2);
    for path in texts {
        let text = fs::read_to_string(&path).expect("text");
        let targets = text.split("](").skip(1).filter_map(|rest| rest.split(')').next());
        for target in targets.filter(|target| !target.starts_with("https://")) {
            let target = target.split('#').next().unwrap_or_default();
            assert!(target.is_empty() || folder.join(target).exists(), "{}: {target}", path.display());
        }
    }
}
