//! Rules inside `cga!` that follow the Rust file that they are in.

use std::fs;
use std::path::PathBuf;

use cga::{Color, Grammar, Live, Shape, Value, ValueType, cga};

use crate::{leaves, lot, until};

/// The height of a storey.
const STOREY: f64 = 3.0;

fn lower(height: f64, name: &str) -> f64 {
    height - name.len() as f64
}

fn nothing() -> f64 {
    0.0
}

fn paint(shape: &mut Shape, red: f64) {
    shape.set_color(Color::new(red, 0.0, 0.0));
}

cga! {
    /// The rules of this file.
    @Allow(unused_attribute)
    pub grammar Inline;
    attr height = 12
    attr lit = false
    Lot --> extrude(crate::inline::lower(height, "abc") + crate::inline::nothing()) split(y) { ~#STOREY : Floor }*
    Floor --> crate::inline::paint(0.5) print("storey " + #(STOREY * 2.0)) split(x) { ^0.5 : X. | ~1 : Y. }
}

cga! {
    grammar Quoted = r#"
        Lot --> split(x) { '0.5 : X. | ~1 : Y. }
    "#;
}

/// The line of the rules in a string.
const MARKED: &str = "Lot --> split(x) { '0.5 : X. | ~1 : Y. }";

/// The text of this file.
const TEXT: &str = include_str!("inline.rs");

/// A folder with a copy of this file that goes with its test.
struct Folder(PathBuf);

impl Folder {
    fn new(name: &str) -> Self {
        let folder = std::env::temp_dir().join(format!("cga-inline-{name}-{}", std::process::id()));
        fs::create_dir_all(folder.join("live")).expect("a folder");
        let folder = Folder(folder);
        folder.change(&[]);
        folder
    }

    /// Writes the file with changes of its rules.
    fn change(&self, changes: &[(&str, &str)]) {
        let changed = changes.iter().fold(TEXT.to_owned(), |text, (from, to)| {
            assert!(text.contains(from), "{from}");
            text.replace(from, to)
        });
        fs::write(self.0.join("live/inline.rs"), changed).expect("a file");
    }

    fn follow(&self, grammar: impl Grammar + Send + Sync + 'static) -> Live {
        Live::in_folder(grammar, &self.0).expect("a source")
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

fn glb(grammar: &dyn Grammar) -> (Vec<u8>, Vec<String>) {
    let model = grammar.generate(&lot()).expect("no limit");
    let prints = model.prints().iter().map(ToString::to_string).collect();
    (model.to_glb().expect("a file"), prints)
}

/// The error after the next change.
fn mistake(live: &mut Live) -> String {
    until(live, |live| !live.refresh() && live.error().is_some());
    live.error().map(ToString::to_string).unwrap_or_default()
}

#[test]
fn inline_rules_follow_their_rust_file() {
    let folder = Folder::new("follows");
    let compiled = Inline { height: 15.0, ..Inline::default() };
    let mut live = folder.follow(compiled.clone());
    assert!(!live.refresh());

    // Rust values, functions and operations are the compiled ones, and the bytes are the same.
    folder.change(&[("Floor --> ", "Floor --> /* the same */ ")]);
    until(&mut live, Live::refresh);
    assert!(glb(&live) == glb(&compiled));
    assert_eq!(glb(&live).1, ["storey 6"; 4]);

    // Another rule, and a value that was set.
    folder.change(&[("^0.5 : X.", "^0.25 : Z.")]);
    until(&mut live, Live::refresh);
    assert_eq!(leaves(&live), (8, vec!["Z".to_owned(), "Y".to_owned()]));
    assert_eq!(live.get("height"), Ok(Value::Float(15.0)));

    // A mistake is shown at its line of the Rust file, in the spelling of inline rules, and the last good rules stay.
    folder.change(&[("^0.5 : X.", "^0.5 : ^0.6 : X.")]);
    let error = mistake(&mut live);
    let line = 1 + TEXT.lines().position(|line| line.contains("^0.5 : X.")).expect("the line");
    assert!(error.contains(&format!("--> live/inline.rs:{line}:")) && error.contains("^0.5 : ^0.6"), "{error}");
    assert_eq!(leaves(&live).0, 8);

    // A new attribute has a name before it has a field; one of another type and a removed one lose their values.
    folder.change(&[("attr lit = false", "attr lit = \"no\" attr door = 2"), ("attr height = 12", "const height = 9")]);
    until(&mut live, Live::refresh);
    let names: Vec<&str> = live.attributes().iter().map(|attribute| attribute.name.as_str()).collect();
    assert_eq!((names, live.attributes()[0].ty), (vec!["lit", "door"], ValueType::Text));
    live.set("door", Value::Float(3.0)).expect("an attribute");
    assert_eq!((live.get("door"), leaves(&live).0), (Ok(Value::Float(3.0)), 4));
}

#[test]
fn rust_that_the_program_does_not_have_needs_a_build() {
    let folder = Folder::new("rust");
    let mut live = folder.follow(Inline::default());
    for (from, to, why) in [
        ("~#STOREY : Floor", "~#(STOREY + 1.0) : Floor", "without the Rust value `#(STOREY + 1.0)` as a number"),
        ("attr height = 12", "attr height = 12 + size([#STOREY == \"a\"])", "without the Rust value `#STOREY` as text"),
        ("inline::lower(height, \"abc\")", "inline::lower(height)", "`crate::inline::lower` is not registered"),
        ("inline::paint(0.5)", "inline::paint(\"red\")", "operation `crate::inline::paint` is not registered"),
    ] {
        folder.change(&[(from, to)]);
        let error = mistake(&mut live);
        assert!(error.contains(why) && error.contains("build the program again"), "{to}: {error}");
        folder.change(&[]);
        until(&mut live, Live::refresh);
    }
    // A function that the program registers.
    folder.change(&[("inline::lower(height, \"abc\")", "inline::twice(height)")]);
    let mut live = live.with_loader(|loader| {
        loader.with_function("crate::inline::twice", |args| match args {
            [Value::Float(height)] => Value::Float(2.0 * height),
            _ => Value::Float(0.0),
        })
    });
    until(&mut live, Live::refresh);
    assert_eq!(leaves(&live).0, 16);
}

#[test]
fn rules_in_a_string_follow_the_rust_file() {
    let folder = Folder::new("quoted");
    let mut live = folder.follow(Quoted::default());
    folder.change(&[(MARKED, &MARKED.replace("X.", "Z."))]);
    until(&mut live, Live::refresh);
    folder.change(&[(MARKED, &MARKED.replace("'0.5", "'0.5 '0.6"))]);
    let error = mistake(&mut live);
    let line = 1 + TEXT.lines().position(|line| line.contains(MARKED)).expect("the line");
    assert!(error.contains(&format!("--> live/inline.rs:{line}:")), "{error}");
}

#[test]
fn a_file_without_the_grammar_says_so() {
    let folder = Folder::new("without");
    let mut live = folder.follow(Inline::default());
    for (from, to, why) in [
        ("grammar Inline;", "grammar Outline;", "`live/inline.rs`: it has no `cga! { grammar Inline; … }`"),
        ("grammar Quoted = ", "grammar Inline = ", "it has several grammars of the name `Inline`"),
        ("pub grammar Inline;", "pub grammar Inline in \"a.cga\";", "line "),
        ("struct Folder(PathBuf);", "struct Folder(PathBuf;", "the Rust code cannot be read at line "),
    ] {
        folder.change(&[(from, to)]);
        let error = mistake(&mut live);
        assert!(error.contains(why), "{to}: {error}");
        folder.change(&[]);
        until(&mut live, Live::refresh);
    }
}

/// The sources of a package count from its folder, although the compiler names files from the workspace.
#[test]
fn the_package_has_the_file() {
    assert!(file!().ends_with("live/inline.rs"));
    let mut live = Live::new(Inline::default()).expect("a source");
    assert!(!live.refresh());
    assert_eq!(leaves(&live).0, 6);
}
