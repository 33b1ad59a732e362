//! Watches the rule files of a grammar.

use std::path::{Path, PathBuf};
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::time::Duration;

use notify::{Event, RecommendedWatcher, RecursiveMode, Watcher as _};

/// The time in which further changes join the first one: editors write a file in several steps.
const TOGETHER: Duration = Duration::from_millis(20);

/// Tells when a rule file has changed. Each copy learns of each change.
#[derive(Clone)]
pub(super) struct Watcher {
    changes: Arc<Changes>,
    /// The number of changes that this copy knows.
    known: u64,
    folders: Arc<[(PathBuf, RecursiveMode)]>,
    system: Arc<Mutex<RecommendedWatcher>>,
}

/// The number of changes so far.
#[derive(Default)]
struct Changes {
    count: Mutex<u64>,
    more: Condvar,
}

impl Changes {
    fn count(&self) -> MutexGuard<'_, u64> {
        self.count.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Watcher {
    /// Watches the folder of the rule file with its folders, and the folders above, up to the package: there imports are looked for.
    ///
    /// # Errors
    /// The system cannot watch them.
    pub(super) fn new(top: &Path, file: &str) -> Result<Self, String> {
        // Events have paths without links.
        let top = &top.canonicalize().map_err(|why| format!("{}: {why}", top.display()))?;
        let file = top.join(file);
        let folders = file.ancestors().skip(1).take_while(|folder| folder.starts_with(top));
        let folders: Arc<[(PathBuf, RecursiveMode)]> = folders
            .enumerate()
            .map(|(above, folder)| {
                // The folders below the package's own have builds in them.
                let is_whole = above == 0 && folder != top;
                (folder.to_owned(), if is_whole { RecursiveMode::Recursive } else { RecursiveMode::NonRecursive })
            })
            .collect();
        let changes = Arc::new(Changes::default());
        let (counted, watched) = (changes.clone(), folders.clone());
        let mut system = notify::recommended_watcher(move |event| {
            if is_change(&event, &watched) {
                *counted.count() += 1;
                counted.more.notify_all();
            }
        })
        .map_err(|why| why.to_string())?;
        for (folder, mode) in &*folders {
            system.watch(folder, *mode).map_err(|why| why.to_string())?;
        }
        Ok(Watcher { changes, known: 0, folders, system: Arc::new(Mutex::new(system)) })
    }

    /// Returns true if a rule file has changed since the last call.
    pub(super) fn has_changed(&mut self) -> bool {
        let is_one = *self.changes.count() != self.known;
        if is_one {
            self.join();
        }
        is_one
    }

    /// Waits until a rule file changes.
    pub(super) fn wait(&mut self) {
        let known = self.known;
        let more = self.changes.more.wait_while(self.changes.count(), |count| *count == known);
        drop(more);
        self.join();
    }

    /// Takes the changes that follow closely. Folders that were deleted and made again are watched again.
    fn join(&mut self) {
        std::thread::sleep(TOGETHER);
        let mut system = self.system.lock().unwrap_or_else(PoisonError::into_inner);
        for (folder, mode) in &*self.folders {
            // A folder that is missing is watched after the change that makes it.
            let _ = system.watch(folder, *mode);
        }
        self.known = *self.changes.count();
    }
}

/// Returns true for a change of a rule file, or of a folder that is watched.
fn is_change(event: &notify::Result<Event>, folders: &[(PathBuf, RecursiveMode)]) -> bool {
    let Ok(event) = event else { return false };
    let is_rule_file = |path: &Path| path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("cga"));
    let is_folder = |path: &Path| folders.iter().any(|(folder, _)| path == folder);
    let is_write = event.kind.is_create() || event.kind.is_modify() || event.kind.is_remove();
    is_write && event.paths.iter().any(|path| is_rule_file(path) || is_folder(path))
}
