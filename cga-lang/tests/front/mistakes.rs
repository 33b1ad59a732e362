//! `tests/data/mistakes`: mistakes of beginners with the token and the proposal that a first message must have,
//! and unusual rules without a mistake. The first forty mistakes and all rules were written before the checks were looked at.

use std::fmt::Write;
use std::fs;
use std::path::Path;

use cga_lang::snippet::bytes;

/// A title, and the lines below it.
struct Case {
    title: String,
    text: String,
    /// The text that is underlined.
    at: String,
    /// A part of the message, its notes or its help.
    help: String,
}

fn cases(file: &str) -> Vec<Case> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/mistakes").join(file);
    let text = fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    let mut list: Vec<Case> = Vec::new();
    for line in text.lines() {
        if let Some(title) = line.strip_prefix("== ") {
            list.push(Case { title: title.into(), text: String::new(), at: String::new(), help: String::new() });
            continue;
        }
        let case = list.last_mut().expect("a title comes first");
        if let Some(at) = line.strip_prefix("at: ") {
            case.at = at.into();
        } else if let Some(help) = line.strip_prefix("help: ") {
            case.help = help.into();
        } else {
            case.text += &format!("{line}\n");
        }
    }
    list
}

#[test]
fn the_first_message_about_a_mistake_proposes_the_right_text_at_the_right_token() {
    let (mut wrong, list) = (String::new(), cases("mistakes.txt"));
    assert_eq!(list.len(), 60);
    for Case { title, text, at, help } in &list {
        assert!(!at.is_empty() && !help.is_empty(), "{title}");
        let (compiled, lexed) = crate::common::compiled(text);
        let mut found = compiled.diags;
        found.sort_by_key(|diag| bytes(text, &lexed.ranges, diag.span).start);
        let Some(first) = found.first() else {
            let _ = writeln!(wrong, "{title}: nothing is found\n{text}");
            continue;
        };
        let underlined = &text[bytes(text, &lexed.ranges, first.span)];
        let notes = first.reasons().map(|note| note.text.to_string());
        let lines: Vec<String> = [first.message.to_string()]
            .into_iter()
            .chain(notes)
            .chain(first.help.iter().map(ToString::to_string))
            .collect();
        if underlined != at || !lines.iter().any(|line| line.contains(help.as_str())) {
            let _ = writeln!(
                wrong,
                "{title}\n{text}  at `{underlined}`, expected `{at}`\n  {}\n  expected: {help}",
                lines.join("\n  ")
            );
        }
    }
    assert!(wrong.is_empty(), "{wrong}");
}

#[test]
fn unusual_rules_have_no_finding() {
    let list = cases("legal.txt");
    assert_eq!(list.len(), 24);
    let mut wrong = String::new();
    for Case { title, text, .. } in list {
        for diag in crate::common::compiled(&text).0.diags {
            let _ = writeln!(wrong, "{title}\n{text}  {}", diag.message);
        }
    }
    assert!(wrong.is_empty(), "{wrong}");
}
