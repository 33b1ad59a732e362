//! `docs/reference.md`: every word of the tables has a text, an example without mistakes, and an entry on the page.

use cga_lang::compile::compile_text;
use cga_lang::diag::Level;
use cga_lang::diag::code::Code;
use cga_lang::reference::{Doc, Entry, Section, docs, entries, page, page_title};
use cga_lang::syntax::lex::lex;
use std::collections::{HashMap, HashSet};
use std::fs;
use std::path::Path;

/// The words of the texts.
fn words(docs: &[Doc]) -> Vec<(Section, &'static str)> {
    docs.iter().flat_map(|doc| doc.names().map(|name| (doc.section, name))).collect()
}

#[test]
fn every_word_of_the_tables_has_one_text() {
    let docs = docs();
    let known: HashSet<(Section, &str)> = entries().iter().map(|entry| (entry.section, entry.name)).collect();
    let mut met = HashSet::new();
    for word in words(&docs) {
        assert!(met.insert(word), "{word:?} has two texts");
    }
    let missing: Vec<_> = known.difference(&met).collect();
    let unknown: Vec<_> = met.difference(&known).collect();
    assert!(missing.is_empty(), "write about these in cga-lang/src/reference: {missing:#?}");
    assert!(unknown.is_empty(), "no table has these: {unknown:#?}");
}

#[test]
fn texts_are_sentences_and_pages_exist() {
    for doc in docs() {
        let Doc { name, text, page, example, group, .. } = doc;
        assert!(text.starts_with(char::is_uppercase) && text.ends_with('.') && 20 < text.len(), "{name}: {text}");
        assert!(!example.is_empty() && !group.is_empty(), "{name}");
        assert!(page_title(page).is_some_and(|title| !title.is_empty()), "{name}: page `{page}`");
        let signature = doc.signature.unwrap_or_default();
        assert_eq!(signature.starts_with(&format!("@{name}")), doc.section == Section::Annotation, "{name}");
    }
}

/// Returns true if a word occurs among the tokens of an example, and not only as part of another name.
fn uses(example: &str, word: &str) -> bool {
    let tokens =
        |text: &str| -> Vec<String> { lex(text).tokens.as_slice().iter().map(|token| format!("{token:?}")).collect() };
    let (example, word) = (tokens(example), tokens(word));
    !word.is_empty() && example.windows(word.len()).any(|part| *part == word[..])
}

#[test]
fn examples_use_their_word_and_have_no_mistakes() {
    let entries = entries();
    let known: HashMap<(Section, &str), &Entry> = entries.iter().map(|own| ((own.section, own.name), own)).collect();
    let mut wrong = Vec::new();
    for doc in docs() {
        for name in doc.names() {
            if !uses(doc.example, name) {
                wrong.push(format!("the example of `{name}` does not use it: {}", doc.example));
            }
        }
        let states = || doc.names().filter_map(|name| known.get(&(doc.section, name))).flat_map(|own| &own.forms);
        let is_old = states().any(|form| form.old.is_some());
        for diag in compile_text(doc.example).compiled.diags {
            if diag.level == Level::Error || diag.code != Code::OldSpelling || !is_old {
                wrong.push(format!("`{}`: {}\n    {:?}", doc.name, diag.message, doc.example));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn the_page_is_made_of_the_tables() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/reference.md");
    let page = page();
    if std::env::var_os("CGA_BLESS").is_some() {
        fs::write(&path, &page).expect("the page is written");
    }
    let written = fs::read_to_string(&path).unwrap_or_default();
    let first = written.lines().zip(page.lines()).position(|(a, b)| a != b);
    assert!(written == page, "line {first:?} differs: run `CGA_BLESS=1 cargo test -p cga-lang --test front`");
}

#[test]
fn links_of_the_contents_lead_to_entries() {
    let page = page();
    let mut anchors = HashSet::new();
    for anchor in page.split("<a id=\"").skip(1).filter_map(|rest| rest.split('"').next()) {
        assert!(anchors.insert(anchor), "{anchor} occurs twice");
    }
    let links: Vec<&str> = page.split("](#").skip(1).filter_map(|rest| rest.split(')').next()).collect();
    assert_eq!(links.len(), words(&docs()).len());
    assert!(links.iter().all(|link| anchors.contains(link)));
}
