//! The files that rules depend on.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

/// The files on the disk that rules depend on, as absolute paths, each once. Files in memory do not count.
///
/// A change of one of them can change the rules, so programs that follow rules watch all of them.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct FileList {
    read: Vec<PathBuf>,
    missing: Vec<PathBuf>,
    known: BTreeSet<PathBuf>,
}

impl FileList {
    /// The files that were read, in the order of their first use.
    pub fn read(&self) -> &[PathBuf] {
        &self.read
    }

    /// The paths at which a file was looked for and not found, or could not be read. A file that appears there is read the next time.
    pub fn missing(&self) -> &[PathBuf] {
        &self.missing
    }

    /// Adds a file, by whether it could be read.
    pub(crate) fn add(&mut self, path: &Path, is_read: bool) {
        let Ok(path) = std::path::absolute(path) else { return };
        if self.known.insert(path.clone()) {
            let list = if is_read { &mut self.read } else { &mut self.missing };
            list.push(path);
        }
    }
}
