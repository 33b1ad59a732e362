//! The files of the workspace.

use std::fs;
use std::path::{Path, PathBuf};

/// The folder of the workspace.
pub fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().expect("the workspace")
}

/// All files of the workspace with that end of their names.
pub fn files(ending: &str) -> Vec<PathBuf> {
    files_below(root(), ending)
}

/// All files below a folder with that end of their names, without what builds, runs and package managers write.
pub fn files_below(folder: &Path, ending: &str) -> Vec<PathBuf> {
    let mut list = Vec::new();
    for entry in fs::read_dir(folder).expect("a folder of the workspace") {
        let path = entry.expect("an entry").path();
        let name = path.file_name().and_then(|name| name.to_str()).unwrap_or_default();
        if path.is_dir() && !name.starts_with('.') && !matches!(name, "target" | "out" | "node_modules") {
            list.extend(files_below(&path, ending));
        } else if name.ends_with(ending) {
            list.push(path);
        }
    }
    list
}
