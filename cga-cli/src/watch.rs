//! Runs a rule file again at each change.

use std::path::{Path, PathBuf};
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::time::Duration;

use notify::{Event, RecursiveMode, Watcher as _};

use crate::Status;
use crate::options::RunOptions;
use crate::run;

/// The time in which further changes join the first one: editors write a file in several steps.
const TOGETHER: Duration = Duration::from_millis(20);

/// Runs the rules, and again after each change, until the watch ends. Errors are shown, and the files of the last good run stay.
pub(crate) fn command(options: &RunOptions) -> Status {
    match watch(options) {
        Ok(()) => Status::Success,
        Err(why) => {
            eprintln!("{why}");
            Status::Unusable
        }
    }
}

fn watch(options: &RunOptions) -> Result<(), String> {
    let file = run::at(options.rules.root.as_deref(), &options.rules.file);
    let (send, changes) = channel();
    let mut watcher = notify::recommended_watcher(send).map_err(|why| format!("cannot watch files: {why}"))?;
    for folder in folders(&file, options)? {
        let watched = watcher.watch(&folder, RecursiveMode::Recursive);
        watched.map_err(|why| format!("cannot watch `{}`: {why}", folder.display()))?;
    }
    let outputs: Vec<PathBuf> = options.output.iter().filter_map(|path| std::path::absolute(path).ok()).collect();
    loop {
        run::command(options);
        if !next(&changes, &outputs)? {
            return Ok(());
        }
    }
}

/// The folders whose files a run reads: of the rules, and of assets.
fn folders(file: &Path, options: &RunOptions) -> Result<Vec<PathBuf>, String> {
    let of = |path: &Path| {
        let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
        folder.canonicalize().map_err(|why| format!("cannot watch the folder of `{}`: {why}", path.display()))
    };
    let mut folders = vec![of(file)?];
    if let Some(root) = &options.rules.root {
        folders.push(of(&root.join("rules"))?);
    }
    for path in options.lot.footprint.iter().chain(&options.lot.mesh) {
        folders.push(of(path)?);
    }
    if let Some(assets) = &options.assets {
        folders.push(of(&assets.join("assets"))?);
    }
    folders.sort();
    folders.dedup();
    Ok(folders)
}

/// Waits for a change of a file that is not written by the run itself. Returns false when no more changes come.
fn next(changes: &Receiver<notify::Result<Event>>, outputs: &[PathBuf]) -> Result<bool, String> {
    let is_change = |event: &Event| {
        let is_write = event.kind.is_create() || event.kind.is_modify() || event.kind.is_remove();
        is_write && event.paths.iter().any(|path| is_source(path, outputs))
    };
    loop {
        let Ok(event) = changes.recv() else { return Ok(false) };
        if is_change(&event.map_err(|why| format!("cannot watch files: {why}"))?) {
            break;
        }
    }
    while !matches!(changes.recv_timeout(TOGETHER), Err(RecvTimeoutError::Timeout | RecvTimeoutError::Disconnected)) {}
    Ok(true)
}

/// Returns true for a file that a run may read.
fn is_source(path: &Path, outputs: &[PathBuf]) -> bool {
    let is_output = |output: &PathBuf| {
        // Files are written under another name and then renamed; an OBJ file has its materials beside it.
        path.parent() == output.parent()
            && path
                .file_stem()
                .is_some_and(|own| output.file_stem().is_some_and(|stem| own == stem || starts_with(own, stem)))
    };
    let is_rules = path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("cga"));
    is_rules || !outputs.iter().any(is_output)
}

fn starts_with(name: &std::ffi::OsStr, start: &std::ffi::OsStr) -> bool {
    name.to_string_lossy().trim_start_matches('.').starts_with(&*start.to_string_lossy())
}
