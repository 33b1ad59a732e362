//! `docs/diagnostics.md`: each code has a heading, the bad example has that finding and no other, the good one has
//! none.

use crate::common::parts::Parts;
use cga_lang::diag::Level;
use cga_lang::diag::code::Code;
use std::fs;
use std::path::Path;

/// The text and the examples under a heading.
struct Entry {
    name: String,
    text: String,
    examples: Vec<String>,
}

fn page() -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/diagnostics.md");
    fs::read_to_string(path).expect("the page")
}

fn entries() -> Vec<Entry> {
    let page = page();
    let mut list: Vec<Entry> = Vec::new();
    let mut open = false;
    for line in page.lines() {
        if let Some(name) = line.strip_prefix("### `").and_then(|rest| rest.strip_suffix('`')) {
            list.push(Entry { name: name.into(), text: String::new(), examples: Vec::new() });
            continue;
        }
        let Some(entry) = list.last_mut() else { continue };
        match (line, open) {
            ("```cga", false) => {
                entry.examples.push(String::new());
                open = true;
            }
            ("```", true) => open = false,
            (line, true) => {
                let example = entry.examples.last_mut().expect("one is open");
                example.push_str(line);
                example.push('\n');
            }
            (line, false) => entry.text.push_str(line),
        }
    }
    list
}

/// The findings of an example: of one that is no file, unless it imports some.
fn found(example: &str) -> Vec<(Code, Level)> {
    let mut parts = Parts::new(example);
    let diags =
        if example.contains("// file: ") { parts.compile().diags } else { crate::common::compiled(example).0.diags };
    diags.into_iter().map(|diag| (diag.code, diag.level)).collect()
}

#[test]
fn every_code_has_a_heading_and_no_heading_is_left_over() {
    let headings: Vec<String> = entries().into_iter().map(|entry| entry.name).collect();
    let codes: Vec<&str> = Code::ALL.iter().map(|code| code.name()).collect();
    assert_eq!(headings, codes);
}

#[test]
fn the_table_has_a_row_for_every_code() {
    let rows: Vec<String> = page().lines().filter(|line| line.starts_with("| [`")).map(str::to_owned).collect();
    let row = |code: &Code| {
        let (name, level) = (code.name(), if code.level() == Level::Error { "error" } else { "warning" });
        format!("| [`{name}`](#{name}) | {level} | {} |", code.about())
    };
    assert_eq!(rows, Code::ALL.iter().map(row).collect::<Vec<_>>());
}

#[test]
fn a_heading_says_the_level_and_what_the_code_means() {
    for (entry, &code) in entries().iter().zip(Code::ALL) {
        let level = if code.level() == Level::Error { "Error" } else { "Warning" };
        let start = format!("{level}: {}", code.about());
        let said = entry.text.get(..start.len()).unwrap_or_default();
        assert!(said.eq_ignore_ascii_case(&start), "{}: {said}", entry.name);
    }
}

#[test]
fn bad_examples_have_that_finding_alone_and_good_ones_have_none() {
    let mut wrong = Vec::new();
    for entry in entries() {
        let [bad, good] = entry.examples.as_slice() else { panic!("{}: a bad and a good example", entry.name) };
        let (bad, good) = (found(bad), found(good));
        if bad.is_empty() || bad.iter().any(|(code, _)| code.name() != entry.name) || !good.is_empty() {
            wrong.push((entry.name, bad, good));
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}
