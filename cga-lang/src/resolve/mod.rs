//! Name resolution: declarations, and the meaning of each use.

pub(crate) mod arguments;
pub(crate) mod arity;
pub(crate) mod context;
pub(crate) mod cycles;
pub(crate) mod duplicates;
pub(crate) mod globals;
pub(crate) mod habits;
pub(crate) mod info;
pub(crate) mod names;
pub(crate) mod overrides;
mod resolver;
pub(crate) mod selectors;
pub(crate) mod steps;
pub(crate) mod tables;
pub(crate) mod words;
