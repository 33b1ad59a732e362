//! The engine of the playground: rules are loaded from text and run on lots. Requests and results are JSON, files are bytes.
//!
//! The same code runs natively. Tests compare its files with the files of the same grammars, compiled.

pub mod catalog;
pub mod chain;
#[cfg(not(target_arch = "wasm32"))]
pub mod compiled;
pub mod engine;
pub mod entry;
mod examples;
mod facts;
#[allow(dead_code, reason = "shared with the command, which uses more of it")]
#[path = "../../../cga-cli/src/features.rs"]
mod features;
pub mod finding;
#[allow(dead_code, reason = "shared with the command, which uses more of it")]
#[path = "../../../cga-cli/src/footprints.rs"]
mod footprints;
mod inline;
mod limits;
pub mod lot;
pub mod pick;
mod programs;
pub mod request;
mod rule_lines;
#[allow(dead_code, missing_docs, unreachable_pub, reason = "an example, which is not a library")]
#[path = "../../../examples/scenes/mod.rs"]
mod scenes;
#[cfg(target_arch = "wasm32")]
pub mod wasm;
