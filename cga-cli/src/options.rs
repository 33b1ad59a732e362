//! The options of the command.

use std::path::PathBuf;
use std::time::Duration;

use clap::{Args, Parser, Subcommand};

use crate::check::format::Format;

/// Checks and runs CGA rule files.
#[derive(Clone, Debug, PartialEq, Parser)]
#[command(name = "cga", version, propagate_version = true)]
pub(crate) struct Options {
    #[command(subcommand)]
    pub(crate) command: Command,
}

#[derive(Clone, Debug, PartialEq, Subcommand)]
pub(crate) enum Command {
    /// Checks rule files as the macro does
    #[command(
        after_help = "exit status: 0 no errors, 1 errors, 2 a file cannot be read, a folder has no rule file or the arguments are wrong"
    )]
    Check(CheckOptions),
    /// Runs a rule file on a lot, or on all lots of a file
    #[command(after_help = RUN_STATUS)]
    Run(RunOptions),
    /// Lists the attributes and the start rules of a rule file
    Attributes(AttributeOptions),
    /// Runs a rule file, and again whenever it or a file that it imports changes
    Watch(RunOptions),
}

const RUN_STATUS: &str = "\
Printed lines go to standard output (with `--reports -` to standard error), faults to standard error.
exit status: 0 all went well, 1 the rules have errors, a run ended early, a file has no lot, or a polygon or a
value of a file was left out (points and lines are named and do not count), 2 a file cannot be read or written
or the arguments are wrong";

/// Imported files are looked up beside the importing file and in the folders above. Each finding is reported once, in its own file. Files
/// of assets are not read: their names, groups and materials are checked by the macro alone.
#[derive(Clone, Debug, PartialEq, Eq, Args)]
pub(crate) struct CheckOptions {
    /// Rule files, and folders that are searched for *.cga
    #[arg(required = true, value_name = "FILES")]
    pub(crate) paths: Vec<PathBuf>,
    /// How findings are written: with their source lines, one line each, or one JSON object each
    #[arg(long, value_enum, default_value_t = Format::Full)]
    pub(crate) format: Format,
    /// Does not read files outside of this folder: imports and links that lead out of it are errors
    #[arg(long, value_name = "FOLDER")]
    pub(crate) root: Option<PathBuf>,
    /// Writes the summaries alone
    #[arg(long)]
    pub(crate) quiet: bool,
    /// Counts warnings but does not write them
    #[arg(long)]
    pub(crate) no_warnings: bool,
    /// Fails with warnings, too
    #[arg(long)]
    pub(crate) deny_warnings: bool,
}

/// The rules of a command that runs or describes them.
#[derive(Clone, Debug, PartialEq, Eq, Args)]
pub(crate) struct RuleOptions {
    /// The rule file
    #[arg(value_name = "FILE")]
    pub(crate) file: PathBuf,
    /// Does not read rule files outside of this folder: imports and links that lead out of it are errors
    #[arg(long, value_name = "FOLDER")]
    pub(crate) root: Option<PathBuf>,
    /// The name of the grammar in files [default: the name of the file without its ending]
    #[arg(long)]
    pub(crate) name: Option<String>,
}

#[derive(Clone, Debug, PartialEq, Args)]
pub(crate) struct RunOptions {
    #[command(flatten)]
    pub(crate) rules: RuleOptions,
    #[command(flatten)]
    pub(crate) lot: LotOptions,
    /// The rule to start with [default: the start rule of the file]
    #[arg(long, value_name = "RULE")]
    pub(crate) start: Option<String>,
    /// Sets an attribute, as in `--set height=12`
    #[arg(long = "set", value_name = "NAME=VALUE", value_parser = assignment)]
    pub(crate) values: Vec<(String, String)>,
    /// The seed of random numbers. Lots of a file have it and the following ones, in their order
    #[arg(long, default_value_t = 0)]
    pub(crate) seed: u64,
    /// The folder of meshes and images that the rules insert
    #[arg(long, value_name = "FOLDER")]
    pub(crate) assets: Option<PathBuf>,
    /// Ends the run after a number of seconds
    #[arg(long, value_name = "SECONDS", value_parser = seconds)]
    pub(crate) deadline: Option<Duration>,
    /// The file to write, by its ending: .glb, .obj, .png, .svg. May be given several times
    #[arg(short, long, value_name = "FILE")]
    pub(crate) output: Vec<PathBuf>,
    /// The width and the height of PNG pictures in pixels
    #[arg(long, value_name = "WIDTHxHEIGHT", default_value = "1200x800", value_parser = pixels)]
    pub(crate) size: (usize, usize),
    /// Writes the reported values as JSON to a file; `-` is standard output
    #[arg(long, value_name = "FILE")]
    pub(crate) reports: Option<PathBuf>,
    /// Fails if the run has faults
    #[arg(long)]
    pub(crate) deny_faults: bool,
}

/// The initial shape.
#[derive(Clone, Debug, PartialEq, Args)]
#[group(multiple = false)]
pub(crate) struct LotOptions {
    /// A rectangle: its width and its depth in metres [default: 20x15]
    #[arg(long, value_name = "WIDTHxDEPTH", value_parser = extent)]
    pub(crate) lot: Option<(f64, f64)>,
    /// Polygons of a GeoJSON file, a lot each. Properties with the names of attributes set them
    #[arg(long, value_name = "FILE")]
    pub(crate) footprint: Option<PathBuf>,
    /// The mesh of an OBJ or GLB file
    #[arg(long, value_name = "FILE")]
    pub(crate) mesh: Option<PathBuf>,
}

#[derive(Clone, Debug, PartialEq, Eq, Args)]
pub(crate) struct AttributeOptions {
    #[command(flatten)]
    pub(crate) rules: RuleOptions,
    /// Writes a JSON list
    #[arg(long)]
    pub(crate) json: bool,
}

/// `name=value`.
fn assignment(text: &str) -> Result<(String, String), String> {
    let (name, value) = text.split_once('=').ok_or("write a name, `=` and a value, as in `height=12`")?;
    Ok((name.trim().to_owned(), value.to_owned()))
}

/// Two numbers with `x` between them.
fn pair<T: std::str::FromStr>(text: &str) -> Option<(T, T)> {
    let (first, second) = text.split_once(['x', 'X', '×'])?;
    Some((first.trim().parse().ok()?, second.trim().parse().ok()?))
}

fn extent(text: &str) -> Result<(f64, f64), String> {
    let is_length = |length: f64| 0.0 < length && length.is_finite();
    let lengths = pair(text).filter(|&(width, depth)| is_length(width) && is_length(depth));
    lengths.ok_or_else(|| "write two lengths in metres, as in `20x12.5`".to_owned())
}

/// The most pixels of a side of a picture.
const MOST_PIXELS: usize = 1 << 14;

fn pixels(text: &str) -> Result<(usize, usize), String> {
    let is_size = |&(width, height): &(usize, usize)| {
        (1..=MOST_PIXELS).contains(&width.min(height)) && width.max(height) <= MOST_PIXELS
    };
    let wrong = || format!("write two numbers of pixels up to {MOST_PIXELS}, as in `1200x800`");
    pair(text).filter(is_size).ok_or_else(wrong)
}

fn seconds(text: &str) -> Result<Duration, String> {
    let limit = text.parse().ok().and_then(|seconds| Duration::try_from_secs_f64(seconds).ok());
    limit.ok_or_else(|| "write a number of seconds, as in `2.5`".to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(args: &[&str]) -> Result<Command, String> {
        let options = Options::try_parse_from(["cga"].iter().chain(args));
        options.map(|options| options.command).map_err(|error| error.to_string())
    }

    #[test]
    fn options_of_checks_are_read_in_any_order() {
        let options = CheckOptions {
            paths: vec!["a.cga".into(), "--quiet".into()],
            root: Some("rules".into()),
            format: Format::Json,
            quiet: true,
            no_warnings: false,
            deny_warnings: true,
        };
        let given =
            ["check", "--quiet", "a.cga", "--root", "rules", "--format", "json", "--deny-warnings", "--", "--quiet"];
        assert_eq!(of(&given), Ok(Command::Check(options.clone())));
        let given = ["check", "--format=json", "--root=rules", "--deny-warnings", "--quiet", "a.cga", "--", "--quiet"];
        assert_eq!(of(&given), Ok(Command::Check(options)));
    }

    #[test]
    fn options_of_runs_have_sizes_values_and_outputs() {
        let given = [
            "run",
            "a.cga",
            "--lot",
            "20x12.5",
            "--set",
            "height=12",
            "--set",
            "wall=a=b",
            "-o",
            "a.glb",
            "-o",
            "a.png",
        ];
        let Ok(Command::Run(run)) = of(&given) else { panic!("a run") };
        assert_eq!(run.lot.lot, Some((20.0, 12.5)));
        assert_eq!(
            run.values,
            [("height", "12"), ("wall", "a=b")].map(|(name, value)| (name.to_owned(), value.to_owned()))
        );
        assert_eq!((run.output.len(), run.size, run.seed), (2, (1200, 800), 0));
        let Ok(Command::Watch(watched)) = of(&["watch", "a.cga", "--deadline", "0.5"]) else { panic!("a watch") };
        assert_eq!(watched.deadline, Some(Duration::from_millis(500)));
    }

    #[test]
    fn wrong_arguments_are_named() {
        for (args, why) in [
            (&["check"][..], "<FILES>"),
            (&["check", "--fast", "a.cga"], "--fast"),
            (&["check", "--format", "xml", "a.cga"], "[possible values: full, short, json]"),
            (&["run"], "<FILE>"),
            (&["run", "a.cga", "--lot", "20"], "write two lengths in metres, as in `20x12.5`"),
            (&["run", "a.cga", "--lot", "NaNx3"], "write two lengths"),
            (&["run", "a.cga", "--lot", "0x3"], "write two lengths"),
            (&["run", "a.cga", "--lot", "3x3", "--mesh", "a.obj"], "cannot be used with"),
            (&["run", "a.cga", "--set", "height"], "as in `height=12`"),
            (&["run", "a.cga", "--size", "0x10"], "write two numbers of pixels up to 16384"),
            (&["run", "a.cga", "--deadline=-1"], "write a number of seconds"),
            (&["rum", "a.cga"], "'run'"),
        ] {
            let error = of(args).expect_err("wrong");
            assert!(error.contains(why), "{args:?}: {error}");
        }
    }
}
