//! The image names of materials in files, which are relative to the file.

use super::store::{Store, StoredFile};
#[cfg(any(feature = "obj", feature = "gltf"))]
use crate::geometry::mesh::Mesh;
#[cfg(any(feature = "obj", feature = "gltf"))]
use crate::material::{Layer, Material, MaterialText, layer};
use crate::value::text::Text;

/// The mesh of a file with image names relative to the asset folder. Names without an image stay as they are.
#[cfg(any(feature = "obj", feature = "gltf"))]
pub(super) fn with_names_from_root(mesh: Mesh, store: &Store, file: &StoredFile) -> Mesh {
    let named = |material: &Material| material_from_root(material, store, file);
    mesh.with_materials(mesh.materials().iter().map(named).collect::<Vec<_>>(), |number| number)
}

/// A material of a file with image names relative to the asset folder.
#[cfg(any(feature = "obj", feature = "gltf"))]
pub(super) fn material_from_root(material: &Material, store: &Store, file: &StoredFile) -> Material {
    let mut named = material.clone();
    for layer in Layer::ALL {
        if let Some(name) = layer::image(material, layer).and_then(|name| from_root(name, store, file)) {
            named.set_text(MaterialText::Map(layer), name);
        }
    }
    named
}

/// The name of an image relative to the asset folder. A file names images relative to itself; an image inside the file, whose name
/// begins with `#`, gets the name of the file in front. `None` if the image does not exist.
pub(super) fn from_root(name: &Text, store: &Store, file: &StoredFile) -> Option<Text> {
    let found = store.beside(file, &name.replace('\\', "/")).and_then(|image| store.place(&image));
    let inside = || name.starts_with('#').then(|| Some(format!("{}{name}", store.place(file)?)))?;
    found.or_else(inside).map(|place| Text::from(format!("/{place}")))
}
