//! From the intermediate representation to code.

mod arrays;
mod blocks;
mod expr;
mod problems;
mod program;
mod rules;
mod splits;

pub(crate) use problems::Problems;
pub(crate) use program::{Registered, program};
