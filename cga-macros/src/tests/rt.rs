//! The runtime's `rt.rs` is the list of the names that generated code uses. What its modules hold is compared in `rows.rs`.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use cga_lang::ops::all_operations;
use syn::{Item, UseTree};

use super::rows::is_in_op;
use super::sources::root;

/// The names that `rt.rs` has.
fn listed() -> BTreeSet<String> {
    fn add(tree: &UseTree, names: &mut BTreeSet<String>) {
        match tree {
            UseTree::Path(tree) => add(&tree.tree, names),
            UseTree::Group(tree) => tree.items.iter().for_each(|tree| add(tree, names)),
            UseTree::Name(tree) => _ = names.insert(tree.ident.to_string()),
            UseTree::Rename(tree) => _ = names.insert(tree.rename.to_string()),
            UseTree::Glob(_) => panic!("`rt.rs` names everything"),
        }
    }
    let text = fs::read_to_string(root().join("cga-runtime/src/rt.rs")).expect("rt.rs");
    let mut names = BTreeSet::new();
    for item in syn::parse_file(&text).expect("Rust").items {
        match item {
            Item::Use(item) => add(&item.tree, &mut names),
            Item::Mod(item) => _ = names.insert(item.ident.to_string()),
            _ => panic!("`rt.rs` only names what is elsewhere"),
        }
    }
    names
}

/// The code generator without its tests.
fn generator(folder: &Path, code: &mut String) {
    for entry in fs::read_dir(folder).expect("a folder") {
        let path = entry.expect("an entry").path();
        if path.is_dir() && !path.ends_with("tests") {
            generator(&path, code);
        } else if path.extension().is_some_and(|end| end == "rs") {
            let text = fs::read_to_string(&path).expect("a file");
            code.push_str(text.split("#[cfg(test)]\nmod tests {").next().unwrap_or_default());
        }
    }
}

/// The word that a text begins with.
fn word(text: &str) -> &str {
    text.split(|c: char| !c.is_alphanumeric() && c != '_').next().unwrap_or_default()
}

#[test]
fn rt_lists_what_generated_code_uses() {
    let (listed, mut code) = (listed(), String::new());
    generator(&root().join("cga-macros/src"), &mut code);
    let after = |path: &str| code.split(path).skip(1).map(word).map(str::to_owned).collect::<Vec<_>>();
    let written: BTreeSet<String> = after("cga_rt::").into_iter().chain(after("#runtime::")).collect();
    let written: BTreeSet<String> = written.into_iter().filter(|name| !name.is_empty()).collect();
    let lacking: Vec<&String> = written.difference(&listed).collect();
    assert!(lacking.is_empty(), "generated code uses {lacking:?}, which `rt.rs` does not have");
    // Some names are written as text, where the code generator chooses between several.
    let is_chosen = |name: &str| code.contains(&format!("\"{name}\""));
    // Others stand in the table: functions and words of operations that are not in a module of their own.
    let of_rows = |name: &str| {
        all_operations().filter(|row| !is_in_op(row)).any(|row| {
            let words = row.params.iter().filter_map(|param| Some(param.kind.words()?.rust));
            std::iter::once(row.run).chain(words).any(|own| own == name)
        })
    };
    let idle: Vec<&String> = listed.difference(&written).filter(|name| !is_chosen(name) && !of_rows(name)).collect();
    assert!(idle.is_empty(), "generated code does not use {idle:?} of `rt.rs`");
}
