//! Compiled grammars that follow their rule file while the program runs.

use std::fs;
use std::path::PathBuf;
use std::thread::sleep;
use std::time::{Duration, Instant};

use cga::{Grammar, Live, LiveError, Shape, Value, ValueType, cga};

mod inline;

/// A folder with a copy of the rules that goes with its test.
struct Folder(PathBuf);

impl Folder {
    fn new(name: &str) -> Self {
        let folder = std::env::temp_dir().join(format!("cga-live-{name}-{}", std::process::id()));
        fs::create_dir_all(folder.join("live/rules/parts")).expect("a folder");
        let folder = Folder(folder);
        folder.write("tower.cga", TOWER);
        folder.write("parts/wall.cga", WALL);
        folder
    }

    fn write(&self, name: &str, text: &str) {
        fs::write(self.0.join("live/rules").join(name), text).expect("a file");
    }

    /// Writes the rules with changes, each of which must be one.
    fn change(&self, changes: &[(&str, &str)]) {
        let changed = changes.iter().fold(TOWER.to_owned(), |text, (from, to)| {
            assert!(text.contains(from), "{from}");
            text.replace(from, to)
        });
        self.write("tower.cga", &changed);
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

const TOWER: &str = include_str!("rules/tower.cga");
const WALL: &str = include_str!("rules/parts/wall.cga");

cga! {
    @Allow(unused_attribute)
    pub grammar Tower in "live/rules/tower.cga";
}

fn lot() -> Shape {
    Shape::rectangle(10.0, 8.0).seed(3)
}

fn leaves(grammar: &dyn Grammar) -> (usize, Vec<String>) {
    let model = grammar.generate(&lot()).expect("no limit");
    (model.len(), model.rules().iter().map(ToString::to_string).collect())
}

/// Asks again and again until the change has come. Editors and file systems take their time.
fn until(live: &mut Live, is_so: impl Fn(&mut Live) -> bool) {
    let begun = Instant::now();
    while !is_so(live) {
        assert!(begun.elapsed() < Duration::from_secs(60), "no change came");
        sleep(Duration::from_millis(5));
    }
}

#[test]
fn a_compiled_grammar_follows_its_rule_file() {
    let folder = Folder::new("follows");
    let mut live = Live::in_folder(Tower { height: 6.0, ..Tower::default() }, &folder.0).expect("a rule file");
    let compiled = Tower { height: 6.0, ..Tower::default() };
    assert!(!live.refresh() && live.error().is_none());
    assert_eq!(leaves(&live), (6, vec!["X".to_owned()]));

    // Another rule; the value that was set stays, and with equal rules so do the bytes.
    folder.change(&[("X.", "X. // the same")]);
    until(&mut live, Live::refresh);
    let glb = |grammar: &dyn Grammar| grammar.generate(&lot()).expect("no limit").to_glb().expect("a file");
    assert!(glb(&live) == glb(&compiled));
    folder.change(&[("X.", "Y.")]);
    until(&mut live, Live::refresh);
    assert_eq!(leaves(&live), (6, vec!["Y".to_owned()]));

    // A mistake keeps the last good rules.
    folder.change(&[("X.", "case")]);
    until(&mut live, |live| !live.refresh() && live.error().is_some());
    assert!(
        live.error().is_some_and(|error| error.to_string().contains("live/rules/tower.cga:6")),
        "{:?}",
        live.error()
    );
    assert_eq!(leaves(&live), (6, vec!["Y".to_owned()]));

    // A new attribute has a default and a name; a removed one goes; another type drops the value.
    folder.change(&[("attr lit = false", "attr lit = true  attr door = 2")]);
    until(&mut live, Live::refresh);
    assert!(live.error().is_none());
    assert_eq!(leaves(&live), (6, vec!["Wall".to_owned()]));
    assert_eq!(live.get("door"), Ok(Value::Float(2.0)));
    live.set("lit", Value::Bool(false)).expect("an attribute");
    folder.change(&[("attr height = 12", "attr height = \"high\"")]);
    // `extrude(height)` needs a number.
    until(&mut live, |live| !live.refresh() && live.error().is_some());
    folder
        .change(&[("attr height = 12", "attr height = \"high\" const tall = 3"), ("extrude(height)", "extrude(tall)")]);
    until(&mut live, Live::refresh);
    let height = live.attributes().iter().find(|attribute| attribute.name == "height").expect("an attribute").clone();
    assert_eq!((height.ty, live.get("height")), (ValueType::Text, Ok(Value::from("high"))));
    assert!(live.get("door").is_err());
    assert_eq!(leaves(&live), (3, vec!["X".to_owned()]));

    // A file that is imported.
    live.set("lit", Value::Bool(true)).expect("an attribute");
    folder.write("parts/wall.cga", &WALL.replace("Wall.", "Brick."));
    until(&mut live, Live::refresh);
    assert_eq!(leaves(&live), (3, vec!["Brick".to_owned()]));
}

#[test]
fn a_value_that_was_set_stays_although_it_is_the_default() {
    let folder = Folder::new("default");
    let mut live = Live::in_folder(Tower::default(), &folder.0).expect("a rule file");
    live.set("height", Value::Float(12.0)).expect("an attribute");
    folder.change(&[("attr height = 12", "attr height = 30")]);
    until(&mut live, Live::refresh);
    assert_eq!(live.get("height"), Ok(Value::Float(12.0)));
    live.reset("height").expect("an attribute");
    assert_eq!(live.get("height"), Ok(Value::Float(30.0)));
}

#[test]
fn each_copy_learns_of_a_change_and_waits_alone() {
    let folder = Folder::new("copies");
    let mut live = Live::in_folder(Tower::default(), &folder.0).expect("a rule file");
    let mut copy = live.clone();
    let waiting = std::thread::spawn(move || {
        while !copy.wait() {}
        copy.get("height")
    });
    assert!(!live.refresh());
    folder.change(&[("attr height = 12", "attr height = 30")]);
    until(&mut live, |live| live.refresh() && live.get("height") == Ok(Value::Float(30.0)));
    assert_eq!(waiting.join().expect("no panic"), Ok(Value::Float(30.0)));
}

#[test]
fn a_folder_that_is_made_again_is_followed() {
    let folder = Folder::new("again");
    let rules = folder.0.join("live/rules");
    let mut live = Live::in_folder(Tower::default(), &folder.0).expect("a rule file");
    fs::remove_dir_all(&rules).expect("the folder");
    until(&mut live, |live| !live.refresh() && live.error().is_some());
    fs::create_dir_all(rules.join("parts")).expect("a folder");
    folder.write("parts/wall.cga", WALL);
    for height in [20.0, 30.0] {
        folder.change(&[("attr height = 12", &format!("attr height = {height}"))]);
        until(&mut live, |live| live.refresh() && live.get("height") == Ok(Value::Float(height)));
    }
}

#[test]
fn the_package_is_the_folder_of_the_rules() {
    let mut live = Live::new(Tower::default()).expect("a rule file");
    assert!(!live.refresh());
    assert_eq!(leaves(&live).0, 12);
}

#[test]
fn a_program_without_its_folder_says_so() {
    let error = Live::in_folder(Tower::default(), "no/such/folder").expect_err("no folder");
    assert_eq!(error.to_string(), "the rule files cannot be watched: the folder `no/such/folder` does not exist");
}

#[test]
fn rules_without_a_name_cannot_be_followed() {
    let height = 3.0;
    let error = Live::new(cga! { Lot --> extrude(#height) X. }).expect_err("no name");
    assert_eq!(error, LiveError::NoSource { grammar: String::new() });
    assert!(error.to_string().contains("give the rules a name, as in `cga! { grammar Tower; … }`"), "{error}");
}

#[cfg(unix)]
#[test]
fn a_file_behind_a_link_is_followed() {
    let folder = Folder::new("link");
    let wall = folder.0.join("live/rules/parts/wall.cga");
    fs::remove_file(&wall).expect("a file");
    fs::create_dir_all(folder.0.join("shared")).expect("a folder");
    let shared = folder.0.join("shared/wall.cga");
    fs::write(&shared, WALL).expect("a file");
    std::os::unix::fs::symlink(&shared, &wall).expect("a link");
    let mut live = Live::in_folder(Tower::default(), &folder.0).expect("a rule file");
    live.set("lit", Value::Bool(true)).expect("an attribute");
    fs::write(&shared, WALL.replace("Wall.", "Brick.")).expect("a file");
    until(&mut live, Live::refresh);
    assert_eq!(leaves(&live), (12, vec!["Brick".to_owned()]));
}
