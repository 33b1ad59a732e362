//! Files with meshes, by the extensions of their names.

use std::path::Path;
use std::sync::Arc;

use super::AssetError;
use super::embedded_image::EmbeddedImage;
use super::store::{Store, StoredFile};
use crate::geometry::mesh::Mesh;
use crate::value::Value;

/// A mesh, and the images inside its file.
#[derive(Clone, Debug)]
pub(super) struct MeshFile {
    pub(super) mesh: Arc<Mesh>,
    pub(super) images: Arc<[EmbeddedImage]>,
}

/// The extensions of files that can be read.
pub(super) const EXTENSIONS: &[&str] = &[
    #[cfg(feature = "obj")]
    "obj",
    #[cfg(feature = "gltf")]
    "gltf",
    #[cfg(feature = "gltf")]
    "glb",
];

/// An error if a file with this name cannot be read as a mesh.
pub(super) fn readable(name: &str) -> Result<(), AssetError> {
    let end = Path::new(name).extension().and_then(|end| end.to_str()).unwrap_or_default();
    if EXTENSIONS.iter().any(|known| known.eq_ignore_ascii_case(end)) {
        return Ok(());
    }
    Err(AssetError::Format(match end.to_ascii_lowercase().as_str() {
        "obj" => "reading OBJ files needs the feature `obj`",
        "gltf" | "glb" => "reading glTF files needs the feature `gltf`",
        _ => "only OBJ and glTF files can be read",
    }))
}

/// Reads a file. Image names in its materials become relative to the top of the store.
#[cfg(any(feature = "obj", feature = "gltf"))]
pub(super) fn read(store: &Store, found: &StoredFile) -> Result<MeshFile, AssetError> {
    let bytes = store.read(found, u64::MAX)?;
    let mut beside = |name: &str| store.read(&store.beside(found, name)?, u64::MAX).ok();
    let (mesh, images) = parsed(found.path(), &bytes, &mut beside)?;
    let mesh = super::image_paths::with_names_from_root(mesh, store, found);
    Ok(MeshFile { mesh: Arc::new(mesh), images: images.into() })
}

#[cfg(not(any(feature = "obj", feature = "gltf")))]
pub(super) fn read(_: &Store, _: &StoredFile) -> Result<MeshFile, AssetError> {
    Err(AssetError::NoFolder)
}

/// The mesh in the bytes of a file, and the images inside it. `beside` returns the bytes of another file by its name.
#[cfg(any(feature = "obj", feature = "gltf"))]
fn parsed(
    path: &Path,
    bytes: &[u8],
    beside: &mut dyn FnMut(&str) -> Option<Vec<u8>>,
) -> Result<(Mesh, Vec<EmbeddedImage>), AssetError> {
    #[cfg(feature = "gltf")]
    if path.extension().is_some_and(|end| end.eq_ignore_ascii_case("gltf") || end.eq_ignore_ascii_case("glb")) {
        let file = super::gltf::read_gltf(bytes, beside).map_err(|error| AssetError::Broken(error.to_string()))?;
        return Ok((file.mesh, file.images));
    }
    #[cfg(feature = "obj")]
    if path.extension().is_some_and(|end| end.eq_ignore_ascii_case("obj")) {
        let file = super::obj::read_obj(bytes, beside).map_err(|error| AssetError::Broken(error.to_string()))?;
        return Ok((file.mesh, Vec::new()));
    }
    readable(&path.to_string_lossy()).and(Err(AssetError::NoFolder))
}

/// The values that a file keeps, with their names.
pub(super) fn metadata(store: &Store, found: &StoredFile) -> Result<Vec<(String, Value)>, AssetError> {
    #[cfg(feature = "gltf")]
    if found.path().extension().is_some_and(|end| end.eq_ignore_ascii_case("gltf") || end.eq_ignore_ascii_case("glb")) {
        let bytes = store.read(found, u64::MAX)?;
        return super::gltf::metadata(&bytes).map_err(|error| AssetError::Broken(error.to_string()));
    }
    let _ = (store, found);
    Ok(Vec::new())
}
