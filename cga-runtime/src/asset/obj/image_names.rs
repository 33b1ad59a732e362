//! The image names of materials in files, which are relative to the file.

use std::path::Path;

use crate::asset::folder;
use crate::geometry::mesh::Mesh;
use crate::material::layer;
use crate::material::{Layer, Material, MaterialText};
use crate::value::text::Text;

/// The mesh of a file with image names relative to the asset folder. The file's materials name images relative to the
/// file. Names without an image stay as they are.
pub(in crate::asset) fn with_names_from_root(mut mesh: Mesh, root: &Path, file: &Path) -> Mesh {
    let from_root = |name: &Text| {
        let found = folder::inside(root, &file.parent()?.join(name.replace('\\', "/"))).ok()?;
        let found = found.strip_prefix(root.canonicalize().ok()?).ok()?.to_str()?.replace('\\', "/");
        Some(Text::from(format!("/{found}")))
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
    mesh.materials = mesh.materials.iter().map(named).collect();
    mesh
}
