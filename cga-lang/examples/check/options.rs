//! The options of the command.

use std::ffi::OsString;
use std::path::PathBuf;

pub(crate) const HELP: &str = "\
Checks CGA rule files as the macro would.

usage: check [--quiet] [--no-warnings] FILES…

FILES are rule files, and folders that are searched for *.cga. Files they import are looked for beside
them and in the folders above. Each finding is shown once, in the file that it is about.

  --quiet        only the summaries
  --no-warnings  warnings are counted and not shown
  --help         this

exit status: 0 fine, 1 there are errors, 2 a file cannot be read or the arguments are wrong
";

pub(crate) struct Options {
    pub(crate) paths: Vec<PathBuf>,
    pub(crate) quiet: bool,
    pub(crate) warnings: bool,
}

pub(crate) enum Asked {
    Check(Options),
    Help,
    Wrong(String),
}

pub(crate) fn read(args: impl Iterator<Item = OsString>) -> Asked {
    let mut options = Options { paths: Vec::new(), quiet: false, warnings: true };
    let mut only_files = false;
    for arg in args {
        match arg.to_str() {
            Some(word) if word.starts_with("--") && !only_files => match word {
                "--" => only_files = true,
                "--quiet" => options.quiet = true,
                "--no-warnings" => options.warnings = false,
                "--help" => return Asked::Help,
                _ => return Asked::Wrong(format!("there is no option {word}")),
            },
            _ => options.paths.push(arg.into()),
        }
    }
    if options.paths.is_empty() { Asked::Wrong("no files".into()) } else { Asked::Check(options) }
}
