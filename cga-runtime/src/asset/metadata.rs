//! Values that the author of an asset kept in its file.

use std::sync::Arc;

use super::{AssetError, Assets, File, FoundAsset, mesh_file};
use crate::value::Value;

/// Names and values, in the order in which they are searched.
pub(crate) type Metadata = Arc<[(String, Value)]>;

impl Assets {
    /// The values in the file of an asset. They are the members of `extras` in glTF files; other assets have none.
    pub(crate) fn metadata(&self, file: &File) -> Result<Metadata, AssetError> {
        let found = match self.look_up(file)? {
            (_, FoundAsset::File(found)) => found,
            (_, FoundAsset::Given(_) | FoundAsset::Embedded(..)) => return Ok(Metadata::default()),
        };
        mesh_file::readable(&file.name)?;
        if let Some(known) = self.read().metadata.get(&found) {
            return known.clone();
        }
        let metadata = mesh_file::metadata(&self.store, &found).map(Metadata::from);
        self.read().metadata.insert(found, metadata.clone());
        metadata
    }
}
