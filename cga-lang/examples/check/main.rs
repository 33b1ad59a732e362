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
    let mut numbers = Vec::new();
    for path in &list {
        match library.load(path) {
            Ok(number) => numbers.push(number),
            Err(why) => unread.push(format!("{}: {why}", path.display())),
        }
    }
    let mut report = Report::new(options, library.imported(&numbers));
    for number in numbers {
        report.file(&mut library, number, out)?;
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

#[cfg(test)]
mod tests {
    use super::*;

    /// The lines printed for a folder with these files.
    fn printed(name: &str, files: &[(&str, &str)]) -> String {
        let folder = std::env::temp_dir().join(format!("cga-check-{name}-{}", std::process::id()));
        std::fs::create_dir_all(&folder).expect("a folder");
        for (name, text) in files {
            std::fs::write(folder.join(name), text).expect("a file");
        }
        let options = Options { paths: vec![folder.clone()], quiet: false, warnings: true };
        let mut out = Vec::new();
        check(&options, &mut out).expect("memory takes it all");
        std::fs::remove_dir_all(&folder).expect("the folder");
        String::from_utf8(out).expect("text")
    }

    #[test]
    fn a_file_that_is_imported_needs_no_start_rule() {
        let library = ("lib.cga", "Wall(a) --> extrude(a) X.");
        let main = ("main.cga", "import lib : \"lib.cga\"\nLot --> lib.Wall(2)");
        assert!(printed("alone", &[library]).contains("warning[no_start_rule]"));
        let both = printed("both", &[library, main]);
        assert!(!both.contains("no_start_rule") && both.contains("2 files"), "{both}");
    }
}
