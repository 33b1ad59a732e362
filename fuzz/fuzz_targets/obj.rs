//! Any bytes as an OBJ file: read or refused, and what is read is a mesh without flaws of its indices.

#![no_main]

#[path = "../../cga-runtime/tests/obj_support/mod.rs"]
mod obj_support;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| obj_support::check(bytes));
