//! `tests/data/check`: what is found, and where. With them the reference, which changes with the same tables.

use cga_lang::diag::Diags;
use cga_lang::diag::code::Code;
use std::collections::HashSet;
use std::fs;

#[test]
fn findings_stand_under_the_guilty_tokens() {
    crate::common::walk("check", |text| {
        let (compiled, lexed) = crate::common::compiled(text);
        (compiled.diags, lexed, None)
    });
}

#[test]
fn every_code_has_a_fixture() {
    let mut seen = HashSet::new();
    for folder in ["lex", "parse", "check", "lower"] {
        for path in crate::common::fixtures(folder) {
            let text = crate::common::strip(&fs::read_to_string(path).expect("readable fixture"));
            seen.extend(crate::common::compiled(&text).0.diags.iter().map(|diag| diag.code));
        }
    }
    for path in crate::common::fixtures("link") {
        let text = crate::common::strip(&fs::read_to_string(path).expect("readable fixture"));
        seen.extend(crate::common::parts::Parts::new(&text).compile().diags.iter().map(|diag| diag.code));
    }
    let missing: Vec<&str> = Code::ALL.iter().filter(|code| !seen.contains(code)).map(|code| code.name()).collect();
    assert_eq!(missing, [] as [&str; 0]);
}

#[test]
fn code_names_are_unique_and_found_again() {
    for &code in Code::ALL {
        assert_eq!(Code::from_name(code.name()), Some(code));
    }
}

#[test]
fn messages_follow_the_house_style() {
    for folder in ["lex", "parse", "check", "lower"] {
        for path in crate::common::fixtures(folder) {
            let text = crate::common::strip(&fs::read_to_string(path).expect("readable fixture"));
            for diag in crate::common::compiled(&text).0.diags {
                let lines = diag.reasons().map(|note| note.text).chain(diag.help.clone()).chain([diag.message.clone()]);
                for line in lines.map(|line| line.to_string()) {
                    assert!(!line.ends_with('.') && !line.is_empty(), "{line}");
                    assert!(!line.starts_with(char::is_uppercase), "{line}");
                }
            }
        }
    }
}

#[test]
#[should_panic(expected = "diagnostics were dropped unread")]
fn findings_cannot_be_dropped_unread() {
    drop(Diags::new());
}
