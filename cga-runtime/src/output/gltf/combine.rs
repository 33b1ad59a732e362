//! Images made of other images, as the format keeps two layers in one image. Without the feature `png`, the first
//! file is used unchanged.

use super::textures::ImageKey;
use crate::asset::Assets;
use crate::asset::image::Image;
use crate::asset::image::header::MOST_PIXELS;
use crate::geometry::each::Each;
use crate::output::texture::source::{self, Pixels};
use crate::value::text::Text;

/// The PNG file for a key with several sources. `None` if it is not needed or cannot be made; the unchanged file of the
/// key then replaces it.
pub(super) fn combined(assets: Option<&Assets>, key: &ImageKey) -> Option<Vec<u8>> {
    let pixels = |name: &Option<Text>| name.as_ref().and_then(|name| source::pixels(assets, name));
    let made = match key {
        ImageKey::File(_) => None,
        ImageKey::Opaque(name) => {
            // Decoding shows which files have an alpha channel; most have none and stay unchanged.
            let has_alpha = assets.is_some_and(|assets| assets.image_header(name).is_ok_and(|head| head.has_alpha));
            let image = if has_alpha { source::pixels(assets, name) } else { None };
            image.map(|pixels| joined([Some(&pixels), None], &|[[r, g, b, _], _]| [r, g, b, 255]))
        }
        ImageKey::WithOpacity { color, opacity } => match (pixels(color), pixels(&Some(opacity.clone()))) {
            (Some(color), Some(opacity)) => {
                Some(joined([Some(&color), Some(&opacity)], &|[[r, g, b, _], other]| [r, g, b, opacity.opacity(other)]))
            }
            (None, Some(opacity)) if color.is_none() => {
                Some(joined([Some(&opacity), None], &|[pixel, _]| [255, 255, 255, opacity.opacity(pixel)]))
            }
            _ => None,
        },
        ImageKey::Metal { roughness, metallic } => {
            let images = [pixels(roughness), pixels(metallic)];
            let is_whole = images[0].is_some() == roughness.is_some() && images[1].is_some() == metallic.is_some();
            let [rough, metal] = [images[0].as_ref(), images[1].as_ref()];
            is_whole.then(|| joined([rough, metal], &|[rough, metal]| [255, rough[1], metal[2], 255]))
        }
    };
    encoded(&made?)
}

/// The image as a PNG file.
#[cfg(feature = "png")]
pub(super) fn encoded(image: &Image) -> Option<Vec<u8>> {
    image.to_png().ok()
}

#[cfg(not(feature = "png"))]
pub(super) fn encoded(_: &Image) -> Option<Vec<u8>> {
    None
}

/// Two images as one, with the larger width and the larger height. A missing image counts as white.
fn joined(images: [Option<&Pixels>; 2], pixel: &dyn Fn([[u8; 4]; 2]) -> [u8; 4]) -> Image {
    let sizes = || images.iter().flatten().map(|pixels| (pixels.image.width, pixels.image.height));
    let largest = sizes().fold((1, 1), |(w, h), (width, height)| (width.max(w), height.max(h)));
    let fits = |(width, height): (usize, usize)| (width as u64).saturating_mul(height as u64) <= MOST_PIXELS;
    let (width, height) = if fits(largest) { largest } else { sizes().next().unwrap_or((1, 1)) };
    let mut image = Image { width, height, rgba: Vec::with_capacity(4 * width * height) };
    for y in 0..height {
        for x in 0..width {
            let at =
                images.each(|pixels| pixels.map_or([255; 4], |pixels| resized(&pixels.image, [x, y], [width, height])));
            image.rgba.extend(pixel(at));
        }
    }
    image
}

/// A pixel of an image that is stretched to a size, interpolated between its four neighbours. The image repeats at
/// its borders.
fn resized(image: &Image, at: [usize; 2], size: [usize; 2]) -> [u8; 4] {
    let own = [image.width, image.height];
    if own == size {
        return image.pixel(at[0], at[1]).unwrap_or([255; 4]);
    }
    // The place in 256ths of a pixel, relative to the middle of the first pixel.
    let place = |axis: usize| {
        let (at, own, size) = (at[axis] as i64, own[axis] as i64, size[axis] as i64);
        let place = (256 * (2 * at + 1) * own / (2 * size) - 128).rem_euclid(256 * own);
        ((place / 256) as usize, ((place / 256 + 1) % own) as usize, (place % 256) as u32)
    };
    let ((x0, x1, fx), (y0, y1, fy)) = (place(0), place(1));
    let corner = |x, y| image.pixel(x, y).unwrap_or([255; 4]);
    let (a, b, c, d) = (corner(x0, y0), corner(x1, y0), corner(x0, y1), corner(x1, y1));
    let mix = |channel: usize| {
        let row =
            |left: [u8; 4], right: [u8; 4]| u32::from(left[channel]) * (256 - fx) + u32::from(right[channel]) * fx;
        ((row(a, b) * (256 - fy) + row(c, d) * fy + (1 << 15)) >> 16) as u8
    };
    [mix(0), mix(1), mix(2), mix(3)]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn pixels(width: usize, height: usize, color: [u8; 4]) -> Pixels {
        Pixels { image: Image::filled(width, height, color), has_alpha: true }
    }

    #[test]
    fn images_of_two_sizes_become_one_of_the_larger() {
        let (a, b) = (pixels(4, 1, [10, 20, 30, 40]), pixels(2, 3, [50, 60, 70, 80]));
        let image = joined([Some(&a), Some(&b)], &|[a, b]| [a[0], b[1], a[2], b[3]]);
        assert_eq!((image.width, image.height), (4, 3));
        assert!(image.rgba.as_chunks::<4>().0.iter().all(|pixel| *pixel == [10, 60, 30, 80]));
        // Two long images with a width of one pixel would make a huge one.
        let (a, b) = (pixels(1 << 16, 1, [1; 4]), pixels(1, 1 << 16, [2; 4]));
        assert_eq!(joined([Some(&a), Some(&b)], &|[a, _]| a).height, 1);
    }

    #[test]
    fn an_image_is_stretched_between_its_pixels() {
        let mut image = Image::filled(2, 1, [0; 4]);
        image.rgba[4..].fill(200);
        let row: Vec<u8> = (0..4).map(|x| resized(&image, [x, 0], [4, 1])[0]).collect();
        assert_eq!(row, [50, 50, 150, 150]);
    }
}
