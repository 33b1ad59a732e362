//! Runs a rule file again at each change.

use std::path::{Path, PathBuf};
use std::sync::mpsc::{Receiver, channel};
use std::time::Duration;

use notify::{Event, RecursiveMode, Watcher as _};

use crate::Status;
use crate::options::RunOptions;
use crate::run;
use crate::stream::say;

/// The time in which further changes join the first one: editors write a file in several steps.
const TOGETHER: Duration = Duration::from_millis(20);

/// Runs the rules, and again after each change, until the process ends. Errors are shown, and the files of the last good run stay.
pub(crate) fn command(options: &RunOptions) -> Status {
    match watch(options) {
        Ok(()) => Status::Success,
        Err(why) => {
            say(why);
            Status::Unusable
        }
    }
}

fn watch(options: &RunOptions) -> Result<(), String> {
    let sources = Sources::of(options)?;
    let (send, changes) = channel();
    let mut watcher = notify::recommended_watcher(send).map_err(|why| format!("cannot watch files: {why}"))?;
    for folder in sources.folders() {
        let watched = watcher.watch(folder, RecursiveMode::Recursive);
        watched.map_err(|why| format!("cannot watch `{}`: {why}", folder.display()))?;
    }
    for folder in &sources.above {
        // The user may have no right to read it.
        let _ = watcher.watch(folder, RecursiveMode::NonRecursive);
    }
    loop {
        run::command(options);
        if !next(&changes, &sources)? {
            return Ok(());
        }
        // A folder may have been deleted and made again: then it is watched again.
        for folder in sources.folders() {
            let _ = watcher.watch(folder, RecursiveMode::Recursive);
        }
    }
}

/// Waits for a change of the sources. Returns false when no more changes come.
fn next(changes: &Receiver<notify::Result<Event>>, sources: &Sources) -> Result<bool, String> {
    loop {
        let Ok(event) = changes.recv() else { return Ok(false) };
        if sources.changed(&event.map_err(|why| format!("cannot watch files: {why}"))?) {
            break;
        }
    }
    // Other programs may read and write files of these folders all the time, so it does not wait for silence.
    std::thread::sleep(TOGETHER);
    changes.try_iter().for_each(drop);
    Ok(true)
}

/// The files that a run reads.
#[derive(Clone, Debug, PartialEq, Eq)]
struct Sources {
    /// The folders of the rules: each rule file in and below them may be imported.
    rules: Vec<PathBuf>,
    /// The folders above them: imports are looked up there, too.
    above: Vec<PathBuf>,
    /// The files of lots. A mesh has a file of materials beside it.
    lots: Vec<PathBuf>,
    /// The folder of assets.
    assets: Option<PathBuf>,
    /// The files that the run writes. They do not start another run.
    outputs: Vec<PathBuf>,
}

impl Sources {
    /// # Errors
    /// A folder does not exist.
    fn of(options: &RunOptions) -> Result<Self, String> {
        let real = |path: &Path| path.canonicalize().map_err(|why| format!("cannot watch `{}`: {why}", path.display()));
        let file = run::at(options.rules.root.as_deref(), &options.rules.file);
        let rules = std::iter::once(folder(&file)).chain(options.rules.root.as_deref());
        let lots = options.lot.footprint.iter().chain(&options.lot.mesh);
        // A file that is written for the first time does not exist yet.
        let output = |path: &PathBuf| Some(real(folder(path)).ok()?.join(path.file_name()?));
        let rules: Vec<PathBuf> = rules.map(real).collect::<Result<_, _>>()?;
        let above = rules.iter().flat_map(|folder| folder.ancestors().skip(1));
        let mut above: Vec<PathBuf> =
            above.filter(|above| !rules.iter().any(|folder| above.starts_with(folder))).map(Path::to_owned).collect();
        above.sort_unstable();
        above.dedup();
        Ok(Sources {
            rules,
            above,
            lots: lots.map(|path| real(path)).collect::<Result<_, _>>()?,
            assets: options.assets.as_deref().map(real).transpose()?,
            outputs: options.output.iter().filter_map(output).collect(),
        })
    }

    /// The folders to watch, each once.
    fn folders(&self) -> Vec<&Path> {
        let of_lots = self.lots.iter().map(|path| folder(path));
        let mut folders: Vec<&Path> =
            self.rules.iter().chain(&self.assets).map(PathBuf::as_path).chain(of_lots).collect();
        folders.sort_unstable();
        folders.dedup();
        folders
    }

    /// Returns true if an event is a change of a file that the run reads.
    fn changed(&self, event: &Event) -> bool {
        let is_change = event.kind.is_create() || event.kind.is_modify() || event.kind.is_remove();
        is_change && event.paths.iter().any(|path| self.reads(path))
    }

    fn reads(&self, path: &Path) -> bool {
        let has_ending = |ending| path.extension().is_some_and(|own| own.eq_ignore_ascii_case(ending));
        let is_below = self.rules.iter().any(|folder| path.starts_with(folder));
        let is_beside = path.parent().is_some_and(|folder| self.above.iter().any(|above| folder == above));
        let is_rule_file = has_ending("cga") && (is_below || is_beside);
        let is_folder = self.rules.iter().any(|folder| path == folder);
        let is_lot = self.lots.iter().any(|lot| path == lot || has_ending("mtl") && path.parent() == lot.parent());
        let is_asset = || {
            // Files in the making have names that begin with a point.
            let is_hidden = path.file_name().is_some_and(|name| name.to_string_lossy().starts_with('.'));
            self.assets.as_ref().is_some_and(|folder| path.starts_with(folder)) && !is_hidden && !self.writes(path)
        };
        is_rule_file || is_folder || is_lot || is_asset()
    }

    /// Returns true for an output, or for the materials of one.
    fn writes(&self, path: &Path) -> bool {
        self.outputs.iter().any(|output| path.with_extension("") == output.with_extension(""))
    }
}

/// The folder of a file.
fn folder(path: &Path) -> &Path {
    path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_run_begins_again_for_files_that_it_reads() {
        let paths = |list: &[&str]| list.iter().map(PathBuf::from).collect::<Vec<_>>();
        let sources = Sources {
            rules: paths(&["/town/rules"]),
            above: paths(&["/town", "/"]),
            lots: paths(&["/town/lots.geojson"]),
            assets: Some("/town/assets".into()),
            outputs: paths(&["/town/rules/out.glb", "/town/assets/out.obj"]),
        };
        for path in [
            "/town/rules/a.cga",
            "/town/rules/parts/b.CGA",
            "/town/rules",
            "/town/a.cga",
            "/b.cga",
            "/town/lots.geojson",
            "/town/assets/tree.obj",
            "/town/a.mtl",
        ] {
            assert!(sources.reads(Path::new(path)), "{path}");
        }
        for path in [
            "/town/rules/out.glb",
            "/town/rules/note.txt",
            "/town/houses/a.cga",
            "/town/assets/out.obj",
            "/town/assets/out.mtl",
            "/town/assets/.cga-1.part",
        ] {
            assert!(!sources.reads(Path::new(path)), "{path}");
        }
        assert_eq!(sources.folders(), ["/town", "/town/assets", "/town/rules"].map(Path::new));
    }
}
