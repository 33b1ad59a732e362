//! Images as PNG files.

use std::io;
use std::path::Path;

use cga_picture::png::{self, PngError};

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
    pub fn write_png_to(&self, out: impl io::Write) -> Result<(), WriteError> {
        png::write(self.width, self.height, &self.rgba, out).map_err(error)
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
    pub fn write_indexed_png_to(&self, out: impl io::Write) -> Result<(), WriteError> {
        png::write_indexed(self.width, self.height, &self.rgba, out).map_err(error)
    }
}

/// The error of a writer of models.
fn error(error: PngError) -> WriteError {
    match error {
        PngError::Io(error) => WriteError::Io(error),
        PngError::TooLarge => WriteError::TooLarge { what: "pixels along a side", limit: png::MOST_PIXELS.into() },
    }
}
