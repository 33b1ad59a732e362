//! Images in memory.

/// An image: four bytes a pixel (sRGB red, green, blue and opacity), row by row from the upper left.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Bitmap {
    /// The width in pixels.
    pub width: usize,
    /// The height in pixels.
    pub height: usize,
    /// `4 * width * height` bytes.
    pub rgba: Vec<u8>,
}

impl Bitmap {
    /// An image of one colour.
    pub fn filled(width: usize, height: usize, color: [u8; 4]) -> Self {
        Bitmap { width, height, rgba: color.repeat(width * height) }
    }

    /// The colour of a pixel; `None` outside the image.
    #[inline]
    pub fn pixel(&self, x: usize, y: usize) -> Option<[u8; 4]> {
        let start = 4 * (y * self.width + x);
        match x < self.width {
            true => self.rgba.get(start..start + 4)?.try_into().ok(),
            false => None,
        }
    }
}
