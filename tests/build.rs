//! Writes the programs of the tutorial that read its files, for the test `tutorial`.

use std::path::Path;
use std::{env, fs};

#[allow(dead_code, unreachable_pub, reason = "the library has other uses")]
mod tree;
#[allow(dead_code, unreachable_pub, reason = "as above")]
mod tutorial;

fn main() {
    println!("cargo::rerun-if-changed=../docs/guide/tutorial.md");
    println!("cargo::rerun-if-changed=tutorial.rs");
    let folder = env::var_os("OUT_DIR").expect("cargo sets it");
    for (name, program) in tutorial::programs() {
        // A reader has the files beside the manifest, the test in its working folder.
        let program = program.replace("env!(\"CARGO_MANIFEST_DIR\")", "\".\"");
        fs::write(Path::new(&folder).join(name).with_extension("rs"), program).expect("a writable folder");
    }
}
