//! Runs of loaded rules.

mod blocks;
mod changes;
mod globals;
mod machine;
mod rules;
mod splits;
mod values;

#[allow(unreachable_pub, reason = "a public trait names it")]
pub use values::Values;
