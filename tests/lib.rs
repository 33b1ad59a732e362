//! Code that several programs of this package share, compiled once: the examples of the reference's pages, and the examples
//! of the package `cga` that tests run.

#![allow(clippy::duplicate_mod, reason = "two examples have the same images")]
#![allow(missing_docs, unreachable_pub, reason = "the package is not published, and each example has its title")]

pub mod drawn;
pub mod gallery;
pub mod inline;
pub mod outcome;
pub mod pages;
pub mod stopped;
pub mod tree;
pub mod tutorial;
pub mod tutorial_pictures;

#[path = "../examples/scenes/mod.rs"]
pub mod scenes;

#[allow(dead_code, reason = "tests call functions without `main`")]
#[path = "../examples/district.rs"]
mod district;

#[allow(dead_code, reason = "as above")]
#[path = "../examples/front.rs"]
mod front;

#[allow(dead_code, reason = "as above")]
#[path = "../examples/guide/main.rs"]
mod guide;

#[allow(dead_code, reason = "as above")]
#[path = "../examples/hello.rs"]
mod hello;

#[allow(dead_code, reason = "as above")]
#[path = "../examples/lots.rs"]
mod lots;

#[allow(dead_code, reason = "as above")]
#[path = "../examples/massing.rs"]
mod massing;

#[allow(dead_code, reason = "as above")]
#[path = "../examples/metropolis.rs"]
pub mod metropolis;

#[allow(dead_code, reason = "as above")]
#[path = "../examples/streets.rs"]
mod streets;

#[allow(dead_code, reason = "as above")]
#[path = "../examples/textured.rs"]
mod textured;

#[allow(dead_code, reason = "as above")]
#[path = "../examples/tower.rs"]
mod tower;

/// `metres_a_degree` of the example `district`.
pub fn metres_a_degree(latitude: f64) -> [f64; 2] {
    district::metres_a_degree(latitude)
}
