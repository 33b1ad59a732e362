//! Images on surfaces: smaller copies of each, and interpolation between pixels.

use std::array::from_fn;
use std::sync::OnceLock;

use cga_geometry::each::Each;
use glam::{DVec2, Vec4};

use crate::bitmap::Bitmap;
use crate::gamma::{Gamma, linear};

/// An image and its smaller copies, each half as wide and high as the last, down to one pixel.
#[derive(Debug)]
pub(crate) struct Texture {
    levels: Vec<Bitmap>,
    encoding: Encoding,
}

/// The meaning of the bytes of an image.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Encoding {
    /// Colours.
    Srgb,
    /// Numbers, such as the directions of a normal map.
    Linear,
}

/// A texel: red, green and blue, linear, and opacity.
pub(crate) type Texel = Vec4;

/// The largest number of places that are averaged along the longer side of a sample's part of an image.
const MOST_TAPS: f64 = 16.0;

impl Encoding {
    /// Linear channels of bytes.
    fn table(self) -> &'static [f32; 256] {
        static TABLES: OnceLock<[[f32; 256]; 2]> = OnceLock::new();
        let share = |byte: usize| byte as f64 / 255.0;
        let tables = || [from_fn(|byte| linear(share(byte)) as f32), from_fn(|byte| share(byte) as f32)];
        &TABLES.get_or_init(tables)[self as usize]
    }

    fn texel(self, [r, g, b, a]: [u8; 4]) -> Texel {
        let table = self.table();
        Vec4::new(table[r as usize], table[g as usize], table[b as usize], f32::from(a) / 255.0)
    }

    /// The pixel of a texel. `gamma` is for colours.
    fn pixel(self, texel: Texel, gamma: &Gamma) -> [u8; 4] {
        let plain = |channel: f32| (channel * 255.0 + 0.5) as u8;
        let channel = |channel: f32| if self == Encoding::Srgb { gamma.byte(channel) } else { plain(channel) };
        [channel(texel.x), channel(texel.y), channel(texel.z), plain(texel.w)]
    }
}

impl Texture {
    /// Makes the smaller copies of an image.
    pub(crate) fn new(image: Bitmap, encoding: Encoding) -> Self {
        let gamma = Gamma::new();
        let mut levels = vec![image];
        while let Some(last) = levels.last()
            && 1 < last.width.max(last.height)
        {
            let half = halved(last, encoding, &gamma);
            levels.push(half);
        }
        Texture { levels, encoding }
    }

    /// The mean colour and opacity of the image.
    pub(crate) fn mean(&self) -> Texel {
        self.levels.last().and_then(|last| last.pixel(0, 0)).map_or(Vec4::ONE, |pixel| self.encoding.texel(pixel))
    }

    /// The mean colour of a parallelogram in the endlessly repeated image, given by its centre and two sides. v runs
    /// upwards.
    ///
    /// The shorter side selects a smaller copy, and several places are averaged along the longer one. So surfaces
    /// seen at an angle are neither blurred nor grainy.
    pub(crate) fn sample(&self, at: DVec2, sides: [DVec2; 2]) -> Texel {
        let own = &self.levels[0];
        let size = DVec2::new(own.width as f64, own.height as f64);
        let [a, b] = sides.each(|side| (side * size).length());
        let (long, long_side, short) = if b < a { (a, sides[0], b) } else { (b, sides[1], a) };
        if !at.is_finite() || !(long + short).is_finite() {
            return self.mean();
        }
        let taps = (long / short.max(1.0)).ceil().clamp(1.0, MOST_TAPS);
        let level = (long / taps).max(short).max(1.0);
        let level = libm::log2(level);
        let place = |tap: usize| at + long_side * ((tap as f64 + 0.5) / taps - 0.5);
        let sum: Texel = (0..taps as usize).map(|tap| self.between_levels(place(tap), level)).sum();
        sum / taps as f32
    }

    fn between_levels(&self, at: DVec2, level: f64) -> Texel {
        let last = self.levels.len() - 1;
        let level = level.min(last as f64);
        let (low, share) = (level as usize, level.fract() as f32);
        let near = between_pixels(&self.levels[low], self.encoding, at);
        if share == 0.0 {
            return near;
        }
        let far = between_pixels(&self.levels[(low + 1).min(last)], self.encoding, at);
        near + (far - near) * share
    }
}

/// The colour interpolated between four pixels.
fn between_pixels(image: &Bitmap, encoding: Encoding, at: DVec2) -> Texel {
    let place = |coordinate: f64, size: usize| {
        let place = (coordinate - libm::floor(coordinate)) * size as f64 - 0.5;
        let low = libm::floor(place);
        let first = if low < 0.0 { size - 1 } else { (low as usize).min(size - 1) };
        (first, (first + 1) % size, (place - low) as f32)
    };
    let (x0, x1, fx) = place(at.x, image.width);
    let (y0, y1, fy) = place(1.0 - at.y, image.height);
    let corner = |x, y| encoding.texel(image.pixel(x, y).unwrap_or([255; 4]));
    let (a, b, c, d) = (corner(x0, y0), corner(x1, y0), corner(x0, y1), corner(x1, y1));
    let (top, bottom) = (a + (b - a) * fx, c + (d - c) * fx);
    top + (bottom - top) * fy
}

/// The image at half its size. At an odd size the last row or column is used twice.
fn halved(image: &Bitmap, encoding: Encoding, gamma: &Gamma) -> Bitmap {
    let (width, height) = (image.width.div_ceil(2), image.height.div_ceil(2));
    let mut rgba = Vec::with_capacity(4 * width * height);
    for y in 0..height {
        for x in 0..width {
            let mut sum = Texel::ZERO;
            for (dx, dy) in [(0, 0), (1, 0), (0, 1), (1, 1)] {
                let (x, y) = ((2 * x + dx).min(image.width - 1), (2 * y + dy).min(image.height - 1));
                sum += 0.25 * encoding.texel(image.pixel(x, y).unwrap_or([255; 4]));
            }
            rgba.extend(encoding.pixel(sum, gamma));
        }
    }
    Bitmap { width, height, rgba }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn checker() -> Texture {
        let mut image = Bitmap::filled(8, 8, [255; 4]);
        for at in (0..64).filter(|at| (at % 8 + at / 8) % 2 == 1) {
            image.rgba[4 * at..4 * at + 3].fill(0);
        }
        Texture::new(image, Encoding::Srgb)
    }

    #[test]
    fn a_pixel_is_itself_and_far_away_all_are_one() {
        let texture = checker();
        assert_eq!(texture.levels.len(), 4);
        let centre = |x: f64, y: f64| DVec2::new((x + 0.5) / 8.0, 1.0 - (y + 0.5) / 8.0);
        let none = [DVec2::ZERO; 2];
        assert_eq!(texture.sample(centre(0.0, 0.0), none), Vec4::ONE);
        assert_eq!(texture.sample(centre(1.0, 0.0), none), Vec4::W);
        // The image repeats.
        assert_eq!(texture.sample(centre(-7.0, 24.0), none), Vec4::W);
        let far = texture.sample(DVec2::new(0.3, 0.4), [DVec2::X * 5.0, DVec2::Y * 5.0]);
        assert!((far[0] - 0.5).abs() < 0.01, "{far:?}");
        let aslant = texture.sample(DVec2::new(0.3, 0.4), [DVec2::X * 5.0, DVec2::Y / 64.0]);
        assert!((aslant[0] - 0.5).abs() < 0.1, "{aslant:?}");
    }

    #[test]
    fn no_coordinates_are_too_large() {
        let texture = Texture::new(Bitmap::filled(1, 1, [255, 0, 0, 128]), Encoding::Srgb);
        for huge in [1e9, -1e9, 1e300, f64::MAX, f64::INFINITY, f64::NAN] {
            for sides in [[DVec2::ZERO; 2], [DVec2::splat(huge); 2], [DVec2::X, DVec2::Y * huge]] {
                let [r, g, b, a] = texture.sample(DVec2::new(huge, 0.5), sides).to_array();
                assert!(r == 1.0 && g == 0.0 && b == 0.0 && (a - 0.5).abs() < 0.01);
                checker().sample(DVec2::new(0.5, huge), sides);
            }
        }
    }

    #[test]
    fn long_images_have_levels_of_one_pixel_width() {
        let texture = Texture::new(Bitmap::filled(5, 1, [9; 4]), Encoding::Srgb);
        let sizes: Vec<_> = texture.levels.iter().map(|level| (level.width, level.height)).collect();
        assert_eq!(sizes, [(5, 1), (3, 1), (2, 1), (1, 1)]);
    }

    /// The mean of two directions is the direction between them, and the mean of black and white is brighter than half.
    #[test]
    fn numbers_and_colours_have_other_means() {
        let mean = |encoding| {
            let mut image = Bitmap::filled(2, 1, [255; 4]);
            image.rgba[..4].copy_from_slice(&[0; 4]);
            let texture = Texture::new(image, encoding);
            texture.levels[1].pixel(0, 0)
        };
        assert_eq!(mean(Encoding::Linear), Some([128; 4]));
        assert_eq!(mean(Encoding::Srgb), Some([188, 188, 188, 128]));
    }
}
