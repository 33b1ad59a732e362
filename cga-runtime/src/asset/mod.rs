//! Where `i(…)` finds meshes: those the caller hands over, then files below a folder the caller names.

use std::collections::HashMap;
use std::path::{Component, Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};

use crate::mesh::Mesh;

#[cfg(feature = "obj")]
pub mod obj;

/// Meshes by name. Files are read once and shared between runs.
#[derive(Debug, Default)]
pub struct Assets {
    root: Option<PathBuf>,
    given: HashMap<String, Arc<Mesh>>,
    read: Mutex<HashMap<String, Result<Arc<Mesh>, String>>>,
}

impl Assets {
    /// No assets: `i(…)` finds the built-in ones only.
    pub fn new() -> Self {
        Assets::default()
    }

    /// Files below a folder, by their path from it. Nothing outside is ever read.
    pub fn below(folder: impl Into<PathBuf>) -> Self {
        Assets { root: Some(folder.into()), ..Assets::default() }
    }

    /// Adds a mesh under a name; it wins over a file of that name.
    #[must_use]
    pub fn with(mut self, name: impl Into<String>, mesh: impl Into<Arc<Mesh>>) -> Self {
        self.given.insert(name.into(), mesh.into());
        self
    }

    /// The mesh of that name, or why there is none.
    ///
    /// # Errors
    /// A sentence for a fault: the file is missing, not readable, outside of the folder, or not a mesh.
    pub fn mesh(&self, name: &str) -> Result<Arc<Mesh>, String> {
        if let Some(mesh) = self.given.get(name) {
            return Ok(mesh.clone());
        }
        let mut read = self.read.lock().unwrap_or_else(PoisonError::into_inner);
        read.entry(name.to_owned()).or_insert_with(|| self.load(name)).clone()
    }

    fn load(&self, name: &str) -> Result<Arc<Mesh>, String> {
        let Some(root) = &self.root else {
            return Err("no asset folder is set".into());
        };
        let path = Path::new(name);
        if path.components().any(|part| !matches!(part, Component::Normal(_) | Component::CurDir)) {
            return Err("assets are looked up below the asset folder only".into());
        }
        read_mesh(&root.join(path), root)
    }
}

#[cfg(feature = "obj")]
fn read_mesh(path: &Path, root: &Path) -> Result<Arc<Mesh>, String> {
    if !path.extension().is_some_and(|end| end.eq_ignore_ascii_case("obj")) {
        return Err("only OBJ files can be read".into());
    }
    // A link could lead out of the folder.
    let real = path.canonicalize().map_err(|error| error.to_string())?;
    let root = root.canonicalize().map_err(|error| error.to_string())?;
    if !real.starts_with(&root) {
        return Err("assets are looked up below the asset folder only".into());
    }
    let bytes = std::fs::read(&real).map_err(|error| error.to_string())?;
    let folder = real.parent().unwrap_or(&root);
    let mut material_file = |name: &str| {
        let file = folder.join(name).canonicalize().ok().filter(|file| file.starts_with(&root))?;
        std::fs::read(file).ok()
    };
    obj::read_obj(&bytes, &mut material_file).map(|file| Arc::new(file.mesh)).map_err(|error| error.to_string())
}

#[cfg(not(feature = "obj"))]
fn read_mesh(_: &Path, _: &Path) -> Result<Arc<Mesh>, String> {
    Err("reading meshes needs the feature `obj`".into())
}
