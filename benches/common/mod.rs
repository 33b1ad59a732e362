//! A clock and tables for all benches.

#![allow(dead_code, reason = "not every bench uses all of it")]

pub(crate) mod clock;
pub(crate) mod instructions;
pub(crate) mod table;
