//! Images below the asset folder: their bytes and their headers, which are cached by name.

#[cfg(feature = "obj")]
use std::path::Path;

#[cfg(feature = "obj")]
use crate::asset::folder;
use crate::asset::image::builtin;
use crate::asset::image::header::{self, ImageHeader, ImageKind, MOST_BYTES};
use crate::asset::{AssetError, Assets, BUILTINS, File};
#[cfg(feature = "obj")]
use crate::geometry::mesh::Mesh;
#[cfg(feature = "obj")]
use crate::material::layer;
#[cfg(feature = "obj")]
use crate::material::{Layer, Material, MaterialText};
#[cfg(feature = "obj")]
use crate::value::text::Text;

impl Assets {
    /// Returns true if an asset folder is set.
    pub(crate) fn has_folder(&self) -> bool {
        self.root.is_some()
    }

    /// The header of the image that a material names. An error if no asset folder is set.
    pub(crate) fn image_header(&self, name: &str) -> Result<ImageHeader, AssetError> {
        if BUILTINS.contains(&name) {
            let side = builtin::SIDE as u32;
            return Ok(ImageHeader { kind: ImageKind::Png, width: side, height: side, has_alpha: false });
        }
        if name.starts_with("builtin:") {
            return Err(AssetError::Format("no built-in texture has this name"));
        }
        if self.root.is_none() {
            return Err(AssetError::NoFolder);
        }
        if let Some(known) = self.read().headers.get(name) {
            return known.clone();
        }
        let found = self.image_file(name).map(|(header, _)| header);
        let mut read = self.read();
        if read.has_room() {
            read.headers.insert(name.to_owned(), found.clone());
        }
        found
    }

    /// The header and the bytes of the image that a material names.
    pub(crate) fn image_file(&self, name: &str) -> Result<(ImageHeader, Vec<u8>), AssetError> {
        let (bytes, is_all) = self.bytes(&File::from(name), MOST_BYTES)?;
        if !is_all {
            return Err(AssetError::TooLong { most: MOST_BYTES });
        }
        Ok((header::header(&bytes)?, bytes))
    }
}

/// The mesh of a file with image names relative to the asset folder. The file's materials name images relative to the
/// file. Names without an image stay as they are.
#[cfg(feature = "obj")]
pub(crate) fn with_names_from_root(mut mesh: Mesh, root: &Path, file: &Path) -> Mesh {
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
