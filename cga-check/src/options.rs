//! The options of the command.

use std::ffi::OsString;
use std::path::PathBuf;

use crate::format::Format;

pub(crate) const HELP: &str = "\
Checks CGA rule files as the macro does.

usage: cga-check [OPTIONS] FILES…

FILES are rule files, and folders that are searched for *.cga. Imported files are looked up beside the
importing file and in the folders above. Each finding is reported once, in its own file. Files of assets
are not read: their names, groups and materials are checked by the macro alone.

  --format full    findings with their source lines, then a summary of each file (default)
  --format short   one line for each finding: file:line:column: level[code]: message
  --format json    one JSON object for each finding, on a line of its own
  --root DIR       files outside of DIR are not read: imports and links that lead out of it are errors
  --quiet          only the summaries
  --no-warnings    warnings are counted but not reported
  --deny-warnings  warnings fail the check, too
  --help           this text

exit status: 0 no errors, 1 errors, 2 a file cannot be read or the arguments are wrong
";

#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Options {
    pub(crate) paths: Vec<PathBuf>,
    /// The folder that imports and links must not lead out of.
    pub(crate) root: Option<PathBuf>,
    pub(crate) format: Format,
    pub(crate) quiet: bool,
    pub(crate) shows_warnings: bool,
    pub(crate) denies_warnings: bool,
}

#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Command {
    Check(Options),
    Help,
    Wrong(String),
}

pub(crate) fn read(args: impl Iterator<Item = OsString>) -> Command {
    let format = Format::Full;
    let (paths, root) = (Vec::new(), None);
    let mut options = Options { paths, root, format, quiet: false, shows_warnings: true, denies_warnings: false };
    let mut only_files = false;
    let mut args = args;
    while let Some(arg) = args.next() {
        let Some(word) = arg.to_str().filter(|word| word.starts_with("--") && !only_files) else {
            options.paths.push(arg.into());
            continue;
        };
        // The name of a folder may be no Unicode.
        if word == "--root" {
            match args.next() {
                Some(folder) => options.root = Some(folder.into()),
                None => return Command::Wrong("`--root` needs a folder".into()),
            }
            continue;
        }
        let (name, value) = word.split_once('=').map_or((word, None), |(name, value)| (name, Some(value.to_owned())));
        match (name, value) {
            ("--format", value) => {
                let value = value.or_else(|| args.next().map(|next| next.to_string_lossy().into_owned()));
                let found = Format::ALL.into_iter().find(|(known, _)| Some(*known) == value.as_deref());
                match found {
                    Some((_, format)) => options.format = format,
                    None => return Command::Wrong("`--format` must be full, short or json".into()),
                }
            }
            ("--root", Some(folder)) if !folder.is_empty() => options.root = Some(folder.into()),
            ("--root", _) => return Command::Wrong("`--root` needs a folder".into()),
            ("--", None) => only_files = true,
            ("--quiet", None) => options.quiet = true,
            ("--no-warnings", None) => options.shows_warnings = false,
            ("--deny-warnings", None) => options.denies_warnings = true,
            ("--help", None) => return Command::Help,
            _ => return Command::Wrong(format!("unknown option {word}")),
        }
    }
    if options.paths.is_empty() { Command::Wrong("no files are given".into()) } else { Command::Check(options) }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(args: &[&str]) -> Command {
        read(args.iter().map(OsString::from))
    }

    #[test]
    fn options_are_read_in_any_order() {
        let options = Options {
            paths: vec!["a.cga".into(), "--quiet".into()],
            root: Some("rules".into()),
            format: Format::Json,
            quiet: true,
            shows_warnings: true,
            denies_warnings: true,
        };
        let expected = Command::Check(options);
        assert_eq!(
            of(&["--quiet", "a.cga", "--root", "rules", "--format", "json", "--deny-warnings", "--", "--quiet"]),
            expected
        );
        assert_eq!(
            of(&["--format=json", "--root=rules", "--deny-warnings", "--quiet", "a.cga", "--", "--quiet"]),
            expected
        );
        assert_eq!(of(&["a.cga", "--help"]), Command::Help);
    }

    #[test]
    fn wrong_arguments_are_named() {
        for (args, why) in [
            (&[][..], "no files are given"),
            (&["--fast"], "unknown option --fast"),
            (&["--quiet=yes"], "unknown option --quiet=yes"),
            (&["a.cga", "--root"], "`--root` needs a folder"),
            (&["a.cga", "--root="], "`--root` needs a folder"),
            (&["a.cga", "--format"], "`--format` must be full, short or json"),
            (&["--format", "xml", "a.cga"], "`--format` must be full, short or json"),
        ] {
            assert_eq!(of(args), Command::Wrong(why.into()));
        }
    }
}
