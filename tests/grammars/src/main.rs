//! Random grammars, compiled and run: `.ci/grammars` prints hashes of their runs, and `CGA_GRAMMARS=20 cargo run --release
//! -p cga-grammars -- laws` compares runs by the laws of `tests/laws`; with `loaded`, it compares compiled with loaded rules. `build.rs` writes the grammars.
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

fn main() -> ExitCode {
    // `cargo test` runs the program too: its other arguments are filters and options of tests.
    let holds = match std::env::args().nth(1).as_deref() {
        #[cfg(feature = "rayon")]
        Some("laws") => {
            let counts = play::play(grammars::ALL);
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
        _ => hashes::print(grammars::ALL),
    };
    if holds { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}
