//! Promises of the tree about itself.

use std::fs;
use std::path::PathBuf;

use cga_tests::tree::{files, root};

/// All Rust files of the workspace.
fn sources() -> Vec<PathBuf> {
    let list = files(".rs");
    assert!(100 < list.len(), "the walk found the workspace");
    list
}

#[test]
fn a_file_is_taken_in_at_one_sitting() {
    let long: Vec<String> = sources()
        .iter()
        .map(|path| (path, fs::read_to_string(path).expect("text").lines().count()))
        .filter(|(_, lines)| 500 < *lines)
        .map(|(path, lines)| format!("{}: {lines} lines", path.display()))
        .collect();
    assert!(long.is_empty(), "is it one concept? {long:#?}");
}

#[test]
fn the_language_knows_nothing_of_macros_and_does_no_io() {
    for path in sources().iter().filter(|path| path.starts_with(root().join("cga-lang/src"))) {
        let text = fs::read_to_string(path).expect("text");
        for word in ["proc_macro", "std::fs", "std::net", "std::env", "std::process"] {
            let used = text.lines().any(|line| line.contains(word) && !line.trim_start().starts_with("//"));
            assert!(!used, "{} uses {word}", path.display());
        }
    }
}

#[test]
fn the_picture_of_the_readme_is_made_by_the_rules_beside_it() {
    let readme = fs::read_to_string(root().join("README.md")).expect("the README");
    let example = fs::read_to_string(root().join("examples/hello.rs")).expect("the example");
    let rules = |text: &str| {
        let start = text.find("    grammar House;").expect("the grammar");
        let end = start + text[start..].find("\n}\n").expect("its end");
        text[start..end].to_owned()
    };
    assert_eq!(rules(&readme), rules(&example));
}

#[test]
fn the_readme_has_the_two_commands() {
    let readme = fs::read_to_string(root().join("README.md")).expect("the README");
    for command in ["cargo run --release --example tower", "cargo test --workspace"] {
        assert!(readme.contains(command), "{command}");
    }
    assert!(readme.split_whitespace().count() <= 800, "the README has grown");
}

#[test]
fn the_files_that_docs_name_exist() {
    let sources: Vec<String> = sources().iter().map(|path| path.display().to_string()).collect();
    let pages = ["ARCHITECTURE", "CONTRIBUTING", "docs/cutting", "docs/offset", "docs/decisions", "docs/glossary"];
    for page in pages {
        let text = fs::read_to_string(root().join(format!("{page}.md"))).expect("a page");
        for name in text.split('`').filter(|name| name.ends_with(".rs") && !name.contains(['*', ' ', '…', '\n'])) {
            let end = format!("/{name}");
            assert!(sources.iter().any(|path| path.ends_with(&end)), "{page}.md names {name}");
        }
    }
}

#[test]
fn figures_of_the_page_of_features_are_measured() {
    let read = |file: &str| fs::read_to_string(root().join(file)).expect("a page");
    let (features, performance) = (read("docs/features.md"), read("docs/performance.md"));
    let (_, times) = performance.split_once("\n## Scenes: time\n").expect("the times");
    let cells = |row: &str| row.split('|').map(|cell| cell.trim().to_owned()).collect::<Vec<_>>();
    let mut count = 0;
    for row in features.lines().filter(|row| row.starts_with("| ") && row.contains(" ns |")) {
        let own = cells(row);
        let scene = own[1].split('`').nth(1).expect("a scene");
        let found = times.lines().find(|row| row.starts_with(&format!("| {scene} "))).expect("its row");
        let measured = cells(found);
        let (parts, each): (f64, f64) = (measured[4].parse().expect("parts"), measured[6].parse().expect("time"));
        assert_eq!(own[2].replace(',', ""), measured[4], "{scene}: parts");
        assert_eq!(own[3], format!("{:.1} ms", parts * each / 1e6), "{scene}: time");
        assert_eq!(own[4], format!("{each:.0} ns"), "{scene}: a part");
        assert_eq!(own[5], measured[2], "{scene}: relative to by hand");
        count += 1;
    }
    assert_eq!(count, 3);
}
