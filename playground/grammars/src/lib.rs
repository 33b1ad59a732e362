//! The grammars of the playground: a list of them, and runs of them, as JSON and bytes.
//!
//! The same code runs natively, so that tests compare the files of both.

pub mod catalog;
pub mod entry;
mod examples;
pub mod pick;
mod programs;
mod rule_lines;
pub mod run;
#[allow(dead_code, missing_docs, unreachable_pub, reason = "an example, which is not a library")]
#[path = "../../../examples/scenes/mod.rs"]
mod scenes;
#[cfg(target_arch = "wasm32")]
pub mod wasm;
