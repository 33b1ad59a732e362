//! A run: rules are called one after the other, and leaves go to a sink.

pub mod building;
pub(crate) mod context;
pub(crate) mod derive;
pub(crate) mod env;
pub(crate) mod operand;
pub mod report;
pub mod rules;
pub mod settings;
pub mod shape_tree;
pub mod sink;
pub mod start_rule;
pub(crate) mod template;
pub mod watch;
