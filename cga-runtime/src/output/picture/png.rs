//! Images as PNG files.

use std::io::Write;
use std::path::Path;

use crate::asset::image::Image;
use crate::output::error::WriteError;

impl Image {
    /// The image as the bytes of a PNG file.
    ///
    /// # Errors
    /// [`WriteError::TooLarge`] for more pixels along a side than the format allows.
    pub fn to_png(&self) -> Result<Vec<u8>, WriteError> {
        let side = |pixels: usize| {
            u32::try_from(pixels)
                .map_err(|_| WriteError::TooLarge { what: "pixels along a side", limit: u64::from(u32::MAX) })
        };
        let mut bytes = Vec::new();
        let mut encoder = png::Encoder::new(&mut bytes, side(self.width)?, side(self.height)?);
        encoder.set_color(png::ColorType::Rgba);
        encoder.set_depth(png::BitDepth::Eight);
        encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual);
        let failed = |error: png::EncodingError| WriteError::Io(error.into());
        let mut writer = encoder.write_header().map_err(failed)?;
        writer.write_image_data(&self.rgba).map_err(failed)?;
        writer.finish().map_err(failed)?;
        Ok(bytes)
    }

    /// Writes the image as a PNG file.
    ///
    /// # Errors
    /// As [`Image::to_png`], and errors of the file system.
    pub fn write_png(&self, path: impl AsRef<Path>) -> Result<(), WriteError> {
        Ok(std::fs::File::create(path)?.write_all(&self.to_png()?)?)
    }
}
