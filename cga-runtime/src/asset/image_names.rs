//! The image names of materials in files, which are relative to the file.

use std::path::Path;

use crate::asset::folder;
use crate::geometry::mesh::Mesh;
use crate::material::layer;
use crate::material::{Layer, Material, MaterialText};
use crate::value::text::Text;

/// The mesh of a file with image names relative to the asset folder. The file's materials name images relative to the
/// file; an image inside the file, whose name begins with `#`, gets the name of the file in front. Names without an
/// image stay as they are.
pub(super) fn with_names_from_root(mut mesh: Mesh, root: &Path, file: &Path) -> Mesh {
    let below_root = |path: &Path| {
        let found = folder::inside(root, path).ok()?;
        Some(found.strip_prefix(root.canonicalize().ok()?).ok()?.to_str()?.replace('\\', "/"))
    };
    let from_root = |name: &Text| {
        let found = below_root(&file.parent()?.join(name.replace('\\', "/"))).map(|found| format!("/{found}"));
        let inside = || name.starts_with('#').then(|| Some(format!("/{}{name}", below_root(file)?)))?;
        found.or_else(inside).map(Text::from)
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
