//! The laws of runs: boxes and meshes, templates and direct derivation, sessions, threads and chunks give the same.
//!
//! Random grammars are run in pairs (`laws.rs`) on random shapes with random attributes, and all that runs give is
//! compared (`compare.rs`, `exact.rs`). `CGA_LAWS=200` plays 200 more grammars in a throw-away crate; `CGA_LAWS=500..700` and
//! `CGA_LAWS=144,1044` the grammars of some seeds.

mod benches;
mod borders;
#[allow(deprecated, reason = "findings are warnings of this kind")]
mod cases;
mod compare;
mod exact;
mod few;
mod files;
#[allow(deprecated, reason = "findings are warnings of this kind")]
mod grammars;
mod host;
mod laws;
mod parallel;
mod play;
mod played;
#[path = "../../cga-lang/tests/front/common/random.rs"]
mod random;
mod start;
mod write;

use std::fs;
use std::ops::Range;
use std::path::Path;
use std::process::Command;

/// The seeds of the grammars in the repository.
const SEEDS: Range<u64> = 100..132;

#[test]
fn the_grammars_are_those_of_their_seeds() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let seeds: Vec<u64> = SEEDS.collect();
    let files = files::all(&seeds, root, "laws/grammars.rs", "laws/rules");
    if std::env::var_os("CGA_BLESS").is_some() {
        files::put(&files, &root.join("laws/rules"));
    }
    for (path, text) in files {
        let now = fs::read_to_string(&path).unwrap_or_default();
        assert!(now == text, "{} is not what is written today; CGA_BLESS=1 accepts this", path.display());
    }
}

/// Two tests, so that two cores share the work. One in four grammars prints much, so both have some of each kind.
#[test]
fn runs_give_the_same() {
    give_the_same(0);
}

#[test]
fn runs_of_the_other_grammars_give_the_same() {
    give_the_same(1);
}

/// Plays one half of the grammars: every second group of four.
fn give_the_same(half: usize) {
    let grammars: Vec<_> = grammars::ALL.chunks(4).skip(half).step_by(2).flatten().copied().collect();
    let counts = play::play(&grammars);
    println!("{}", counts.summary());
    assert!(counts.broken == 0, "{}{}", counts.differences(), counts.summary());
    assert!(
        50 * play::RUNS < counts.leaves as u64 && 50 * play::RUNS < counts.prints as u64,
        "too little to say anything: {}",
        counts.summary()
    );
}

/// Plays many more grammars when `CGA_LAWS` says how many or which: they are compiled in a crate of their own.
#[test]
fn further_grammars_give_the_same() {
    let Ok(text) = std::env::var("CGA_LAWS") else { return };
    let number =
        |text: &str| text.parse::<u64>().expect("`CGA_LAWS` is a number, two with `..` between them, or a list");
    let seeds: Vec<u64> = match (text.split_once(".."), text.contains(',')) {
        (Some((first, end)), _) => (number(first)..number(end)).collect(),
        (None, true) => text.split(',').map(number).collect(),
        (None, false) => (1000..1000 + number(&text)).collect(),
    };
    let source = Path::new(env!("CARGO_MANIFEST_DIR"));
    let root = source.join("../target/laws");
    fs::create_dir_all(root.join("src")).expect("a folder for the crate");
    files::put(&files::all(&seeds, &root, "src/grammars.rs", "rules"), &root.join("rules"));
    fs::write(root.join("Cargo.toml"), manifest(source)).expect("the crate's manifest");
    fs::write(root.join("src/main.rs"), program(source)).expect("the crate's program");
    // With the versions and the folder of this crate, what it depends on is there already.
    fs::copy(source.join("../Cargo.lock"), root.join("Cargo.lock")).expect("the lock file");
    let cargo = std::env::var_os("CARGO").unwrap_or("cargo".into());
    let mut command = Command::new(cargo);
    command.args(["run", "--release", "--quiet", "--target-dir"]).arg(source.join("../target")).current_dir(&root);
    let run = command.status().expect("cargo");
    assert!(run.success(), "the runs above differ");
}

/// The manifest of the throw-away crate: the grammars are compiled fast, what they call runs fast.
fn manifest(source: &Path) -> String {
    let profile = "[profile.release.package.laws]\nopt-level = 0\n";
    let package = "[package]\nname = \"laws\"\nversion = \"0.0.0\"\nedition = \"2024\"\n[workspace]\n";
    format!(
        "{package}[dependencies]\nrayon = \"1\"\ncga = {{ path = {:?}, features = [\"rayon\"] }}\n{profile}",
        source.parent().expect("the workspace")
    )
}

/// The program of the throw-away crate: the same runs of other grammars.
fn program(source: &Path) -> String {
    let mut text = String::from("#![allow(deprecated, dead_code, unused)]\nmod grammars;\n");
    for (name, path) in [
        ("compare", "laws/compare.rs"),
        ("exact", "laws/exact.rs"),
        ("few", "laws/few.rs"),
        ("host", "laws/host.rs"),
        ("laws", "laws/laws.rs"),
        ("play", "laws/play.rs"),
        ("random", "../cga-lang/tests/front/common/random.rs"),
        ("start", "laws/start.rs"),
    ] {
        text += &format!("#[path = {:?}]\nmod {name};\n", source.join(path));
    }
    text += "fn main() {\n    let counts = play::play(grammars::ALL);\n    println!(\"{}{}\", counts.differences(), counts.summary());\n";
    text += "    std::process::exit(i32::from(counts.broken != 0));\n}\n";
    text
}
