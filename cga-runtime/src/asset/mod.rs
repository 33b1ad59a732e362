//! Where rules find files: meshes that the caller hands over, then files below a folder the caller names.

mod error;
mod folder;
pub(crate) mod image;
mod search;

#[cfg(feature = "obj")]
pub mod obj;

use std::collections::{BTreeMap, HashMap};
use std::io::Read as _;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

pub use error::AssetError;
pub(crate) use search::Query;

use crate::mesh::Mesh;
use folder::Listing;

/// Names that led to no mesh and are remembered; others are looked up each time, so that memory stays bounded.
const FAILURES_KEPT: usize = 10_000;

/// Textures that are always there (*Built-in assets and textures*).
const BUILTINS: [&str; 2] = ["builtin:default", "builtin:uvtest.png"];

/// The names of `primitiveCube` up to 2016.0, as an asset (*CGA changelog 2016.0*).
pub(crate) const CUBES: [&str; 2] = ["builtin:cube", "builtin:cube:notex"];

/// Files that can be used, by what their names end with: images, whose paths go into models, material and text files, tables.
/// Meshes are asked for themselves.
const USABLE: [&str; 10] = ["bmp", "gif", "jpg", "jpeg", "png", "tif", "tiff", "mtl", "txt", "csv"];

/// Meshes and other files by name. Meshes are read once and shared between runs, and the folder is listed once.
///
/// A name is a path with forward slashes, looked up in the subfolder `assets` of the folder first, if there is one, and then
/// in the folder itself (*Asset search*).
#[derive(Debug, Default)]
pub struct Assets {
    root: Option<PathBuf>,
    given: BTreeMap<String, Arc<Mesh>>,
    read: Mutex<HashMap<String, Result<Arc<Mesh>, AssetError>>>,
    listing: OnceLock<Listing>,
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
        self.listing = OnceLock::new();
        self
    }

    /// The mesh of that name, or why there is none.
    ///
    /// # Errors
    /// The file is missing, not readable, outside of the folder, or not a mesh.
    pub fn mesh(&self, name: &str) -> Result<Arc<Mesh>, AssetError> {
        if let Some(mesh) = self.given.get(name) {
            return Ok(mesh.clone());
        }
        let mut read = self.read.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(known) = read.get(name) {
            return known.clone();
        }
        let found = self.root.as_deref().ok_or(AssetError::NoFolder).and_then(|root| read_mesh(root, name));
        if found.is_ok() || read.len() < FAILURES_KEPT {
            read.insert(name.to_owned(), found.clone());
        }
        found
    }

    /// Whether there is such a file or mesh, and it is of a kind that can be used.
    pub(crate) fn exists(&self, name: &str) -> bool {
        if self.given.contains_key(name) || BUILTINS.contains(&name) || CUBES.contains(&name) {
            return true;
        }
        let end = Path::new(name).extension().and_then(|end| end.to_str()).unwrap_or_default();
        let mesh = cfg!(feature = "obj").then_some("obj");
        let usable = USABLE.into_iter().chain(mesh).any(|known| known.eq_ignore_ascii_case(end));
        usable && self.file(name).is_ok()
    }

    /// The beginning of a file, at most so many bytes, and whether that is all of it.
    pub(crate) fn bytes(&self, name: &str, most: u64) -> Result<(Vec<u8>, bool), AssetError> {
        let mut bytes = Vec::new();
        std::fs::File::open(self.file(name)?)?.take(most.saturating_add(1)).read_to_end(&mut bytes)?;
        let all = bytes.len() as u64 <= most;
        bytes.truncate(usize::try_from(most).unwrap_or(usize::MAX));
        Ok((bytes, all))
    }

    /// Where a file is.
    fn file(&self, name: &str) -> Result<PathBuf, AssetError> {
        folder::readable(self.root.as_deref().ok_or(AssetError::NoFolder)?, name)
    }

    /// The names that a query finds, sorted, and whether there were too many files to look at all of them.
    pub(crate) fn search(&self, query: &Query) -> (Vec<&str>, bool) {
        let listing = self.listing.get_or_init(|| Listing::new(self.root.as_deref(), self.given.keys()));
        let project = self.root.as_deref().and_then(Path::file_name).and_then(|name| name.to_str()).unwrap_or_default();
        let found = listing.names.iter().map(String::as_str).filter(|name| query.finds(project, name));
        (found.collect(), listing.cut_short)
    }
}

#[cfg(feature = "obj")]
fn read_mesh(root: &Path, name: &str) -> Result<Arc<Mesh>, AssetError> {
    if !Path::new(name).extension().is_some_and(|end| end.eq_ignore_ascii_case("obj")) {
        return Err(AssetError::Format("only OBJ files can be read"));
    }
    let path = folder::readable(root, name)?;
    let bytes = std::fs::read(&path)?;
    let mut material_file = |name: &str| {
        let file = folder::inside(root, &path.parent()?.join(name)).ok().filter(|file| file.is_file())?;
        std::fs::read(file).ok()
    };
    let file = obj::read_obj(&bytes, &mut material_file).map_err(|error| AssetError::Broken(error.to_string()))?;
    Ok(Arc::new(file.mesh))
}

#[cfg(not(feature = "obj"))]
fn read_mesh(_: &Path, _: &str) -> Result<Arc<Mesh>, AssetError> {
    Err(AssetError::Format("reading meshes needs the feature `obj`"))
}
