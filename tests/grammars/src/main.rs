//! Random grammars, compiled and run: `.ci/grammars` prints hashes of their runs, and `CGA_GRAMMARS=20 cargo run --release
//! -p cga-grammars -- laws` compares runs by the laws of `tests/laws`; with `loaded`, it compares compiled with loaded rules. `build.rs` writes the grammars.
//! `-- write 2011` prints the rules of a seed, and `-- laws rules.cga` plays rules of files by the laws, without a build.
#![deny(warnings)]

use std::process::ExitCode;

#[cfg(feature = "rayon")]
#[path = "../../laws/compare.rs"]
mod compare;
#[cfg(feature = "rayon")]
#[path = "../../laws/exact.rs"]
mod exact;
#[cfg(feature = "rayon")]
#[path = "../../laws/few.rs"]
mod few;
mod grammars {
    include!(concat!(env!("OUT_DIR"), "/grammars.rs"));
}
#[path = "../../../examples/hashes/hash.rs"]
mod hash;
mod hashes;
#[path = "../../laws/host.rs"]
mod host;
#[cfg(feature = "rayon")]
#[path = "../../laws/laws.rs"]
mod laws;
#[cfg(feature = "eval")]
#[path = "../../laws/loaded.rs"]
mod loaded;
#[cfg(feature = "eval")]
#[path = "../../outcome.rs"]
#[allow(dead_code, unreachable_pub, reason = "tests share it")]
mod outcome;
#[cfg(feature = "rayon")]
#[path = "../../laws/play.rs"]
mod play;
#[path = "../../../cga-lang/tests/front/common/random.rs"]
mod random;
#[path = "../../laws/start.rs"]
mod start;
#[path = "../../laws/write/mod.rs"]
mod write;

/// Plays rule files by the laws. They are loaded, so that a grammar with a difference can be made smaller without a build. The number in
/// the first line, `// Seed 2011.`, chooses the shapes.
#[cfg(all(feature = "rayon", feature = "eval"))]
fn rule_files(files: &[String]) -> play::Counts {
    let load = |name: &String| {
        let text = std::fs::read_to_string(name).unwrap_or_else(|error| panic!("{name}: {error}"));
        let seed = text.lines().next().and_then(|line| line.strip_prefix("// Seed ")?.strip_suffix('.')?.parse().ok());
        let rules = loaded::load(name, &text);
        (seed.unwrap_or(1), move || Box::new(rules.clone()) as Box<dyn cga::Grammar + Sync>)
    };
    play::play(&files.iter().map(load).collect::<Vec<_>>())
}

fn main() -> ExitCode {
    // `cargo test` runs the program too: its other arguments are filters and options of tests.
    let holds = match std::env::args().nth(1).as_deref() {
        #[cfg(all(feature = "rayon", feature = "eval"))]
        Some("laws") => {
            let files: Vec<String> = std::env::args().skip(2).collect();
            let counts = if files.is_empty() { play::play(grammars::ALL) } else { rule_files(&files) };
            println!("{}{}", counts.differences(), counts.summary());
            counts.broken == 0
        }
        #[cfg(feature = "eval")]
        Some("loaded") => {
            let differing = loaded::differences(grammars::ALL);
            differing.iter().for_each(|text| println!("{text}"));
            println!("{} grammars, {} runs differ", grammars::ALL.len(), differing.len());
            differing.is_empty()
        }
        Some("write") => {
            let seeds = std::env::args().skip(2);
            seeds.for_each(|seed| print!("{}", write::write(seed.parse().expect("the number of a grammar"))));
            true
        }
        _ => hashes::print(grammars::ALL),
    };
    if holds { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}
