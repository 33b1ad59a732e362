//! The command `cga`: checks rule files as the macro does, and runs them on lots. No Rust program is built.
//!
//! ```text
//! cga check rules/                                # every .cga file below a folder
//! cga run tower.cga --lot 20x12 -o tower.glb      # a model of one lot
//! cga run town.cga --footprint town.geojson -o town.glb -o town.png
//! cga attributes tower.cga                        # the values that can be set
//! cga watch tower.cga -o tower.png                # writes again at each change
//! ```
#![forbid(unsafe_code)]

mod attributes;
mod check;
mod features;
mod footprints;
mod lots;
mod options;
mod outputs;
mod path;
mod problem;
mod run;
mod status;
mod stream;
mod watch;

use std::process::ExitCode;

use clap::Parser as _;
use options::{Command, Options};
use status::Status;
use stream::Stream;

fn main() -> ExitCode {
    let status = match Options::parse().command {
        Command::Check(options) => {
            check::check(&options, &mut Stream(std::io::stdout().lock())).unwrap_or_else(|why| {
                stream::say(stream::unwritten(&why));
                Status::Unusable
            })
        }
        Command::Run(options) => run::command(&options),
        Command::Attributes(options) => attributes::command(&options),
        Command::Watch(options) => watch::command(&options),
    };
    status.into()
}
