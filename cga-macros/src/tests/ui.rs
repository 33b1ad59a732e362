//! The cases of the facade's `tests/ui`, without a compiler: whatever its version, they fail with our first lines.

use std::collections::BTreeSet;
use std::fs;
use std::path::PathBuf;

use cga_lang::compile::compile;
use cga_lang::diag::code::Code;
use cga_lang::diag::{Diag, Level};
use cga_lang::link::Files;
use cga_source::rust::{RulesText, read_header};
use proc_macro2::{TokenStream, TokenTree};

use super::sources::{Below, root};

/// Mistakes that Rust's lexer rejects before a macro runs.
const NO_RUST: [&str; 3] = ["missing_brace", "quote_before_bracket", "quote_before_digits"];

/// Diagnostics about files of a package, which the cases do not have: fixtures and the test of `source/import.rs` show it.
const ABOUT_FILES: [Code; 2] = [Code::MissingAsset, Code::UnknownGroup];

/// A case: its path, and the contents of each of its `cga!`.
struct Case {
    path: PathBuf,
    grammars: Vec<TokenStream>,
}

/// Every case that is Rust.
fn cases() -> Vec<Case> {
    let mut list = Vec::new();
    let mut left_out = Vec::new();
    for group in fs::read_dir(root().join("tests/ui")).expect("the cases") {
        for entry in fs::read_dir(group.expect("a group").path()).expect("a group") {
            let path = entry.expect("a case").path();
            if path.extension().is_none_or(|extension| extension != "rs") {
                continue;
            }
            match fs::read_to_string(&path).expect("a case").parse::<TokenStream>() {
                Ok(stream) => list.push(Case { path, grammars: grammars(stream) }),
                Err(_) => left_out.push(path.file_stem().expect("a name").to_string_lossy().into_owned()),
            }
        }
    }
    left_out.sort();
    assert_eq!(left_out, NO_RUST);
    list
}

/// The contents of each `cga!{…}`.
fn grammars(stream: TokenStream) -> Vec<TokenStream> {
    let mut found = Vec::new();
    let list: Vec<TokenTree> = stream.into_iter().collect();
    for (at, token) in list.iter().enumerate() {
        let TokenTree::Group(group) = token else { continue };
        let is = |back: usize, word: &str| at.checked_sub(back).is_some_and(|at| list[at].to_string() == word);
        if is(1, "!") && is(2, "cga") {
            found.push(group.stream());
        } else {
            found.extend(grammars(group.stream()));
        }
    }
    found
}

/// The findings of a grammar that are shown; none for a source that cannot be opened.
fn found(input: TokenStream) -> Vec<Diag> {
    let (header, body) = read_header(input);
    let unit = match body {
        Ok(RulesText::File(path)) => {
            let path: syn::LitStr = syn::parse_quote!(#path);
            Below.open(&path.value(), "").ok()
        }
        Ok(body) => crate::source::open(&header, body).ok().map(|source| source.unit()),
        Err(_) => None,
    };
    let diags = unit.map(|unit| compile(unit, &mut Below, &header.levels).diags);
    diags.into_iter().flatten().filter(|diag| diag.level != Level::Allow).collect()
}

#[test]
fn cases_fail_with_our_first_lines() {
    for case in cases() {
        let shown = fs::read_to_string(case.path.with_extension("stderr")).expect("what is shown");
        for diag in case.grammars.into_iter().flat_map(found) {
            let line = |sign| match diag.level {
                Level::Error => format!("error: {}\n", diag.message.spelled(sign)),
                _ => {
                    let message = diag.message.spelled(sign);
                    format!(": use of deprecated macro `cga::{}`: {message}\n", diag.code.name())
                }
            };
            let is_shown = shown.contains(&line('\'')) || shown.contains(&line('^'));
            assert!(is_shown, "{}: {}", case.path.display(), line('^'));
        }
    }
}

#[test]
fn every_code_has_a_case() {
    let grammars = cases().into_iter().flat_map(|case| case.grammars);
    let shown: BTreeSet<Code> = grammars.flat_map(found).map(|diag| diag.code).collect();
    let missing: Vec<Code> = Code::ALL.iter().copied().filter(|code| !shown.contains(code)).collect();
    assert_eq!(missing, ABOUT_FILES);
}
