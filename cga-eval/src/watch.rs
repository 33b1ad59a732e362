//! Watches files.

use std::collections::BTreeSet;
use std::fmt;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::time::Duration;

use cga_source::FileList;
use notify::event::{Event, EventKind, ModifyKind};
use notify::{RecommendedWatcher, RecursiveMode, Watcher as _};

/// The time in which further changes join the first one: editors write a file in several steps.
const TOGETHER: Duration = Duration::from_millis(20);

/// Tells when files have changed. Each copy learns of each change.
///
/// The folders of the files are watched, so a file may be deleted and made again, and so may its folder. A link is watched, and so is the
/// file that it leads to.
#[derive(Clone)]
pub struct FileWatcher {
    changes: Arc<Changes>,
    /// The number of changes that this copy knows.
    known: u64,
    system: Arc<Mutex<System>>,
}

impl fmt::Debug for FileWatcher {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("FileWatcher").field("known", &self.known).finish_non_exhaustive()
    }
}

/// The files that are watched, and the number of changes so far.
#[derive(Default)]
struct Changes {
    state: Mutex<State>,
    more: Condvar,
}

#[derive(Default)]
struct State {
    count: u64,
    /// Paths without links in their folders.
    files: BTreeSet<PathBuf>,
    /// Folders whose files count, all but some.
    folders: Vec<(PathBuf, Except)>,
}

/// A condition on paths.
type Except = Box<dyn Fn(&Path) -> bool + Send>;

/// The watcher of the operating system.
struct System {
    watcher: RecommendedWatcher,
    /// The folders that it watches.
    folders: BTreeSet<(PathBuf, bool)>,
}

impl System {
    /// Watches a folder, alone or with the folders in it. A folder that was deleted and made again must be watched again.
    fn watch(&mut self, folder: &Path, is_whole: bool) -> notify::Result<()> {
        self.watcher.watch(folder, if is_whole { RecursiveMode::Recursive } else { RecursiveMode::NonRecursive })
    }
}

impl FileWatcher {
    /// Watches nothing yet.
    ///
    /// # Errors
    /// A sentence: the system cannot watch files.
    pub fn new() -> Result<Self, String> {
        let changes = Arc::new(Changes::default());
        let counted = changes.clone();
        let watcher = notify::recommended_watcher(move |event| {
            let Ok(event) = event else { return };
            let mut state = lock(&counted.state);
            if state.changed(&event) {
                state.count += 1;
                drop(state);
                counted.more.notify_all();
            }
        });
        let watcher = watcher.map_err(|why| format!("cannot watch files: {why}"))?;
        let system = Arc::new(Mutex::new(System { watcher, folders: BTreeSet::new() }));
        Ok(FileWatcher { changes, known: 0, system })
    }

    /// Watches the files of some rules, besides the others. Returns true if a folder was not watched before: a file in it may have changed
    /// since it was read, so read it again.
    ///
    /// # Errors
    /// A sentence: the folder of a file that was read cannot be watched.
    pub fn follow(&mut self, list: &FileList) -> Result<bool, String> {
        let missing = self.add(list.missing());
        let read = self.add(list.read());
        // The user may have no right to read a folder above.
        Ok(missing.unwrap_or_default() | read?)
    }

    /// Watches files, besides the others. They need not exist. Returns true if a folder was not watched before.
    ///
    /// # Errors
    /// A sentence: the folder of a file cannot be watched.
    pub fn follow_files<'p>(&mut self, files: impl IntoIterator<Item = &'p Path>) -> Result<bool, String> {
        let files: Vec<PathBuf> = files.into_iter().filter_map(|path| std::path::absolute(path).ok()).collect();
        self.add(&files)
    }

    /// Watches the files in and below a folder, except for some.
    ///
    /// # Errors
    /// A sentence: the folder cannot be watched.
    pub fn follow_folder(
        &mut self,
        folder: &Path,
        except: impl Fn(&Path) -> bool + Send + 'static,
    ) -> Result<(), String> {
        let refused = |why: &dyn fmt::Display| format!("cannot watch `{}`: {why}", folder.display());
        let real = folder.canonicalize().map_err(|why| refused(&why))?;
        let mut system = lock(&self.system);
        system.watch(&real, true).map_err(|why| refused(&why))?;
        system.folders.insert((real.clone(), true));
        lock(&self.changes.state).folders.push((real, Box::new(except)));
        Ok(())
    }

    fn add(&mut self, files: &[PathBuf]) -> Result<bool, String> {
        let mut folders = BTreeSet::new();
        for file in files {
            let own = place(file);
            let target = file.canonicalize().ok().filter(|target| *target != own.0);
            let target = target.map(|target| place(&target));
            let mut state = lock(&self.changes.state);
            for (path, folder) in std::iter::once(own).chain(target) {
                state.files.insert(path);
                folders.insert(folder);
            }
        }
        let mut system = lock(&self.system);
        let mut refused = Ok(());
        let mut is_new = false;
        for folder in folders {
            match system.watch(&folder, false) {
                Ok(()) => is_new |= system.folders.insert((folder, false)),
                Err(why) => refused = Err(format!("cannot watch `{}`: {why}", folder.display())),
            }
        }
        refused.map(|()| is_new)
    }

    /// Returns true if a file has changed since the last call.
    pub fn has_changed(&mut self) -> bool {
        let has = lock(&self.changes.state).count != self.known;
        if has {
            self.join();
        }
        has
    }

    /// Waits until a file changes.
    pub fn wait(&mut self) {
        let known = self.known;
        drop(self.changes.more.wait_while(lock(&self.changes.state), |state| state.count == known));
        self.join();
    }

    /// Takes the changes that follow closely. Folders that were deleted and made again are watched again.
    fn join(&mut self) {
        std::thread::sleep(TOGETHER);
        let mut system = lock(&self.system);
        for folder in system.folders.clone() {
            if system.watch(&folder.0, folder.1).is_err() && !folder.1 {
                // Its files are missing now, so the next rules name a folder above.
                system.folders.remove(&folder);
            }
        }
        self.known = lock(&self.changes.state).count;
    }
}

fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

/// The path of a file without links in its folders, and the folder to watch for it: the nearest that exists.
fn place(file: &Path) -> (PathBuf, PathBuf) {
    let found = file.ancestors().skip(1).find_map(|folder| Some((folder, folder.canonicalize().ok()?)));
    let Some((folder, real)) = found else { return (file.to_owned(), file.to_owned()) };
    (file.strip_prefix(folder).map_or_else(|_| file.to_owned(), |rest| real.join(rest)), real)
}

impl State {
    /// Returns true for a change of a file that is watched, or of a folder with one.
    fn changed(&self, event: &Event) -> bool {
        let is_change = event.kind.is_create() || event.kind.is_modify() || event.kind.is_remove();
        is_change && event.paths.iter().any(|path| self.is_watched(path, &event.kind))
    }

    fn is_watched(&self, path: &Path, kind: &EventKind) -> bool {
        // Folders come and go; other changes of a folder are about other files.
        let moves = !kind.is_modify() || matches!(kind, EventKind::Modify(ModifyKind::Name(_)));
        // The paths in a folder follow the folder.
        let next = self.files.range(path.to_owned()..).next();
        let is_file = next.is_some_and(|file| file == path || moves && file.starts_with(path));
        is_file || self.folders.iter().any(|(folder, except)| path.starts_with(folder) && !except(path))
    }
}

#[cfg(test)]
mod tests {
    use notify::event::{CreateKind, DataChange, MetadataKind, RemoveKind};

    use super::*;

    #[test]
    fn changes_of_files_and_of_folders_around_them_count() {
        let files = ["/town/rules/a.cga", "/town/b.cga"].map(PathBuf::from).into();
        let mut state = State { files, ..State::default() };
        let is_glb = |path: &Path| path.extension().is_some_and(|ending| ending == "glb");
        state.folders.push(("/town/assets".into(), Box::new(is_glb)));
        let (create, remove) = (EventKind::Create(CreateKind::Any), EventKind::Remove(RemoveKind::Any));
        let write = EventKind::Modify(ModifyKind::Data(DataChange::Any));
        let touch = EventKind::Modify(ModifyKind::Metadata(MetadataKind::Any));
        let changed = |path: &str, kind| state.changed(&Event::new(kind).add_path(path.into()));
        for (path, kind) in [
            ("/town/rules/a.cga", write),
            ("/town/b.cga", touch),
            ("/town/rules", create),
            ("/town", remove),
            ("/town/assets/trees/oak.obj", create),
        ] {
            assert!(changed(path, kind), "{path}");
        }
        for (path, kind) in [
            ("/town/rules/b.cga", write),
            ("/town/rules", touch),
            ("/town/rule", remove),
            ("/town/assets/out.glb", write),
            ("/town/a.cga", EventKind::Access(notify::event::AccessKind::Any)),
        ] {
            assert!(!changed(path, kind), "{path}");
        }
    }
}
