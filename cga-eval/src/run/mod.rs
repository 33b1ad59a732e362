//! Runs of loaded rules.

mod blocks;
mod changes;
mod globals;
mod machine;
mod rules;
mod splits;
mod values;

pub use values::Values;
