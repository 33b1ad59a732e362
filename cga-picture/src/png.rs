//! Images as PNG files.

use std::fmt;
use std::io;

use crate::bitmap::Bitmap;
use crate::palette::Indexed;

/// The reason why an image could not be written.
#[derive(Debug)]
pub enum PngError {
    /// An error of the writer, or of the encoder: an image with another number of bytes than its size needs.
    Io(io::Error),
    /// More pixels along a side than the format allows: [`MOST_PIXELS`].
    TooLarge,
}

/// The largest number of pixels along a side of a PNG file.
pub const MOST_PIXELS: u32 = u32::MAX;

impl fmt::Display for PngError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            PngError::Io(error) => write!(f, "cannot write: {error}"),
            PngError::TooLarge => write!(f, "too large: more than {MOST_PIXELS} pixels along a side"),
        }
    }
}

impl std::error::Error for PngError {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        match self {
            PngError::Io(error) => Some(error),
            PngError::TooLarge => None,
        }
    }
}

impl Bitmap {
    /// The image as the bytes of a PNG file; see [`write()`].
    ///
    /// # Errors
    /// As [`write()`].
    pub fn to_png(&self) -> Result<Vec<u8>, PngError> {
        let mut bytes = Vec::new();
        write(self.width, self.height, &self.rgba, &mut bytes)?;
        Ok(bytes)
    }
}

/// Writes an image as a PNG file to `out`, and flushes `out`. `rgba` has four bytes a pixel, as [`Bitmap::rgba`]; `width` and
/// `height` are in pixels. The file has an alpha channel only if a pixel is not opaque.
///
/// # Errors
/// [`PngError::TooLarge`] for more than [`MOST_PIXELS`] along a side, and [`PngError::Io`] with an error of `out`.
pub fn write(width: usize, height: usize, rgba: &[u8], mut out: impl io::Write) -> Result<(), PngError> {
    let pixels = rgba.as_chunks::<4>().0;
    if pixels.iter().any(|&[.., alpha]| alpha != 255) {
        return encode([width, height], png::ColorType::Rgba, None, rgba, &mut out);
    }
    let opaque: Vec<u8> = pixels.iter().flat_map(|&[r, g, b, _]| [r, g, b]).collect();
    encode([width, height], png::ColorType::Rgb, None, &opaque, &mut out)
}

/// Writes an image as [`write()`] does, but with a palette of at most 256 colours and without opacity: a third to two thirds of
/// the size.
///
/// # Errors
/// As [`write()`].
pub fn write_indexed(width: usize, height: usize, rgba: &[u8], mut out: impl io::Write) -> Result<(), PngError> {
    let Indexed { mut palette, pixels } = Indexed::new(rgba, width);
    // The format wants at least one colour.
    if palette.is_empty() {
        palette.push([0; 3]);
    }
    encode([width, height], png::ColorType::Indexed, Some(palette.concat()), &pixels, &mut out)
}

fn encode(
    size: [usize; 2],
    color: png::ColorType,
    palette: Option<Vec<u8>>,
    pixels: &[u8],
    out: &mut dyn io::Write,
) -> Result<(), PngError> {
    let [Ok(width), Ok(height)] = size.map(u32::try_from) else { return Err(PngError::TooLarge) };
    let mut encoder = png::Encoder::new(out, width, height);
    encoder.set_color(color);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual);
    if let Some(palette) = palette {
        encoder.set_palette(palette);
        encoder.set_compression(png::Compression::High);
        // Neighbouring indices are not neighbouring colours, so filters make files larger.
        encoder.set_filter(png::Filter::NoFilter);
    }
    let mut writer = encoder.write_header().map_err(failed)?;
    writer.write_image_data(pixels).map_err(failed)?;
    writer.finish().map_err(failed)
}

/// An error of the writer as it is, any other with its text.
fn failed(error: png::EncodingError) -> PngError {
    PngError::Io(match error {
        png::EncodingError::IoError(error) => error,
        other => other.into(),
    })
}
