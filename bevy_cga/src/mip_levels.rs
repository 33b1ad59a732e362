//! Smaller levels of images. A renderer takes the level that fits the distance, so walls far away do not flicker.

use std::sync::LazyLock;

use bevy_color::Srgba;
use bevy_image::Image;
use wgpu_types::TextureFormat;

/// The light of each value of a channel.
static LIGHT: LazyLock<[f32; 256]> =
    LazyLock::new(|| std::array::from_fn(|value| Srgba::gamma_function(value as f32 / 255.0)));

/// Adds all smaller levels to an image with one level. Each has half the width and height of the one before. An image in another form than
/// four bytes for each pixel stays as it is.
pub(crate) fn add(image: &mut Image) {
    let size = image.texture_descriptor.size;
    let is_srgb = match image.texture_descriptor.format {
        TextureFormat::Rgba8UnormSrgb => true,
        TextureFormat::Rgba8Unorm => false,
        _ => return,
    };
    let [mut width, mut height] = [size.width, size.height].map(|pixels| pixels as usize);
    let is_single = image.texture_descriptor.mip_level_count == 1 && size.depth_or_array_layers == 1;
    let Some(levels) = image.data.as_mut().filter(|data| is_single && data.len() == 4 * width * height) else { return };
    let (mut start, mut count) = (0, 1);
    while 1 < width.max(height) {
        let half = [width, height].map(|pixels| (pixels / 2).max(1));
        let end = levels.len();
        let level: Vec<[u8; 4]> = {
            let (pixels, _) = levels[start..end].as_chunks::<4>();
            let row = |y: usize| (0..half[0]).map(move |x| mean(square(pixels, [width, height], [x, y]), is_srgb));
            (0..half[1]).flat_map(row).collect()
        };
        levels.extend(level.as_flattened());
        ([width, height], start, count) = (half, end, count + 1);
    }
    image.texture_descriptor.mip_level_count = count;
}

/// The four pixels of a level below a pixel of the next one. A level that is one pixel wide or high has them twice.
fn square(pixels: &[[u8; 4]], [width, height]: [usize; 2], [x, y]: [usize; 2]) -> [[u8; 4]; 4] {
    [[0, 0], [1, 0], [0, 1], [1, 1]].map(|[right, down]| {
        let [x, y] = [(2 * x + right).min(width - 1), (2 * y + down).min(height - 1)];
        pixels[y * width + x]
    })
}

/// The mean of four pixels. Clear pixels have no part in the colour, so that edges of leaves stay as bright as the leaves.
fn mean(pixels: [[u8; 4]; 4], is_srgb: bool) -> [u8; 4] {
    let opacity: u32 = pixels.iter().map(|pixel| u32::from(pixel[3])).sum();
    let weight = |pixel: &[u8; 4]| if opacity == 0 { 0.25 } else { f32::from(pixel[3]) / opacity as f32 };
    let channel = |channel: usize| {
        let of = |value: u8| if is_srgb { LIGHT[usize::from(value)] } else { f32::from(value) / 255.0 };
        let sum: f32 = pixels.iter().map(|pixel| of(pixel[channel]) * weight(pixel)).sum();
        let value = if is_srgb { Srgba::gamma_function_inverse(sum) } else { sum };
        (value * 255.0).round() as u8
    };
    [channel(0), channel(1), channel(2), ((opacity + 2) / 4) as u8]
}

#[cfg(test)]
mod tests {
    use super::*;
    use bevy_asset::RenderAssetUsages;
    use wgpu_types::{Extent3d, TextureDimension};

    fn image(width: u32, height: u32, pixels: &[[u8; 4]], format: TextureFormat) -> Image {
        let size = Extent3d { width, height, depth_or_array_layers: 1 };
        let data = pixels.as_flattened().to_vec();
        Image::new(size, TextureDimension::D2, data, format, RenderAssetUsages::default())
    }

    fn levels(image: &Image) -> (u32, Vec<[u8; 4]>) {
        let data = image.data.as_ref().expect("pixels");
        (image.texture_descriptor.mip_level_count, data.as_chunks::<4>().0.to_vec())
    }

    #[test]
    fn each_level_has_the_mean_of_the_one_before() {
        let [black, white] = [[0, 0, 0, 255], [255; 4]];
        let pixels = [[black, white, black, black], [white, black, black, black]].concat();
        let mut numbers = image(4, 2, &pixels, TextureFormat::Rgba8Unorm);
        add(&mut numbers);
        let [half, quarter] = [[128, 128, 128, 255], [64, 64, 64, 255]];
        assert_eq!(levels(&numbers), (3, [pixels.clone(), vec![half, black, quarter]].concat()));
        // Half of the light is 188 of 255.
        let mut colors = image(4, 2, &pixels, TextureFormat::Rgba8UnormSrgb);
        add(&mut colors);
        assert_eq!(levels(&colors).1[8..10], [[188, 188, 188, 255], black]);
    }

    #[test]
    fn clear_pixels_have_no_part_in_the_color() {
        let (leaf, clear) = ([40, 200, 60, 255], [0, 0, 0, 0]);
        for format in [TextureFormat::Rgba8UnormSrgb, TextureFormat::Rgba8Unorm] {
            let mut image = image(2, 2, &[leaf, clear, clear, clear], format);
            add(&mut image);
            assert_eq!(levels(&image).1[4], [40, 200, 60, 64]);
        }
    }

    #[test]
    fn every_size_ends_with_one_pixel() {
        for [width, height] in [[1, 1], [1, 9], [7, 3], [5, 8], [256, 1]] {
            let mut image = image(width, height, &vec![[9; 4]; (width * height) as usize], TextureFormat::Rgba8Unorm);
            add(&mut image);
            let (count, pixels) = levels(&image);
            assert_eq!(count, width.max(height).ilog2() + 1);
            let sizes = (0..count).map(|level| (width >> level).max(1) * (height >> level).max(1));
            assert_eq!(pixels, vec![[9; 4]; sizes.sum::<u32>() as usize]);
        }
    }

    #[test]
    fn other_images_stay_as_they_are() {
        let mut one = image(2, 2, &[[1; 4]; 4], TextureFormat::Rgba8Uint);
        let before = one.clone();
        add(&mut one);
        assert_eq!(one, before);
        let mut two = image(2, 2, &[[1; 4]; 4], TextureFormat::Rgba8Unorm);
        add(&mut two);
        let before = two.clone();
        add(&mut two);
        assert_eq!(two, before);
    }
}
