//! Rules that are loaded at run time: they give the same as compiled rules, and they need no more stack.

mod deep;
mod files;
mod leaves;
mod mutated;
mod pages;
mod scenes;
mod values;
