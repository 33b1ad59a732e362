//! Runs a rule file again at each change.

use std::convert::Infallible;
use std::path::{Path, PathBuf};

use cga_eval::FileWatcher;

use crate::options::RunOptions;
use crate::outputs::check_outputs;
use crate::path::{folder, in_real_folder};
use crate::problem::Problem;
use crate::run;
use crate::status::Status;
use crate::stream::say;

/// Runs the rules, and again after each change, until the process ends. Errors are shown, and the files of the last good run stay.
pub(crate) fn command(options: &RunOptions) -> Status {
    match watch(options) {
        Ok(never) => match never {},
        Err(why) => {
            say(why);
            Status::Unusable
        }
    }
}

fn watch(options: &RunOptions) -> Result<Infallible, String> {
    // A changed file cannot mend wrong outputs.
    check_outputs(options)?;
    let mut watcher = FileWatcher::new()?;
    watcher.follow_files([options.rules.file.as_path()])?;
    follow_lots(options, &mut watcher)?;
    if let Some(folder) = &options.assets {
        let outputs: Vec<PathBuf> = options.output.iter().filter_map(|path| in_real_folder(path)).collect();
        watcher.follow_folder(folder, move |path| is_hidden(path) || is_written(&outputs, path))?;
    }
    loop {
        let done = run::run(options, &mut |files| watcher.follow(files));
        if let Err(Problem { message, .. }) = done {
            say(message);
        }
        watcher.wait();
        follow_lots(options, &mut watcher)?;
    }
}

/// Watches the files of lots. A mesh has files of materials beside it.
fn follow_lots(options: &RunOptions, watcher: &mut FileWatcher) -> Result<(), String> {
    let mut files: Vec<PathBuf> = options.lot.footprint.iter().chain(&options.lot.mesh).cloned().collect();
    if let Some(mesh) = &options.lot.mesh {
        files.push(mesh.with_extension("mtl"));
        let beside = std::fs::read_dir(folder(mesh)).into_iter().flatten().flatten().map(|entry| entry.path());
        files.extend(beside.filter(|path| path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("mtl"))));
    }
    watcher.follow_files(files.iter().map(PathBuf::as_path)).map(drop)
}

/// Returns true for a file in the making: its name begins with a point.
fn is_hidden(path: &Path) -> bool {
    path.file_name().is_some_and(|name| name.to_string_lossy().starts_with('.'))
}

/// Returns true for an output, or for the materials of one.
fn is_written(outputs: &[PathBuf], path: &Path) -> bool {
    outputs.iter().any(|output| path.with_extension("") == output.with_extension(""))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn outputs_and_files_in_the_making_start_no_run() {
        let outputs = ["/town/assets/out.obj"].map(PathBuf::from);
        for path in ["/town/assets/out.obj", "/town/assets/out.mtl"] {
            assert!(is_written(&outputs, Path::new(path)), "{path}");
        }
        assert!(!is_written(&outputs, Path::new("/town/assets/tree.obj")));
        assert!(is_hidden(Path::new("/town/assets/.cga-1.part")) && !is_hidden(Path::new("/town/.git/tree.obj")));
    }
}
