//! Images as PNG files.

use std::io;
use std::path::Path;

use super::palette::Indexed;
use crate::asset::image::Image;
use crate::output::error::WriteError;
use crate::output::whole_file;

impl Image {
    /// The image as the bytes of a PNG file. It has an alpha channel only if a pixel is not opaque: surfaces whose image
    /// has one are blended with what is behind them.
    ///
    /// # Errors
    /// [`WriteError::TooLarge`] for more pixels along a side than the format allows.
    pub fn to_png(&self) -> Result<Vec<u8>, WriteError> {
        let mut bytes = Vec::new();
        self.write_png_to(&mut bytes)?;
        Ok(bytes)
    }

    /// Writes the image as a PNG file.
    ///
    /// # Errors
    /// As [`Image::to_png`], and errors of the file system.
    pub fn write_png(&self, path: impl AsRef<Path>) -> Result<(), WriteError> {
        whole_file::write(path.as_ref(), &self.to_png()?)
    }

    /// Writes the bytes of [`Image::to_png`] to `out`, and flushes `out`.
    ///
    /// # Errors
    /// As [`Image::to_png`], and [`WriteError::Io`] with an error of `out`.
    pub fn write_png_to(&self, mut out: impl io::Write) -> Result<(), WriteError> {
        let pixels = self.rgba.as_chunks::<4>().0;
        if pixels.iter().any(|&[.., alpha]| alpha != 255) {
            return self.encode(png::ColorType::Rgba, None, &self.rgba, &mut out);
        }
        let opaque: Vec<u8> = pixels.iter().flat_map(|&[r, g, b, _]| [r, g, b]).collect();
        self.encode(png::ColorType::Rgb, None, &opaque, &mut out)
    }

    /// The image as the bytes of a PNG file with a palette of at most 256 colours, without opacity: a third to two thirds
    /// of the size.
    ///
    /// # Errors
    /// As [`Image::to_png`].
    pub fn to_indexed_png(&self) -> Result<Vec<u8>, WriteError> {
        let mut bytes = Vec::new();
        self.write_indexed_png_to(&mut bytes)?;
        Ok(bytes)
    }

    /// Writes the image as a PNG file with a palette; see [`Image::to_indexed_png`].
    ///
    /// # Errors
    /// As [`Image::to_png`], and errors of the file system.
    pub fn write_indexed_png(&self, path: impl AsRef<Path>) -> Result<(), WriteError> {
        whole_file::write(path.as_ref(), &self.to_indexed_png()?)
    }

    /// Writes the bytes of [`Image::to_indexed_png`] to `out`, and flushes `out`.
    ///
    /// # Errors
    /// As [`Image::write_png_to`].
    pub fn write_indexed_png_to(&self, mut out: impl io::Write) -> Result<(), WriteError> {
        let Indexed { mut palette, pixels } = Indexed::new(&self.rgba, self.width);
        // The format wants at least one colour.
        if palette.is_empty() {
            palette.push([0; 3]);
        }
        self.encode(png::ColorType::Indexed, Some(palette.concat()), &pixels, &mut out)
    }

    fn encode(
        &self,
        color: png::ColorType,
        palette: Option<Vec<u8>>,
        pixels: &[u8],
        out: &mut dyn io::Write,
    ) -> Result<(), WriteError> {
        let side = |pixels: usize| {
            u32::try_from(pixels)
                .map_err(|_| WriteError::TooLarge { what: "pixels along a side", limit: u64::from(u32::MAX) })
        };
        let mut encoder = png::Encoder::new(out, side(self.width)?, side(self.height)?);
        encoder.set_color(color);
        encoder.set_depth(png::BitDepth::Eight);
        encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual);
        if let Some(palette) = palette {
            encoder.set_palette(palette);
            // Neighbouring indices are not neighbouring colours, so filters make files larger.
            encoder.set_filter(png::Filter::NoFilter);
        }
        let mut writer = encoder.write_header().map_err(failed)?;
        writer.write_image_data(pixels).map_err(failed)?;
        writer.finish().map_err(failed)
    }
}

/// An error of the writer as it is, any other with its text.
fn failed(error: png::EncodingError) -> WriteError {
    WriteError::Io(match error {
        png::EncodingError::IoError(error) => error,
        other => other.into(),
    })
}
