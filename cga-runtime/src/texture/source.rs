//! The image that a name of a material leads to, for sinks that show or embed it.

use crate::asset::image::ImageHeader;
use crate::asset::{AssetError, Assets};
use crate::sink::picture::Image;

use super::builtin;

/// The image of a name.
pub(crate) enum Source {
    /// A file as it is.
    File(ImageHeader, Vec<u8>),
    /// A built-in texture, or the one in place of a file that is missing or broken.
    Drawn(Image),
    /// Nothing: without an asset folder no file is looked for.
    Absent,
}

/// Finds an image.
pub(crate) fn find(assets: Option<&Assets>, name: &str) -> Source {
    if name.starts_with("builtin:") {
        return Source::Drawn(builtin::image(name).unwrap_or_else(builtin::unknown));
    }
    match assets.map_or(Err(AssetError::NoFolder), |assets| assets.image_file(name)) {
        Ok((header, bytes)) => Source::File(header, bytes),
        Err(AssetError::NoFolder) => Source::Absent,
        Err(_) => Source::Drawn(builtin::unknown()),
    }
}

/// The pixels of an image.
#[cfg(feature = "png")]
pub(crate) fn pixels(assets: Option<&Assets>, name: &str) -> Option<Image> {
    match find(assets, name) {
        Source::File(header, bytes) => {
            Some(crate::asset::decode::decode(&header, &bytes).unwrap_or_else(|_| builtin::unknown()))
        }
        Source::Drawn(image) => Some(image),
        Source::Absent => None,
    }
}

/// The pixels of an image. Without the feature `png` files cannot be read.
#[cfg(not(feature = "png"))]
pub(crate) fn pixels(assets: Option<&Assets>, name: &str) -> Option<Image> {
    match find(assets, name) {
        Source::Drawn(image) => Some(image),
        Source::File(..) | Source::Absent => None,
    }
}
