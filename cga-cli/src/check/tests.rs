//! Tests of the command.

use cga_lang::syntax::lex::MOST_BYTES;
use serde_json::Value;

use super::format::Format;
use super::*;
use crate::options::CheckOptions;
use crate::status::Status;

/// The output for a folder with these files, and true if the check succeeds. The names of files begin with `FOLDER`.
fn run(name: &str, files: &[(&str, &str)], change: impl Fn(&mut CheckOptions)) -> (String, bool) {
    let folder = std::env::temp_dir().join(format!("cga-cli-{name}-{}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a folder");
    for (name, text) in files {
        std::fs::write(folder.join(name), text).expect("a file");
    }
    let mut options = CheckOptions {
        paths: vec![folder.clone()],
        root: None,
        format: Format::Full,
        quiet: false,
        no_warnings: false,
        deny_warnings: false,
    };
    change(&mut options);
    let mut out = Vec::new();
    let code = check(&options, &mut out).expect("memory takes it all");
    std::fs::remove_dir_all(&folder).expect("the folder");
    let text = String::from_utf8(out).expect("text");
    (text.replace(&*folder.to_string_lossy(), "FOLDER"), code == Status::Success)
}

fn printed(name: &str, files: &[(&str, &str)]) -> String {
    run(name, files, |_| {}).0
}

#[test]
fn a_file_that_is_imported_needs_no_start_rule() {
    let library = ("lib.cga", "Wall(a) --> extrude(a) X.");
    let main = ("main.cga", "import lib : \"lib.cga\"\nLot --> lib.Wall(2)");
    assert!(printed("alone", &[library]).contains("warning[no_start_rule]"));
    let both = printed("both", &[library, main]);
    assert!(!both.contains("no_start_rule") && both.contains("2 files"), "{both}");
}

#[test]
fn a_file_that_is_imported_may_begin_with_a_helper() {
    let library = ("lib.cga", "Roof --> roofHip(30) X.\nHouse --> extrude(6) comp(f) { top : Roof | side : Y. }");
    let main = ("main.cga", "import lib : \"lib.cga\"\nLot --> lib.House");
    assert!(printed("helper", &[library]).contains("warning[unmarked_start]"));
    let both = printed("helpers", &[library, main]);
    assert!(!both.contains("unmarked_start") && both.contains("2 files"), "{both}");
}

#[test]
fn many_findings_are_printed_each_once() {
    let rules: String = (0..20_000).map(|number| format!("  Unknown{number}(1, 2)\n")).collect();
    // Reading the whole text for each finding would take minutes.
    let (text, _) = run("many", &[("lot.cga", &format!("Lot -->\n{rules}"))], |options| options.format = Format::Short);
    assert_eq!(text.lines().count(), 20_000);
}

const WRONG: (&str, &str) = ("tower.cga", "attr h = 3\nLot --> extrude(h) Wal\nWall --> X.\n");

#[test]
fn a_short_line_has_place_level_code_and_message() {
    let (text, _) = run("short", &[WRONG], |options| options.format = Format::Short);
    let lines: Vec<&str> = text.lines().collect();
    assert!(lines.iter().any(|line| line.starts_with("FOLDER/tower.cga:2:20: ") && line.contains("Wal")), "{text}");
    assert!(lines.iter().all(|line| line.starts_with("FOLDER/tower.cga:")), "{text}");
}

#[test]
fn a_json_line_has_places_notes_and_help() {
    let (text, _) = run("json", &[WRONG], |options| options.format = Format::Json);
    let objects: Vec<Value> = text.lines().map(|line| serde_json::from_str(line).expect("an object")).collect();
    let wal = objects.iter().find(|object| object["place"]["line"] == 2).expect("a finding in line 2");
    let number = |member: &str| wal["place"][member].as_u64().expect("a number");
    assert_eq!(["line", "column", "end_line", "end_column"].map(number), [2, 20, 2, 23]);
    assert!(wal["help"][0].as_str().expect("help").contains("`Wall`"), "{wal}");
    assert!(wal["code"].is_string() && wal["level"].is_string() && wal["notes"].is_array());
}

#[test]
fn errors_fail_and_warnings_fail_when_denied() {
    let fine = ("fine.cga", "@StartRule\nLot --> extrude(3) X.\n");
    let error = ("error.cga", "Lot --> extrude(\n");
    let warning = ("warning.cga", "Wall(a) --> extrude(a) X.");
    assert!(run("fine", &[fine], |_| {}).1);
    assert!(!run("error", &[error], |_| {}).1);
    assert!(run("warning", &[warning], |_| {}).1);
    assert!(!run("denied", &[warning], |options| options.deny_warnings = true).1);
    assert!(run("fine-denied", &[fine], |options| options.deny_warnings = true).1);
}

#[test]
fn only_summaries_remain_when_quiet() {
    let (text, _) = run("quiet", &[WRONG], |options| options.quiet = true);
    assert!(text.contains("tower.cga: 2 rules") && !text.contains("-->"), "{text}");
}

#[cfg(unix)]
#[test]
fn imports_and_links_stay_in_the_root() {
    use std::os::unix::fs::symlink;
    let folder = std::env::temp_dir().join(format!("cga-cli-root-{}", std::process::id()));
    let rules = folder.join("rules");
    std::fs::create_dir_all(rules.join("lib")).expect("a folder");
    std::fs::write(folder.join("secret.cga"), "secret text").expect("a file");
    std::fs::write(rules.join("lib/wall.cga"), "Wall --> X.").expect("a file");
    symlink(folder.join("secret.cga"), rules.join("linked.txt")).expect("a link");
    symlink(&folder, rules.join("folder")).expect("a link");
    symlink("lib/wall.cga", rules.join("inside.cga")).expect("a link");
    let imports = ["../secret.cga", "../none.cga", "folder/secret.cga", "secret.cga", "lib/wall.cga", "inside.cga"];
    let text: String = imports.iter().enumerate().map(|(at, path)| format!("import a{at} : \"{path}\"\n")).collect();
    std::fs::write(rules.join("lot.cga"), format!("{text}Lot --> a4.Wall a5.Wall")).expect("a file");
    let checked = |paths: Vec<std::path::PathBuf>, root: Option<std::path::PathBuf>| {
        let (quiet, no_warnings, deny_warnings) = (false, true, false);
        let options = CheckOptions { paths, root, format: Format::Full, quiet, no_warnings, deny_warnings };
        let mut out = Vec::new();
        let code = check(&options, &mut out).expect("memory takes it all");
        (String::from_utf8(out).expect("text").replace(&*folder.to_string_lossy(), "FOLDER"), code)
    };
    let (text, code) = checked(vec![rules.join("lot.cga")], Some(rules.clone()));
    assert_eq!(code, Status::Failed);
    let why = "it is not a file in `FOLDER/rules`, and paths and links that lead out of it are not followed";
    for path in &imports[..4] {
        assert!(text.contains(&format!("cannot import `{path}`: {why}")), "{path}: {text}");
    }
    assert!(text.contains("; 4 errors") && !text.contains("secret text"), "{text}");
    // Without the option files outside are read.
    assert!(checked(vec![rules.join("lot.cga")], None).0.contains("secret text"));
    // Neither files of the command line nor links in a folder lead out.
    symlink(folder.join("secret.cga"), rules.join("link.cga")).expect("a link");
    for path in [folder.join("secret.cga"), rules.join("link.cga"), rules.clone()] {
        let (text, code) = checked(vec![path], Some(rules.clone()));
        assert!(code == Status::Unusable && !text.contains("secret text"), "{text}");
    }
    assert_eq!(checked(vec![rules.clone()], Some(rules.join("none"))).1, Status::Unusable);
    std::fs::remove_dir_all(&folder).expect("the folder");
}

#[test]
fn a_file_of_many_bytes_is_not_read() {
    let folder = std::env::temp_dir().join(format!("cga-cli-long-{}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a folder");
    std::fs::write(folder.join("lot.cga"), " ".repeat(MOST_BYTES + 1)).expect("a file");
    let options = CheckOptions {
        paths: vec![folder.join("lot.cga")],
        root: None,
        format: Format::Full,
        quiet: false,
        no_warnings: false,
        deny_warnings: false,
    };
    let mut out = Vec::new();
    assert_eq!(check(&options, &mut out).expect("memory takes it all"), Status::Unusable);
    std::fs::remove_dir_all(&folder).expect("the folder");
}
