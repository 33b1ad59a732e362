//! The words of parameters and selectors, as variants of enums of the runtime.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use cga_lang::ops::{Braces, SelectorPlaces, all_functions, all_operations, selectors, variant};

use super::check;

/// The path of the module of an operation's words. Splits and components have theirs beside the operations.
pub(crate) fn module(braces: Braces) -> &'static str {
    match braces {
        Braces::Slots(_) | Braces::Components => "rt",
        _ => "op",
    }
}

/// The name of the function that reads a word of an enum.
pub(crate) fn function(module: &str, name: &str) -> String {
    let mut function = module.to_owned();
    for character in name.chars() {
        if character.is_uppercase() {
            function.push('_');
        }
        function.extend(character.to_lowercase());
    }
    function
}

#[test]
fn words_are_up_to_date() {
    // By module and enum: the variants by word.
    let mut enums: BTreeMap<(&str, &str), BTreeMap<&str, String>> = BTreeMap::new();
    let operations = all_operations().map(|row| (module(row.braces), row.params));
    let functions = all_functions().map(|row| ("func", row.params));
    for (module, params) in operations.chain(functions) {
        for words in params.iter().filter_map(|param| param.kind.words()) {
            let known = enums.entry((module, words.rust)).or_default();
            known.extend(words.list.iter().map(|word| (*word, words.variant(word))));
        }
    }
    let mut bodies: BTreeMap<String, String> = BTreeMap::new();
    let mut add = |module: &str, name: &str, words: &BTreeMap<&str, String>, about: &str| {
        let import =
            format!("use cga_runtime::{};\n", if module == "rt" { "rt".into() } else { format!("rt::{module}") });
        let body = bodies.entry(module.to_owned()).or_insert(import);
        let (function, path) =
            (function(module, name), if module == "rt" { "rt::".into() } else { format!("{module}::") });
        write!(
            body,
            "\n/// {about}\npub(crate) fn {function}(word: &str) -> Option<{path}{name}> {{ Some(match word {{"
        )
        .expect("text");
        for (word, variant) in words {
            write!(body, "{word:?} => {path}{name}::{variant},").expect("text");
        }
        body.push_str("_ => return None, }) }\n");
    };
    for ((module, name), words) in &enums {
        add(module, name, words, &format!("A word of `{name}`."));
    }
    let selectors = selectors().filter(|row| row.old.is_none() && row.on.meets(all_places()));
    let selectors = selectors.map(|row| (row.name, variant(row.name))).collect();
    add("rt", "Word", &selectors, "A word that selects components.");
    for (module, body) in &bodies {
        check(&format!("words/{module}.rs"), "The words of parameters and selectors.", body);
    }
}

/// The places of all selectors.
fn all_places() -> SelectorPlaces {
    SelectorPlaces::COMP.and(SelectorPlaces::SETBACK).and(SelectorPlaces::SHAPE).and(SelectorPlaces::PERIMETER)
}
