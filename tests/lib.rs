//! Code that several programs of this package share, compiled once: the examples of the reference's pages, and the examples
//! of the package `cga` that tests run.

#![allow(missing_docs, unreachable_pub, reason = "the package is not published, and each example has its title")]

pub mod gallery;
pub mod inline;
pub mod outcome;
pub mod pages;
pub mod stopped;
pub mod tree;

#[path = "../examples/scenes/mod.rs"]
pub mod scenes;

#[allow(dead_code, reason = "a test calls one function")]
#[path = "../examples/district.rs"]
mod district;

/// `metres_a_degree` of the example `district`.
pub fn metres_a_degree(latitude: f64) -> [f64; 2] {
    district::metres_a_degree(latitude)
}
