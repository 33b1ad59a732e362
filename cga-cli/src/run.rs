//! Runs a rule file.

use std::path::Path;
use std::sync::Arc;
use std::time::{Duration, Instant};

use cga::{Assets, Error, FileList, Grammar as _, RuleFile, RuleFileError, RuleLoader, Scene, Settings, Shape, Watch};

use crate::Status;
use crate::lots::lots;
use crate::options::{RuleOptions, RunOptions};
use crate::outputs::{Output, check_inputs, check_outputs, write_reports};
use crate::stream::{print_lines, say};

/// The reason why a command ends.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Problem {
    pub(crate) status: Status,
    pub(crate) message: String,
}

impl Problem {
    pub(crate) fn failed(message: impl ToString) -> Self {
        Problem { status: Status::Failed, message: message.to_string() }
    }

    pub(crate) fn unusable(message: impl ToString) -> Self {
        Problem { status: Status::Unusable, message: message.to_string() }
    }
}

/// Runs the rules once.
pub(crate) fn command(options: &RunOptions) -> Status {
    run(options, &mut |_| Ok(false)).unwrap_or_else(|problem| {
        say(problem.message);
        problem.status
    })
}

/// Loads rules, again while `follow` returns true for the files that they depend on.
///
/// # Errors
/// The file cannot be read, or its rules have errors.
pub(crate) fn load(options: &RuleOptions, follow: Follow<'_>) -> Result<RuleFile, Problem> {
    let RuleOptions { file, root, name } = options;
    let mut loader = RuleLoader::new();
    if let Some(root) = root {
        loader = loader.root(root);
    }
    if let Some(name) = name {
        loader = loader.named(name);
    }
    let path = std::path::absolute(file).map_err(Problem::unusable)?;
    // The folder of the rules is where paths in messages begin.
    let path = if root.is_some() { &path } else { file };
    let mut left = MOST_LOADS;
    loop {
        let loaded = loader.open(path);
        left -= 1;
        let files = loaded.as_ref().map_or_else(RuleFileError::files, RuleFile::files);
        if follow(files).map_err(Problem::unusable)? && left != 0 {
            continue;
        }
        return loaded.map_err(|error| {
            // A file that cannot be read is a problem of the arguments, not of the rules.
            let status = if error.files().read().is_empty() { Status::Unusable } else { Status::Failed };
            Problem { status, message: error.to_string() }
        });
    }
}

/// The most times that rules are loaded for one run.
const MOST_LOADS: usize = 4;

/// Takes the files that rules depend on. Returns true if they must be read again.
pub(crate) type Follow<'f> = &'f mut dyn FnMut(&FileList) -> Result<bool, String>;

/// Loads the rules, runs them, and writes the files.
pub(crate) fn run(options: &RunOptions, follow: Follow<'_>) -> Result<Status, Problem> {
    // Nothing runs for files that cannot be written, or for assets that do not exist.
    check_outputs(options).map_err(Problem::unusable)?;
    if let Some(folder) = options.assets.as_ref().filter(|folder| !folder.is_dir()) {
        return Err(Problem::unusable(format!(
            "cannot read assets from `{}`: the folder does not exist",
            folder.display()
        )));
    }
    let mut rules = load(&options.rules, follow)?;
    check_inputs(options, rules.files().read()).map_err(Problem::unusable)?;
    rules.warnings().iter().for_each(|warning| say(format_args!("{warning}\n")));
    for (name, value) in &options.values {
        rules.set_text(name, value).map_err(|error| Problem::unusable(format!("--set {name}: {error}")))?;
    }
    let lots = lots(&options.lot, &rules, options.seed)?;
    let settings = Settings {
        start: options.start.clone(),
        assets: Arc::new(options.assets.as_ref().map_or_else(Assets::new, Assets::below)),
        watch: options.deadline.map(Watch::deadline),
        ..Settings::default()
    };
    // The start rule of the rules may be missing, too, which is a mistake of the rules.
    if options.start.is_some()
        && let Some(Err(why @ Error::StartRule { .. })) =
            lots.shapes.first().map(|lot| rules.used_values(lot, &settings))
    {
        return Err(Problem::unusable(format!("--start: {why}")));
    }
    let begun = Instant::now();
    let output = derive(&rules, &lots.shapes, &settings).map_err(Problem::failed)?;
    let took = begun.elapsed();
    tell(options, &output).map_err(Problem::unusable)?;
    if output.report().stopped {
        let after = options.deadline.unwrap_or_default().as_secs_f64();
        return Err(Problem::failed(format!("the run was ended after {after} seconds; no file was written")));
    }
    for path in &options.output {
        output.write(path, options.size).map_err(Problem::unusable)?;
    }
    if let Some(path) = &options.reports {
        write_reports(output.report(), path).map_err(Problem::unusable)?;
    }
    summary(options, &output, lots.shapes.len(), took);
    let fails = !lots.are_whole || options.deny_faults && !output.report().faults().is_empty();
    Ok(if fails { Status::Failed } else { Status::Success })
}

/// Runs the rules on all lots. A single lot has no neighbours.
fn derive(rules: &RuleFile, lots: &[Shape], settings: &Settings) -> Result<Output, String> {
    let named = |error: Error| error.to_string();
    match lots {
        [lot] => rules.generate_with(lot, settings).map(|model| Output::One(Box::new(model))).map_err(named),
        lots => Scene::new(rules, lots).generate(settings).map(Output::Many).map_err(|error| error.to_string()),
    }
}

/// Writes the printed lines to standard output, and the faults to standard error. If the reports go to standard output, all lines go to
/// standard error, so that the output is JSON.
///
/// # Errors
/// A sentence about standard output.
fn tell(options: &RunOptions, output: &Output) -> Result<(), String> {
    let report = output.report();
    if options.reports.as_deref() == Some(Path::new("-")) {
        report.prints().iter().for_each(say);
    } else {
        print_lines(&report.prints().iter().map(|print| format!("{print}\n")).collect::<String>())?;
    }
    report.faults().iter().for_each(|fault| say(in_command(&fault.to_string())));
    if 0 < report.faults_left_out() {
        say(format_args!("… and {} more faults", report.faults_left_out()));
    }
    Ok(())
}

/// A fault in the words of the command: its messages name settings of the library.
fn in_command(fault: &str) -> String {
    fault.replace("`Settings::assets`", "`--assets FOLDER`")
}

/// Says what was made, for a person who waits.
fn summary(options: &RunOptions, output: &Output, lots: usize, took: Duration) {
    let lots = if lots == 1 { String::new() } else { format!("{lots} lots, ") };
    let files: Vec<String> = options.output.iter().map(|path| format!("`{}`", path.display())).collect();
    let written = if files.is_empty() { String::new() } else { format!("; wrote {}", files.join(", ")) };
    say(format_args!("{lots}{} parts in {:.1} ms{written}", output.parts(), 1e3 * took.as_secs_f64()));
}
