//! The images that materials name, for sinks that show or embed them.

use crate::asset::image::Image;
use crate::asset::image::header::ImageHeader;
use crate::asset::{AssetError, Assets};

use crate::asset::image::builtin;

/// The image with a name.
pub(crate) enum ImageSource {
    /// An unchanged file.
    File(ImageHeader, Vec<u8>),
    /// A built-in texture, or the replacement of a missing or broken file.
    Drawn(Image),
    /// No image: without an asset folder, files are not looked for.
    Absent,
}

/// Finds an image.
pub(crate) fn find(assets: Option<&Assets>, name: &str) -> ImageSource {
    if name.starts_with("builtin:") {
        return ImageSource::Drawn(builtin::image(name).unwrap_or_else(builtin::unknown));
    }
    match assets.map_or(Err(AssetError::NoFolder), |assets| assets.image_file(name)) {
        Ok((header, bytes)) => ImageSource::File(header, bytes),
        Err(AssetError::NoFolder) => ImageSource::Absent,
        Err(_) => ImageSource::Drawn(builtin::unknown()),
    }
}

/// The pixels of an image.
pub(crate) struct Pixels {
    pub(crate) image: Image,
    /// True if the image has an alpha channel.
    pub(crate) has_alpha: bool,
}

impl Pixels {
    /// The opacity of a pixel, 0 to 255: its alpha if the image has an alpha channel, otherwise its brightness (CCIR
    /// 601).
    pub(crate) fn opacity(&self, [r, g, b, a]: [u8; 4]) -> u8 {
        if self.has_alpha {
            return a;
        }
        ((299 * u32::from(r) + 587 * u32::from(g) + 114 * u32::from(b) + 500) / 1000) as u8
    }
}

/// The pixels that a picture shows for a colour map: without an asset folder a checker pattern, as for a missing file.
pub(crate) fn shown(assets: Option<&Assets>, name: &str) -> Option<Pixels> {
    match find(assets, name) {
        ImageSource::Absent => Some(Pixels { image: builtin::unknown(), has_alpha: false }),
        _ => pixels(assets, name),
    }
}

/// The pixels of a file; `None` if it is missing or broken.
pub(crate) fn file_pixels(assets: Option<&Assets>, name: &str) -> Option<Pixels> {
    match find(assets, name) {
        ImageSource::File(header, bytes) => {
            let image = decoded(&header, &bytes)??;
            Some(Pixels { image, has_alpha: false })
        }
        ImageSource::Drawn(_) | ImageSource::Absent => None,
    }
}

/// The pixels of the image with a name, if there is one. Without the feature `png`, files cannot be read.
pub(crate) fn pixels(assets: Option<&Assets>, name: &str) -> Option<Pixels> {
    match find(assets, name) {
        ImageSource::File(header, bytes) => {
            let image = decoded(&header, &bytes)?;
            let has_alpha = header.has_alpha && image.is_some();
            Some(Pixels { image: image.unwrap_or_else(builtin::unknown), has_alpha })
        }
        ImageSource::Drawn(image) => Some(Pixels { image, has_alpha: false }),
        ImageSource::Absent => None,
    }
}

/// The pixels of a file; `Some(None)` if it is broken, `None` if this build cannot read files.
#[cfg(feature = "png")]
fn decoded(header: &ImageHeader, bytes: &[u8]) -> Option<Option<Image>> {
    Some(crate::asset::image::decode::decode(header, bytes).ok())
}

#[cfg(not(feature = "png"))]
fn decoded(_: &ImageHeader, _: &[u8]) -> Option<Option<Image>> {
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn opacity_is_the_alpha_channel_or_the_brightness() {
        let opacity = |has_alpha| Pixels { image: builtin::unknown(), has_alpha }.opacity([255, 0, 0, 7]);
        assert_eq!([opacity(true), opacity(false)], [7, 76]);
    }
}
