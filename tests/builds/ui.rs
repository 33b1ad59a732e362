//! The compiler's messages for mistakes: one case for each kind, in `ui/`. `CGA_BLESS=1` accepts new wording.

use std::collections::BTreeMap;
use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use cga_tests::tree::files_below;
use serde_json::Value;

use super::package::Package;

/// The wording of rustc around ours belongs to one version. `cga-macros/src/tests/ui.rs` asks for our first lines in all of
/// them.
const RUSTC: &str = "rustc 1.95.";

#[test]
fn mistakes_are_explained_at_the_guilty_token() {
    let compiler = std::env::var_os("RUSTC").unwrap_or_else(|| "rustc".into());
    let version = Command::new(compiler).arg("--version").output().expect("a compiler");
    let version = String::from_utf8_lossy(&version.stdout).into_owned();
    if !version.starts_with(RUSTC) {
        println!("left out: the expected messages come from {RUSTC}*, not from {version}");
        return;
    }
    let cases = cases();
    let shown = messages(&cases);
    let mut wrong = String::new();
    for (name, path) in &cases {
        let (file, found) = (path.with_extension("stderr"), shown.get(name).map_or("", String::as_str));
        if std::env::var_os("CGA_BLESS").is_some() {
            fs::write(&file, found).expect("a writable case");
        }
        let expected = fs::read_to_string(&file).unwrap_or_default();
        if found != expected {
            let _ = writeln!(wrong, "{}\nexpected:\n{expected}\nfound:\n{found}", path.display());
        }
    }
    assert!(wrong.is_empty(), "{wrong}CGA_BLESS=1 accepts this");
}

/// The files of the cases, by the names of their programs.
fn cases() -> BTreeMap<String, PathBuf> {
    let programs = files_below(&folder(), ".rs").into_iter();
    let cases: BTreeMap<_, _> =
        programs.map(|path| (inside(&path).replace('/', "-").replace(".rs", ""), path)).collect();
    assert!(30 < cases.len(), "the walk found the cases");
    cases
}

/// The folder of the cases.
fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("ui")
}

/// A path from the folder of the tests.
fn inside(path: &Path) -> String {
    let path = path.strip_prefix(env!("CARGO_MANIFEST_DIR")).expect("a file of the tests");
    path.to_string_lossy().replace('\\', "/")
}

/// The messages of the compiler for each program. The programs are one package, with copies of their rule files.
fn messages(cases: &BTreeMap<String, PathBuf>) -> BTreeMap<String, String> {
    let programs = cases.iter().map(|(name, path)| format!("[[bin]]\nname = {name:?}\npath = {:?}\n", inside(path)));
    let package = Package::new("mistakes", "cga", &programs.collect::<String>());
    for path in files_below(&folder(), "") {
        package.write(&inside(&path), &fs::read_to_string(&path).expect("a text"));
    }
    let output = package.check().args(["--bins", "--keep-going", "--message-format=json"]).output().expect("cargo");
    let mut shown = BTreeMap::new();
    for line in String::from_utf8_lossy(&output.stdout).lines() {
        let message: Value = serde_json::from_str(line).expect("JSON");
        let (name, text) = (message["target"]["name"].as_str(), message["message"]["rendered"].as_str());
        // The counts of errors and warnings have no place.
        let has_place = message["message"]["spans"].as_array().is_some_and(|spans| !spans.is_empty());
        if let (Some(name), Some(text), true) = (name, text, has_place) {
            let shown = shown.entry(name.to_owned()).or_insert_with(String::new);
            let text = without_library(text);
            // Cargo shows equal messages once; an incremental build writes one for each place in the expansion.
            if !shown.contains(&text) {
                shown.push_str(&text);
            }
        }
    }
    assert!(!shown.is_empty(), "{}", String::from_utf8_lossy(&output.stderr));
    shown.values_mut().for_each(|text| text.truncate(text.trim_end().len() + 1));
    shown
}

/// A message without the notes that quote a file of `cga` or of Rust: their lines change with these files. Line numbers of
/// such files are longer, so the margin becomes narrower.
fn without_library(text: &str) -> String {
    let lines: Vec<&str> = text.lines().collect();
    let starts: Vec<usize> =
        (0..lines.len()).filter(|&at| !lines[at].starts_with([' ', '.']) && !is_quoted(lines[at])).collect();
    let ends = starts.iter().skip(1).copied().chain([lines.len()]);
    let sections = starts.iter().zip(ends).map(|(&start, end)| &lines[start..end]);
    let is_own = |section: &&[&str]| !section.iter().any(|line| line.trim_start().starts_with("--> /"));
    let kept: Vec<&str> = sections.filter(is_own).flatten().copied().collect();
    let number = |line: &&str| {
        line.split_once(" |").map_or(0, |(number, _)| if is_quoted(line) { number.trim().len() } else { 0 })
    };
    let margin = |line: &&str| line.find("--> ").filter(|&at| line[..at].trim().is_empty());
    let spare = match (kept.len() < lines.len(), kept.iter().find_map(margin), kept.iter().map(number).max()) {
        (true, Some(margin), Some(digits)) => margin - digits,
        _ => 0,
    };
    let narrow = |line: &&str| line.strip_prefix(&" ".repeat(spare)).unwrap_or(line).to_owned() + "\n";
    kept.iter().map(narrow).collect::<String>().trim_end().to_owned() + "\n\n"
}

/// Returns true for a line of a file, with its number in the margin.
fn is_quoted(line: &str) -> bool {
    line.trim_start().starts_with(|first: char| first.is_ascii_digit()) && line.contains(" |")
}
