//! The image names of materials in files, which are relative to the file.

use super::store::{Store, StoredFile};
use crate::geometry::mesh::Mesh;
use crate::material::layer;
use crate::material::{Layer, Material, MaterialText};
use crate::value::text::Text;

/// The mesh of a file with image names relative to the asset folder. The file's materials name images relative to the
/// file; an image inside the file, whose name begins with `#`, gets the name of the file in front. Names without an
/// image stay as they are.
pub(super) fn with_names_from_root(mesh: Mesh, store: &Store, file: &StoredFile) -> Mesh {
    let from_root = |name: &Text| {
        let found = store.beside(file, &name.replace('\\', "/")).and_then(|image| store.place(&image));
        let inside = || name.starts_with('#').then(|| Some(format!("{}{name}", store.place(file)?)))?;
        found.or_else(inside).map(|place| Text::from(format!("/{place}")))
    };
    let named = |material: &Material| {
        let mut named = material.clone();
        for layer in Layer::ALL {
            if let Some(name) = layer::image(material, layer).and_then(from_root) {
                named.set_text(MaterialText::Map(layer), name);
            }
        }
        named
    };
    mesh.with_materials(mesh.materials().iter().map(named).collect::<Vec<_>>(), |number| number)
}
