//! Any bytes as a glTF file: read or refused, and what is read is a mesh without flaws of its indices.

#![no_main]

#[path = "../../cga-runtime/tests/gltf_support/mod.rs"]
mod gltf_support;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| gltf_support::check(bytes));
