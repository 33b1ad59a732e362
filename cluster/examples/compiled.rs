//! The command `cga-cluster` with a compiled grammar: `cargo run --example compiled -- run job.toml`, where the job has `compiled = ["House"]`.

use std::process::ExitCode;

use cga::{Grammar as _, cga};

cga! { grammar House in "examples/House.cga"; }

fn main() -> ExitCode {
    cga_cluster::program::main([House::default().boxed()])
}
