//! Checks CGA rule files without a build: errors and warnings as the macro reports them, and the operations that do not
//! run yet. Findings are text with the lines of the file, one line each, or JSON.
//!
//! ```text
//! cga-check rules/            # every .cga file below a folder
//! cga-check --format short tower.cga
//! ```
#![forbid(unsafe_code)]

mod count;
mod files;
mod format;
mod options;
mod printer;

use files::LoadedFiles;
use options::{Command, Options};
use printer::Printer;
use std::io::{BufWriter, Write};
use std::process::ExitCode;
use std::time::Instant;

fn main() -> ExitCode {
    let options = match options::read(std::env::args_os().skip(1)) {
        Command::Check(options) => options,
        Command::Help => {
            print!("{}", options::HELP);
            return ExitCode::SUCCESS;
        }
        Command::Wrong(why) => {
            eprintln!("{why}\n\n{}", options::HELP);
            return ExitCode::from(2);
        }
    };
    // Whoever reads may stop reading, as `head` does: that is no failure.
    check(&options, &mut BufWriter::new(std::io::stdout().lock())).unwrap_or(ExitCode::from(2))
}

fn check(options: &Options, out: &mut dyn Write) -> std::io::Result<ExitCode> {
    let start = Instant::now();
    let mut files = match LoadedFiles::new(options.root.as_deref()) {
        Ok(files) => files,
        Err(why) => {
            eprintln!("cannot read {why}");
            return Ok(ExitCode::from(2));
        }
    };
    let (list, mut unread) = files::find(&options.paths);
    let mut numbers = Vec::new();
    for path in &list {
        match files.load(path) {
            Ok(number) => numbers.push(number),
            Err(why) => unread.push(format!("{}: {why}", path.display())),
        }
    }
    let mut printer = Printer::new(options, files.imported(&numbers));
    for number in numbers {
        printer.file(&mut files, number, out)?;
    }
    printer.totals(start.elapsed(), out)?;
    out.flush()?;
    for why in &unread {
        eprintln!("cannot read {why}");
    }
    Ok(match (unread.is_empty(), printer.has_failed()) {
        (false, _) => ExitCode::from(2),
        (true, true) => ExitCode::FAILURE,
        (true, false) => ExitCode::SUCCESS,
    })
}

#[cfg(test)]
mod tests;
