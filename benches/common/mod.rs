//! What all benches share: a clock and tables.

#![allow(dead_code, reason = "not every bench uses all of it")]

pub(crate) mod clock;
pub(crate) mod table;
