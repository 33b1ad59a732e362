//! Watches the rule files of a grammar.

use std::path::Path;
use std::sync::mpsc::{Receiver, channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Duration;

use notify::{Event, RecommendedWatcher, RecursiveMode, Watcher as _};

/// The time in which further changes join the first one: editors write a file in several steps.
const TOGETHER: Duration = Duration::from_millis(20);

/// Tells when a rule file has changed. Copies share the changes.
#[derive(Clone)]
pub(super) struct Watcher {
    changes: Arc<Mutex<Receiver<notify::Result<Event>>>>,
    #[expect(dead_code, reason = "its life is its use")]
    system: Arc<RecommendedWatcher>,
}

impl Watcher {
    /// Watches the folder of the rule file with its folders, and the folders above, up to the package: there imports are looked for.
    ///
    /// # Errors
    /// The system cannot watch them.
    pub(super) fn new(top: &Path, file: &str) -> Result<Self, String> {
        let (send, changes) = channel();
        let mut system = notify::recommended_watcher(send).map_err(|why| why.to_string())?;
        // Events have paths without links.
        let top = &top.canonicalize().map_err(|why| format!("{}: {why}", top.display()))?;
        let file = top.join(file);
        let folders = file.ancestors().skip(1).take_while(|folder| folder.starts_with(top));
        for (above, folder) in folders.enumerate() {
            // The folders below the package's own have builds in them.
            let mode = if above == 0 && folder != top { RecursiveMode::Recursive } else { RecursiveMode::NonRecursive };
            system.watch(folder, mode).map_err(|why| why.to_string())?;
        }
        Ok(Watcher { changes: Arc::new(Mutex::new(changes)), system: Arc::new(system) })
    }

    /// Returns true if a rule file has changed since the last call.
    pub(super) fn has_changed(&self) -> bool {
        let changes = self.changes.lock().unwrap_or_else(PoisonError::into_inner);
        let is_one = changes.try_iter().filter(is_change).count() != 0;
        if is_one {
            drain(&changes);
        }
        is_one
    }

    /// Waits until a rule file changes.
    pub(super) fn wait(&self) {
        let changes = self.changes.lock().unwrap_or_else(PoisonError::into_inner);
        // It ends when the system tells of no more changes, which is when this is dropped.
        if changes.iter().any(|event| is_change(&event)) {
            drain(&changes);
        }
    }
}

/// Takes the changes that follow closely.
fn drain(changes: &Receiver<notify::Result<Event>>) {
    // Other programs may read and write files of these folders all the time, so it does not wait for silence.
    std::thread::sleep(TOGETHER);
    changes.try_iter().for_each(drop);
}

/// Returns true for a change of a rule file.
fn is_change(event: &notify::Result<Event>) -> bool {
    let Ok(event) = event else { return false };
    let is_rule_file = |path: &Path| path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("cga"));
    let is_write = event.kind.is_create() || event.kind.is_modify() || event.kind.is_remove();
    is_write && event.paths.iter().any(|path| is_rule_file(path))
}
