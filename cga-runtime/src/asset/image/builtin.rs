//! Built-in textures, drawn by code.

use crate::asset::BUILTINS;
use crate::asset::image::Image;
use crate::material::layer::UNKNOWN_TEXTURE;

/// A black and white checkerboard of 16 by 16 fields.
pub(crate) const DEFAULT: &str = "builtin:default";

/// A test picture of texture space: purple at (0, 1), red at (1, 1), green at (0, 0) and cyan at (1, 0), with numbered
/// fields that make rotation and mirroring visible.
pub(crate) const UV_TEST: &str = "builtin:uvtest.png";

/// The side length of each texture in pixels.
pub(crate) const SIDE: usize = 512;

/// The number of fields along a side of the test texture.
const FIELDS: usize = 8;

/// A built-in texture.
pub(crate) fn image(name: &str) -> Option<Image> {
    match name {
        UV_TEST => Some(uv_test()),
        UNKNOWN_TEXTURE => Some(unknown()),
        _ => BUILTINS.contains(&name).then(|| checker(16, [[255; 4], [0, 0, 0, 255]])),
    }
}

/// The replacement for a texture that is missing or invalid. Its pattern is conspicuous.
pub(crate) fn unknown() -> Image {
    let mut image = checker(8, [[255, 0, 255, 255], [40, 40, 40, 255]]);
    let (width, height) = Image::text_size(48, "?");
    let at = |size: usize| (SIDE as i64 - size as i64) / 2;
    image.text(at(width), at(height), 48, "?", [255; 4]);
    image
}

fn checker(fields: usize, colors: [[u8; 4]; 2]) -> Image {
    let mut image = Image::filled(SIDE, SIDE, colors[0]);
    for (at, pixel) in image.rgba.chunks_exact_mut(4).enumerate() {
        let (x, y) = (at % SIDE * fields / SIDE, at / SIDE * fields / SIDE);
        pixel.copy_from_slice(&colors[(x + y) % 2]);
    }
    image
}

fn uv_test() -> Image {
    let (top, bottom) = ([[160, 32, 240], [230, 20, 20]], [[20, 200, 40], [0, 220, 230]]);
    let mut image = Image::filled(SIDE, SIDE, [0, 0, 0, 255]);
    for (at, pixel) in image.rgba.chunks_exact_mut(4).enumerate() {
        let (x, y) = (at % SIDE, at / SIDE);
        let is_light = (x * FIELDS / SIDE + y * FIELDS / SIDE).is_multiple_of(2);
        for channel in 0..3 {
            let mix =
                |a: i32, b: i32, share: usize| (a * (SIDE - 1 - share) as i32 + b * share as i32) / (SIDE as i32 - 1);
            let row = |ends: [[i32; 3]; 2]| mix(ends[0][channel], ends[1][channel], x);
            let color = mix(row(top), row(bottom), y);
            pixel[channel] = (if is_light { color } else { color * 3 / 4 }) as u8;
        }
    }
    let field = SIDE / FIELDS;
    for row in 0..FIELDS {
        for column in 0..FIELDS {
            // The labels increase with u and v: to the right and upwards.
            let label = format!("{column}{}", FIELDS - 1 - row);
            let (x, y) = ((column * field) as i64, (row * field) as i64);
            image.text(x + 15, y + 18, 3, &label, [255; 4]);
            image.rectangle(x, y, field, 1, [255, 255, 255, 120]);
            image.rectangle(x, y, 1, field, [255, 255, 255, 120]);
        }
    }
    image
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_corners_of_the_test_texture_have_their_colours() {
        let image = image(UV_TEST).expect("the test texture");
        let color = |u: usize, v: usize| {
            let pixel = |c: usize| if c == 0 { 5 } else { SIDE - 5 };
            let [r, g, b, a] = image.pixel(pixel(u), SIDE - 1 - pixel(v)).expect("a pixel");
            assert_eq!(a, 255);
            [r, g, b].map(|channel| 100 < channel)
        };
        assert_eq!(color(0, 0), [false, true, false]);
        assert_eq!(color(1, 0), [false, true, true]);
        assert_eq!(color(0, 1), [true, false, true]);
        assert_eq!(color(1, 1), [true, false, false]);
    }

    #[test]
    fn all_built_in_textures_are_drawn_and_differ() {
        let all = BUILTINS.map(|name| image(name).expect("a texture"));
        assert!(all[0] != all[1] && all[1] != all[2] && all[0] != all[2]);
        assert!(all.iter().all(|image| image.rgba.len() == 4 * SIDE * SIDE));
        assert_eq!(image("builtin:other"), None);
    }
}
