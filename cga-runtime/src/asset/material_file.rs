//! Files of materials: MTL libraries, and the images that files of materials name.

use super::{AssetError, Assets, File, FoundAsset, image_paths};
use crate::material::Material;
use crate::value::text::Text;

/// The largest size of a file of materials, in bytes.
#[cfg(feature = "obj")]
const MOST_BYTES: u64 = 4 << 20;

impl Assets {
    /// The first material of an MTL file, with image names relative to the asset folder.
    #[cfg(feature = "obj")]
    pub(crate) fn library(&self, file: &File) -> Result<Material, AssetError> {
        let (bytes, is_all) = self.bytes(file, MOST_BYTES)?;
        if !is_all {
            return Err(AssetError::TooLong { most: MOST_BYTES });
        }
        let material = super::obj::first_material(&bytes).map_err(AssetError::Broken)?;
        Ok(match self.look_up(file)?.1 {
            FoundAsset::File(found) => image_paths::material_from_root(&material, &self.store, &found),
            FoundAsset::Given(_) | FoundAsset::Embedded(..) => material,
        })
    }

    /// MTL files are not read.
    #[cfg(not(feature = "obj"))]
    pub(crate) fn library(&self, _: &File) -> Result<Material, AssetError> {
        Err(AssetError::Format("reading MTL files needs the feature `obj`"))
    }

    /// The name of an image, relative to the asset folder, that a file names relative to itself. A name without an image stays as it is.
    pub(crate) fn image_beside(&self, file: &File, name: &Text) -> Text {
        let found = match self.look_up(file) {
            Ok((_, FoundAsset::File(found))) => image_paths::from_root(name, &self.store, &found),
            _ => None,
        };
        found.unwrap_or_else(|| name.clone())
    }
}
