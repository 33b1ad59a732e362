//! Any bytes as a mesh and planes: cut, and held against the laws. A failure prints the case for `tests/corpus/cut.txt`.

#![no_main]

#[path = "../../cga-runtime/tests/cut_support/mod.rs"]
mod cut_support;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| cut_support::bytes::case(bytes).check());
