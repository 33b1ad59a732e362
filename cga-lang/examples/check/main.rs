//! Checks rule files: what is wrong with them, and what they need that does not run yet.
//!
//! `cargo run -p cga-lang --example check -- FILES…`

mod count;
mod files;
mod options;
mod report;

use files::Library;
use options::{Asked, Options};
use report::Report;
use std::io::{BufWriter, Write};
use std::process::ExitCode;
use std::time::Instant;

fn main() -> ExitCode {
    let options = match options::read(std::env::args_os().skip(1)) {
        Asked::Check(options) => options,
        Asked::Help => {
            print!("{}", options::HELP);
            return ExitCode::SUCCESS;
        }
        Asked::Wrong(why) => {
            eprintln!("{why}\n\n{}", options::HELP);
            return ExitCode::from(2);
        }
    };
    // Whoever reads may stop reading, as `head` does: that is no failure.
    check(&options, &mut BufWriter::new(std::io::stdout().lock())).unwrap_or(ExitCode::from(2))
}

fn check(options: &Options, out: &mut dyn Write) -> std::io::Result<ExitCode> {
    let start = Instant::now();
    let (list, mut unread) = files::find(&options.paths);
    let mut library = Library::default();
    let mut report = Report::new(options);
    for path in &list {
        match library.load(path) {
            Ok(number) => report.file(&mut library, number, out)?,
            Err(why) => unread.push(format!("{}: {why}", path.display())),
        }
    }
    report.totals(start.elapsed(), out)?;
    for why in &unread {
        writeln!(out, "cannot read {why}")?;
    }
    out.flush()?;
    Ok(match (unread.is_empty(), report.has_errors()) {
        (false, _) => ExitCode::from(2),
        (true, true) => ExitCode::FAILURE,
        (true, false) => ExitCode::SUCCESS,
    })
}
