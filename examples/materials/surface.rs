//! A surface: colour, height and roughness at each place, and its images.

use cga::sink::picture::Image;

/// The surface at a place.
#[derive(Clone, Copy)]
pub struct Texel {
    /// Red, green and blue in sRGB, from 0 to 255.
    pub color: [f64; 3],
    /// The height in millimetres.
    pub height: f64,
    /// The roughness, from 0 (polished) to 1 (matte).
    pub rough: f64,
}

/// The texel at a place of a surface for the name of a colour.
pub type TexelAt = dyn Fn([f64; 2], &str) -> Texel;

/// A surface that repeats.
pub struct Surface {
    /// The pixels along a side of its images.
    pub pixels: usize,
    /// Its width and height in millimetres.
    pub size: [f64; 2],
    /// The texel at a place in 0..1, v up, for the name of a colour.
    pub texel: Box<TexelAt>,
}

impl Surface {
    /// The texels of the image, row by row from the upper left.
    fn texels(&self, color: &str) -> Vec<Texel> {
        let place = |at: usize| (at as f64 + 0.5) / self.pixels as f64;
        let row = |y: usize| (0..self.pixels).map(move |x| (self.texel)([place(x), 1.0 - place(y)], color));
        (0..self.pixels).flat_map(row).collect()
    }

    fn image(&self, pixels: impl Iterator<Item = [f64; 3]>) -> Image {
        let byte = |channel: f64| (channel.clamp(0.0, 255.0) + 0.5) as u8;
        let rgba = pixels.flat_map(|[r, g, b]| [byte(r), byte(g), byte(b), 255]).collect();
        Image { width: self.pixels, height: self.pixels, rgba }
    }

    /// The colour map of a colour.
    pub fn color(&self, color: &str) -> Image {
        self.image(self.texels(color).into_iter().map(|texel| texel.color))
    }

    /// The normal map, with the part along u in red and the part along v in green, and the roughness map.
    pub fn relief(&self) -> [Image; 2] {
        let texels = self.texels("");
        [self.normals(&texels), self.image(texels.iter().map(|texel| [255.0 * texel.rough; 3]))]
    }

    fn normals(&self, texels: &[Texel]) -> Image {
        let pixels = self.pixels;
        let height = |x: usize, y: usize| texels[y % pixels * pixels + x % pixels].height;
        let normal = |at: usize| {
            let (x, y) = (at % pixels, at / pixels);
            let along = |rise: f64, size: f64| rise * pixels as f64 / (2.0 * size);
            let right = along(height(x + 1, y) - height(x + pixels - 1, y), self.size[0]);
            let up = along(height(x, y + pixels - 1) - height(x, y + 1), self.size[1]);
            let length = (right * right + up * up + 1.0).sqrt();
            [-right / length, -up / length, 1.0 / length].map(|part| 127.5 + 127.5 * part)
        };
        self.image((0..pixels * pixels).map(normal))
    }
}

/// Two colours mixed.
pub fn mix(a: [f64; 3], b: [f64; 3], share: f64) -> [f64; 3] {
    std::array::from_fn(|channel| a[channel] + (b[channel] - a[channel]) * share)
}

/// A lighter or darker colour.
pub fn shade(color: [f64; 3], by: f64) -> [f64; 3] {
    color.map(|channel| channel + by)
}
