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

/// The most bytes that are read for a mesh: its file, and the files that it names. A small file may name a large one very often.
#[cfg(any(feature = "obj", feature = "gltf"))]
const MOST_BYTES: u64 = 1 << 30;

/// Reads a file. Image names in its materials become relative to the top of the store.
#[cfg(any(feature = "obj", feature = "gltf"))]
pub(super) fn read(store: &Store, found: &StoredFile) -> Result<MeshFile, AssetError> {
    read_within(store, found, MOST_BYTES)
}

/// Reads a file, and at most `most` bytes of it and of the files that it names.
#[cfg(any(feature = "obj", feature = "gltf"))]
fn read_within(store: &Store, found: &StoredFile, most: u64) -> Result<MeshFile, AssetError> {
    // `None` after more bytes.
    let mut left = Some(most);
    let mut read = |file: &StoredFile| {
        let all = left?;
        let bytes = store.read(file, all.saturating_add(1));
        let count = bytes.as_ref().map_or(0, |bytes| bytes.len() as u64);
        left = all.checked_sub(count);
        left.map(|_| bytes)
    };
    let bytes = read(found).ok_or_else(|| too_large(most))??;
    let mut beside = |name: &str| read(&store.beside(found, name)?)?.ok();
    let found_mesh = parsed(found.path(), &bytes, &mut beside);
    if left.is_none() {
        return Err(too_large(most));
    }
    let (mesh, images) = found_mesh?;
    let mesh = super::image_paths::with_names_from_root(mesh, store, found);
    Ok(MeshFile { mesh: Arc::new(mesh), images: images.into() })
}

#[cfg(any(feature = "obj", feature = "gltf"))]
fn too_large(most: u64) -> AssetError {
    AssetError::Broken(format!("it and the files that it names have more than {most} bytes"))
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

#[cfg(all(test, feature = "gltf"))]
mod tests {
    use super::*;

    /// The same file by many names.
    #[test]
    fn the_files_that_a_file_names_have_a_limit_in_all() {
        let folder = std::env::temp_dir().join(format!("cga-mesh-file-{}", std::process::id()));
        std::fs::create_dir_all(&folder).expect("a folder");
        let buffers: Vec<String> = (0..100)
            .map(|count| format!("{{\"uri\": \"{}data.bin\", \"byteLength\": 9}}", "./".repeat(count)))
            .collect();
        let text = format!(
            "{{\"asset\": {{\"version\": \"2.0\"}}, \"nodes\": [{{\"mesh\": 0}}], \"meshes\": [{{\"primitives\": [{{\"attributes\": \
             {{\"POSITION\": 0}}}}]}}], \"accessors\": [{{\"bufferView\": 0, \"componentType\": 5121, \"count\": 3, \"type\": \
             \"VEC3\"}}], \"bufferViews\": [{{\"buffer\": 0, \"byteLength\": 9}}], \"buffers\": [{}]}}",
            buffers.join(", ")
        );
        std::fs::write(folder.join("sail.gltf"), &text).expect("a file");
        let data = [&[0, 0, 0, 1, 0, 0, 0, 1, 0][..], &[0; 1_000]].concat();
        std::fs::write(folder.join("data.bin"), &data).expect("a file");
        let store = Store::Folder(folder.canonicalize().expect("a folder"));
        let found = store.find("sail.gltf").expect("the file");
        let all = (text.len() + 100 * data.len()) as u64;
        assert!(read_within(&store, &found, all).is_ok_and(|file| file.mesh.area() == 0.5));
        for most in [all - 1, text.len() as u64, 10] {
            let why = read_within(&store, &found, most).expect_err("too many bytes").to_string();
            assert_eq!(why, format!("it and the files that it names have more than {most} bytes"));
        }
        let _ = std::fs::remove_dir_all(&folder);
    }
}
