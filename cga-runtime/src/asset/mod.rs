//! Assets: meshes that the program registers, and files of a folder or a source that it sets.

mod embedded_image;
mod error;
mod file;
mod folder;
pub(crate) mod image;
mod image_paths;
mod material_file;
mod mesh_file;
mod metadata;
mod search;
mod source;
mod store;

#[cfg(feature = "gltf")]
pub mod gltf;
#[cfg(feature = "obj")]
pub mod obj;

use std::collections::{BTreeMap, HashMap};
use std::fmt;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, MutexGuard, OnceLock, PoisonError};

pub use embedded_image::EmbeddedImage;
pub use error::AssetError;
pub use file::{File, Files};
pub(crate) use search::Query;
pub use source::AssetSource;

use cga_split::files::places;

use self::image::header::ImageHeader;
use crate::asset::image::builtin;
use crate::geometry::mesh::Mesh;
use crate::material::layer::UNKNOWN_TEXTURE;
use crate::value::text::Text;
use folder::Listing;
use mesh_file::MeshFile;
use metadata::Metadata;
use store::{Store, StoredFile};

/// The limit on cached names of meshes and images. Other names are looked up each time, so that memory stays bounded.
const NAMES_KEPT: usize = 10_000;

/// The built-in textures (*Built-in assets and textures*).
pub(crate) const BUILTINS: [&str; 3] = [builtin::DEFAULT, builtin::UV_TEST, UNKNOWN_TEXTURE];

/// The group of the mesh that marks the place of a missing asset.
pub(crate) const MISSING: &str = "missing asset";

/// The names of `primitiveCube` as an asset, up to 2016.0 (*CGA changelog 2016.0*).
pub(crate) const CUBES: [&str; 2] = ["builtin:cube", "builtin:cube:notex"];

/// The extensions of usable files: images, whose paths go into models, material and text files, and tables. Meshes are
/// checked separately.
const USABLE: [&str; 10] = ["bmp", "gif", "jpg", "jpeg", "png", "tif", "tiff", "mtl", "txt", "csv"];

/// Meshes and other files by name. Each mesh is read once and shared between runs. The folder is listed once.
///
/// A name is a path with forward slashes. A name that begins with a slash is relative to the asset folder. Any other
/// name is looked up from the folder of the rule file that names it upwards: in the subfolder `assets` of each folder,
/// if it exists, and then in the folder itself (*Asset search*; [`cga_split::files::places`]).
///
/// A mesh file and the files that it names have at most 1 GiB in all. Image files have at most 256 MiB and 33,554,432 pixels, and no more
/// pixels than their bytes can hold. To decode an image takes up to 11 bytes for each pixel, and a progressive JPEG file of that size has at
/// most 24 scans, smaller ones up to 100.
#[derive(Default)]
pub struct Assets {
    store: Store,
    given: BTreeMap<String, Arc<Mesh>>,
    read: Mutex<Read>,
    listing: OnceLock<Listing>,
}

impl fmt::Debug for Assets {
    /// Writes the place of files alone: the files read so far are irrelevant for a model.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Assets").field("store", &self.store).finish_non_exhaustive()
    }
}

/// The results of earlier look-ups.
#[derive(Default)]
struct Read {
    meshes: HashMap<File, Result<Arc<Mesh>, AssetError>>,
    /// See [`Assets::image`].
    images: HashMap<File, Text>,
    /// By name as written in the material.
    headers: HashMap<String, Result<ImageHeader, AssetError>>,
    /// A file with several names is one mesh.
    files: HashMap<StoredFile, Result<MeshFile, AssetError>>,
    metadata: HashMap<StoredFile, Result<Metadata, AssetError>>,
}

impl Read {
    /// The contents of a mesh file.
    fn mesh_file(&mut self, store: &Store, found: StoredFile) -> Result<MeshFile, AssetError> {
        if let Some(known) = self.files.get(&found) {
            return known.clone();
        }
        let file = mesh_file::read(store, &found);
        self.files.insert(found, file.clone());
        file
    }

    /// Returns true if another name may be cached.
    fn has_room(&self) -> bool {
        self.meshes.len() + self.images.len() + self.headers.len() < NAMES_KEPT
    }
}

/// The target of a name.
enum FoundAsset<'a> {
    /// A mesh that the program registered.
    Given(&'a Arc<Mesh>),
    /// A file.
    File(StoredFile),
    /// An image inside a mesh file.
    Embedded(MeshFile, usize),
}

impl Assets {
    /// No assets: `i(…)` finds only the built-in ones.
    pub fn new() -> Self {
        Assets::default()
    }

    /// Files below a folder, by their path relative to it. Files outside the folder are never read.
    pub fn below(folder: impl Into<PathBuf>) -> Self {
        Assets { store: Store::Folder(folder.into()), ..Assets::default() }
    }

    /// The files of a source, for programs without a folder of assets.
    pub fn from_source(source: impl AssetSource + 'static) -> Self {
        Assets { store: Store::Source(Box::new(source)), ..Assets::default() }
    }

    /// Adds a mesh under a name. It takes precedence over a file of that name.
    #[must_use]
    pub fn with(mut self, name: impl Into<String>, mesh: impl Into<Arc<Mesh>>) -> Self {
        self.given.insert(name.into(), mesh.into());
        self.listing = OnceLock::new();
        self
    }

    /// The mesh with a name.
    ///
    /// # Errors
    /// An error if the file is missing, not readable, outside the folder, or not a mesh.
    pub fn mesh(&self, name: &str) -> Result<Arc<Mesh>, AssetError> {
        self.mesh_of(&File::from(name))
    }

    /// The mesh of a file that rules name.
    pub(crate) fn mesh_of(&self, file: &File) -> Result<Arc<Mesh>, AssetError> {
        let name = file.name.as_str();
        if let Some(mesh) = self.given.get(name) {
            return Ok(mesh.clone());
        }
        if let Some(known) = self.read().meshes.get(file) {
            return known.clone();
        }
        // A look-up may read a mesh file, so it takes place without the lock.
        let target = self.look_up(file);
        let mut read = self.read();
        let found = match target {
            Ok((_, FoundAsset::Given(mesh))) => Ok(mesh.clone()),
            Ok((_, FoundAsset::File(found))) => {
                let file = mesh_file::readable(name).and_then(|()| read.mesh_file(&self.store, found));
                file.map(|file| file.mesh)
            }
            Ok((_, FoundAsset::Embedded(..))) => Err(AssetError::Format("it is an image")),
            Err(why) => mesh_file::readable(name).and(Err(why)),
        };
        if read.has_room() {
            read.meshes.insert(file.clone(), found.clone());
        }
        found
    }

    /// Returns true if a file or mesh exists and has a usable format.
    pub(crate) fn exists(&self, file: &File) -> bool {
        let name = file.name.as_str();
        if BUILTINS.contains(&name) || CUBES.contains(&name) {
            return true;
        }
        let end = Path::new(name).extension().and_then(|end| end.to_str()).unwrap_or_default();
        let usable = || {
            USABLE.into_iter().chain(mesh_file::EXTENSIONS.iter().copied()).any(|known| known.eq_ignore_ascii_case(end))
        };
        match self.look_up(file) {
            Ok((_, FoundAsset::Given(_) | FoundAsset::Embedded(..))) => true,
            Ok((_, FoundAsset::File(_))) => usable(),
            Err(_) => false,
        }
    }

    /// The beginning of a file, at most `most` bytes, and whether that is the whole file.
    pub(crate) fn bytes(&self, file: &File, most: u64) -> Result<(Vec<u8>, bool), AssetError> {
        let mut bytes = match self.look_up(file)?.1 {
            FoundAsset::Given(_) => {
                return Err(AssetError::Format("it is a mesh that the program registered, not a file"));
            }
            FoundAsset::File(found) => self.store.read(&found, most.saturating_add(1))?,
            FoundAsset::Embedded(file, image) => file.images[image].bytes.clone(),
        };
        let all = bytes.len() as u64 <= most;
        bytes.truncate(usize::try_from(most).unwrap_or(usize::MAX));
        Ok((bytes, all))
    }

    /// The name of an image for models. This is the name as written, unless the image is found beside a rule file in a
    /// subfolder and that name would not find it from the asset folder. Then it is the path relative to the asset
    /// folder.
    pub(crate) fn image(&self, file: File) -> Text {
        if file.folder.is_empty() || file.name.is_empty() || file.name.starts_with('/') {
            return file.name;
        }
        if let Some(known) = self.read().images.get(&file) {
            return known.clone();
        }
        let outer = places(&file.name, "").unwrap_or_default();
        let image = match self.look_up(&file) {
            Ok((place, _)) if !outer.contains(&place) => Text::from(place),
            _ => file.name.clone(),
        };
        let mut read = self.read();
        if read.has_room() {
            read.images.insert(file, image.clone());
        }
        image
    }

    /// Returns true if an image is inside a mesh file.
    #[cfg(feature = "gltf")]
    pub(crate) fn is_embedded(&self, name: &str) -> bool {
        matches!(self.look_up(&File::from(name)), Ok((_, FoundAsset::Embedded(..))))
    }

    /// The results of earlier look-ups.
    fn read(&self) -> MutexGuard<'_, Read> {
        self.read.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// The target of a name, and the place where it was found. All look-ups of files use this function.
    fn look_up(&self, File { name, folder }: &File) -> Result<(String, FoundAsset<'_>), AssetError> {
        if let Some(mesh) = self.given.get(name.as_str()) {
            return Ok((name.to_string(), FoundAsset::Given(mesh)));
        }
        let mut why = None;
        for place in places(name, folder).ok_or(AssetError::Outside)? {
            if let Some(mesh) = self.given.get(&place) {
                return Ok((place, FoundAsset::Given(mesh)));
            }
            if !self.store.is_set() {
                continue;
            }
            let error = match self.store.find(&place) {
                Ok(found) => return Ok((place, FoundAsset::File(found))),
                Err(error) => error,
            };
            if is_missing(&error)
                && let Some(image) = self.embedded(&place)
            {
                return Ok((place, image));
            }
            // "Not found" is reported only if all places give it; any other error takes precedence.
            if why.as_ref().is_none_or(is_missing) {
                why = Some(error);
            }
        }
        Err(why.unwrap_or(AssetError::NoFolder))
    }

    /// An image inside a mesh file: its place ends with `#` and the name of the image.
    fn embedded(&self, place: &str) -> Option<FoundAsset<'_>> {
        let (file, _) = place.rsplit_once('#').filter(|(file, _)| mesh_file::readable(file).is_ok())?;
        let name = &place[file.len()..];
        let found = self.store.find(file).ok()?;
        let file = self.read().mesh_file(&self.store, found).ok()?;
        let image = file.images.iter().position(|EmbeddedImage { name: known, .. }| known == name)?;
        Some(FoundAsset::Embedded(file, image))
    }

    /// The names of the files that match a query in a rule file in `folder`, sorted by path, and whether files were
    /// skipped because of a limit.
    pub(crate) fn search(&self, query: &Query, folder: &str) -> (Vec<Text>, bool) {
        let listing = self.listing.get_or_init(|| self.store.listing(self.given.keys()));
        let found = listing.names.iter().filter(|name| query.finds(self.store.project(), name));
        (found.map(|name| listing.as_written(name, folder)).collect(), listing.cut_short)
    }
}

fn is_missing(error: &AssetError) -> bool {
    matches!(error, AssetError::File { kind: std::io::ErrorKind::NotFound, .. })
}
