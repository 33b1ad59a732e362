//! The command `cga-cluster`: cities on one machine or many.
//!
//! ```text
//! cga-cluster town                                         # a town of made-up outlines, in this process
//! cga-cluster run JOB.toml                                 # in this process
//! cga-cluster scheduler                                    # on Ballista: one scheduler,
//! cga-cluster executor --scheduler 127.0.0.1:50050         # executors on any number of machines,
//! cga-cluster submit JOB.toml --scheduler 127.0.0.1:50050  # and a client that waits
//! ```
#![forbid(unsafe_code)]

use std::process::ExitCode;

fn main() -> ExitCode {
    cga_cluster::program::main([])
}
