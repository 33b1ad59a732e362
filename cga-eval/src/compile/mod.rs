//! From the intermediate representation to code.

mod arrays;
mod blocks;
mod expr;
mod problems;
mod program;
mod registered;
mod rules;
mod splits;

pub(crate) use program::program;
pub(crate) use registered::Registered;
