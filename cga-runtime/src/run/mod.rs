//! A run: rules are called one after the other, and leaves go to a sink.

pub mod building;
pub(crate) mod context;
pub mod coordinate_system;
pub(crate) mod derive;
pub(crate) mod env;
mod further;
pub(crate) mod ghost;
pub(crate) mod operand;
pub(crate) mod queries;
pub mod report;
pub mod rules;
pub mod settings;
pub mod shape_tree;
pub mod sink;
pub mod start_rule;
pub(crate) mod surroundings;
pub(crate) mod template;
pub(crate) mod tree_keys;
pub mod watch;
