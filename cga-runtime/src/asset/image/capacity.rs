//! The number of pixels that compressed bytes can hold. A small file with a header of a large image is refused before the decoder takes
//! memory for the pixels. The formats give the bounds, so no valid image is refused.

/// The largest number of pixels for one byte of a JPEG file with Huffman codes, at one bit a block: the code of its first coefficient, in
/// the first scan of a progressive image too. A block has 64 samples. With all sampling factors, which are 1 to 4, an image has at least
/// one block for 128 pixels: if a component has every fourth row and another one every fourth column.
const PIXELS_PER_BYTE_OF_JPEG: u64 = 8 * 128;

/// The largest number of bytes that a byte of deflate decodes to: two codes of one bit, a length and a distance, copy 258 bytes.
const BYTES_PER_BYTE_OF_DEFLATE: u64 = 4 * 258;

/// Returns true if a JPEG file may have `pixels` pixels. Arithmetic codes have less than a bit for a block; the decoder refuses them before it
/// takes memory.
pub(super) fn jpeg_may_hold(bytes: &[u8], pixels: u64) -> bool {
    pixels <= PIXELS_PER_BYTE_OF_JPEG * bytes.len() as u64 || is_arithmetic(bytes)
}

/// Returns true if a PNG file may have `pixels` pixels.
pub(super) fn png_may_hold(bytes: &[u8], pixels: u64) -> bool {
    pixels * bits_per_pixel(bytes) <= 8 * BYTES_PER_BYTE_OF_DEFLATE * bytes.len() as u64
}

/// The bits of a pixel of a PNG file: the bits of a sample, times the number of samples of its colour type. 1 if the header is invalid.
fn bits_per_pixel(bytes: &[u8]) -> u64 {
    let Some(&[depth @ 1..=16, kind]) = bytes.get(24..26) else { return 1 };
    let samples = match kind {
        2 => 3,
        4 => 2,
        6 => 4,
        _ => 1,
    };
    u64::from(depth) * samples
}

/// Returns true if a JPEG file begins as one with arithmetic codes: tables and texts, then a frame of such a kind.
fn is_arithmetic(bytes: &[u8]) -> bool {
    let mut rest = bytes.get(2..).unwrap_or_default();
    while let [0xff, marker, high, low, ..] = *rest {
        match marker {
            0xc9..=0xcb | 0xcd..=0xcf => return true,
            0xc4 | 0xcc | 0xdb | 0xdd | 0xe0..=0xef | 0xfe => {}
            _ => return false,
        }
        let length = usize::from(u16::from_be_bytes([high, low]));
        rest = rest.get(2 + length..).unwrap_or_default();
    }
    false
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A JPEG file of `length` bytes that begins with a text and a frame of the kind `marker`.
    fn jpeg(marker: u8, length: usize) -> Vec<u8> {
        let mut bytes = [&[0xff, 0xd8, 0xff, 0xfe, 0, 4, 1, 2, 0xff, marker][..], &[0, 11, 8]].concat();
        bytes.resize(length, 0);
        bytes
    }

    #[test]
    fn a_jpeg_has_at_least_a_bit_for_128_pixels() {
        for marker in [0xc0, 0xc1, 0xc2] {
            let bytes = jpeg(marker, 940);
            assert!(jpeg_may_hold(&bytes, 940 * 1024), "{marker:x}");
            assert!(!jpeg_may_hold(&bytes, 940 * 1024 + 1), "{marker:x}");
        }
        assert!(jpeg_may_hold(&jpeg(0xc9, 940), 1 << 25), "arithmetic codes");
        // A frame that the decoder does not find is not looked for.
        assert!(!jpeg_may_hold(&[&[0xff, 0xd8, 0xff, 0xd0][..], &jpeg(0xc9, 40)].concat(), 1 << 25));
    }

    #[cfg(feature = "png")]
    #[test]
    fn the_smallest_png_files_of_one_colour_are_held() {
        use png::{BitDepth, ColorType, Compression};
        for (color, depth, bits) in [
            (ColorType::Grayscale, BitDepth::One, 1),
            (ColorType::Grayscale, BitDepth::Eight, 8),
            (ColorType::Rgb, BitDepth::Eight, 24),
            (ColorType::GrayscaleAlpha, BitDepth::Eight, 16),
            (ColorType::Rgba, BitDepth::Sixteen, 64),
        ] {
            let side: u32 = 2048;
            let mut bytes = Vec::new();
            let mut encoder = png::Encoder::new(&mut bytes, side, side);
            encoder.set_color(color);
            encoder.set_depth(depth);
            encoder.set_compression(Compression::High);
            let data = vec![0; (side * side) as usize * bits as usize / 8];
            encoder.write_header().and_then(|mut writer| writer.write_image_data(&data)).expect("an image");
            assert_eq!(bits_per_pixel(&bytes), bits);
            let pixels = u64::from(side * side);
            assert!(png_may_hold(&bytes, pixels), "{color:?}");
            let most = 8 * 1032 * bytes.len() as u64 / bits;
            assert!(png_may_hold(&bytes, most) && !png_may_hold(&bytes, most + 1), "{color:?}");
        }
    }
}
