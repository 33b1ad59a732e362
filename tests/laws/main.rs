//! The laws of runs: boxes and meshes, templates and direct derivation, sessions, threads and chunks give the same.
//!
//! Random grammars are run in pairs (`laws.rs`) on random shapes with random attributes, and all that runs give is
//! compared (`compare.rs`, `exact.rs`). The package `cga-grammars` plays more grammars, and prints hashes of their runs.

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
#[cfg(feature = "eval")]
mod loaded;
#[cfg(feature = "eval")]
#[path = "../outcome.rs"]
#[allow(dead_code, unreachable_pub, reason = "tests share it")]
mod outcome;
mod parallel;
mod play;
mod played;
#[path = "../../cga-lang/tests/front/common/random.rs"]
mod random;
mod repeated;
mod rows;
mod start;
mod write;

use std::fs;
use std::ops::Range;
use std::path::Path;

/// The seeds of the grammars in the repository.
const SEEDS: Range<u64> = 100..132;

#[test]
fn the_grammars_are_those_of_their_seeds() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let seeds: Vec<u64> = SEEDS.collect();
    let file = |seed: u64| (root.join(format!("rules/{seed}.cga")), write::write(seed));
    let levels = "@Warn(repeat_no_progress, endless_rules)";
    let list = files::list(&seeds, levels, |seed| format!("in \"rules/{seed}.cga\""));
    let mut files = vec![(root.join("grammars.rs"), list)];
    files.extend(SEEDS.map(file));
    if std::env::var_os("CGA_BLESS").is_some() {
        // Nothing else stays in the folder.
        fs::remove_dir_all(root.join("rules")).expect("the grammars");
        fs::create_dir(root.join("rules")).expect("a folder for grammars");
        files.iter().for_each(|(path, text)| fs::write(path, text).expect("a file of the repository"));
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
