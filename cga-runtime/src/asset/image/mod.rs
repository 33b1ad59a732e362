//! Images: pictures in memory, headers of image files, and built-in textures.

pub(crate) mod builtin;
mod capacity;
#[cfg(feature = "png")]
pub(crate) mod decode;
mod font;
pub(crate) mod header;
mod lookup;

/// A picture: four bytes a pixel (sRGB red, green, blue and opacity), row by row from the upper left.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Image {
    /// The width in pixels.
    pub width: usize,
    /// The height in pixels.
    pub height: usize,
    /// `4 * width * height` bytes.
    pub rgba: Vec<u8>,
}

impl Image {
    /// A picture of one colour.
    pub fn filled(width: usize, height: usize, color: [u8; 4]) -> Self {
        Image { width, height, rgba: color.repeat(width * height) }
    }

    /// The colour of a pixel; `None` outside the picture.
    pub fn pixel(&self, x: usize, y: usize) -> Option<[u8; 4]> {
        let start = 4 * (y * self.width + x);
        match x < self.width {
            true => self.rgba.get(start..start + 4)?.try_into().ok(),
            false => None,
        }
    }

    /// Blends a colour over a pixel by its opacity. Pixels outside the picture are ignored.
    pub fn blend(&mut self, x: usize, y: usize, color: [u8; 4]) {
        let start = 4 * (y * self.width + x);
        let Some(pixel) = self.rgba.get_mut(start..start + 4) else { return };
        if self.width <= x {
            return;
        }
        let share = u32::from(color[3]);
        for channel in 0..3 {
            let (old, new) = (u32::from(pixel[channel]), u32::from(color[channel]));
            pixel[channel] = ((old * (255 - share) + new * share + 127) / 255) as u8;
        }
        pixel[3] = pixel[3].max(color[3]);
    }

    /// Blends another picture over this one, with its upper left corner at `x`, `y`. Parts outside are clipped.
    pub fn blit(&mut self, other: &Image, x: i64, y: i64) {
        for (row, line) in other.rgba.chunks_exact((4 * other.width).max(1)).enumerate() {
            let Ok(to_y) = usize::try_from(y + row as i64) else { continue };
            for (column, color) in line.chunks_exact(4).enumerate() {
                if let Ok(to_x) = usize::try_from(x + column as i64) {
                    self.blend(to_x, to_y, [color[0], color[1], color[2], color[3]]);
                }
            }
        }
    }

    /// Fills a rectangle. Parts outside are clipped.
    pub fn rectangle(&mut self, x: i64, y: i64, width: usize, height: usize, color: [u8; 4]) {
        self.blit(&Image::filled(width, height, color), x, y);
    }
}
