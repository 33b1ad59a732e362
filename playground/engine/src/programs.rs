//! The example programs. Only their grammars and their shapes are used.
#![allow(dead_code, unreachable_pub, reason = "each is a program in one file")]

#[path = "../../../examples/district.rs"]
pub(crate) mod district;
#[path = "../../../examples/massing.rs"]
pub(crate) mod massing;
#[path = "../../../examples/streets.rs"]
pub(crate) mod streets;
#[path = "../../../examples/textured.rs"]
pub(crate) mod textured;
#[path = "../../../examples/tower.rs"]
pub(crate) mod tower;
