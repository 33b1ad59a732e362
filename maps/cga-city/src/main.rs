//! The command `cga-city`: map files and CGA rules in, 3D Tiles out.
//!
//! ```text
//! cga-city                                                          # a town of made-up outlines
//! cga-city town.geojson --rules town.cga --out tiles --lod Block
//! cga-city view tiles                                               # a page for a browser on this computer
//! cga-city outlines town.parquet --rows 100000                      # made-up outlines
//! ```
#![forbid(unsafe_code)]

mod command;
mod named_columns;
mod options;
mod progress_bar;
mod stream;
mod town;
mod view;

use std::process::ExitCode;

use clap::Parser as _;

use options::{Command, Options};
use stream::say;

/// The exit status of the command: 0, 1 or 2, as `cga` has them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Status {
    /// All went well.
    Success,
    /// The rules or the lots have errors, or the run ended early.
    Failed,
    /// A file cannot be read or written, or the arguments are wrong.
    Unusable,
}

/// The reason why the command ends early.
#[derive(Clone, Debug, PartialEq, Eq)]
struct Problem {
    status: Status,
    message: String,
}

impl Problem {
    fn failed(message: impl ToString) -> Self {
        Problem { status: Status::Failed, message: message.to_string() }
    }

    fn unusable(message: impl ToString) -> Self {
        Problem { status: Status::Unusable, message: message.to_string() }
    }
}

fn main() -> ExitCode {
    let options = Options::parse();
    let ended = match options.command {
        Some(Command::Outlines(outlines)) => town::outlines(&outlines),
        Some(Command::View(view)) => view::view(&view),
        None if options.city.lots.is_empty() => town::town(options.city),
        None => command::city(&options.city),
    };
    let status = ended.unwrap_or_else(|problem| {
        say(problem.message);
        problem.status
    });
    ExitCode::from(status as u8)
}
