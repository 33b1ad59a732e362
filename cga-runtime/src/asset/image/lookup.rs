//! Images below the asset folder: their bytes and their headers, which are cached by name.

use crate::asset::image::builtin;
use crate::asset::image::header::{self, ImageHeader, ImageKind, MOST_BYTES};
use crate::asset::{AssetError, Assets, BUILTINS, File};

impl Assets {
    /// Returns true if an asset folder or source is set.
    pub(crate) fn has_folder(&self) -> bool {
        self.store.is_set()
    }

    /// The header of the image that a material names. An error if no asset folder or source is set.
    pub(crate) fn image_header(&self, name: &str) -> Result<ImageHeader, AssetError> {
        if BUILTINS.contains(&name) {
            let side = builtin::SIDE as u32;
            return Ok(ImageHeader { kind: ImageKind::Png, width: side, height: side, has_alpha: false });
        }
        if name.starts_with("builtin:") {
            return Err(AssetError::Format("no built-in texture has this name"));
        }
        if !self.store.is_set() {
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
