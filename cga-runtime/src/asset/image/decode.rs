//! Decoding of PNG and JPEG files.

use std::io::Cursor;

use zune_jpeg::JpegDecoder;
use zune_jpeg::zune_core::bytestream::ZCursor;
use zune_jpeg::zune_core::colorspace::ColorSpace;
use zune_jpeg::zune_core::options::DecoderOptions;

use crate::asset::AssetError;
use crate::asset::image::Image;
use crate::asset::image::header::{ImageHeader, ImageKind, MOST_PIXELS};

/// The pixels of an image file, as four bytes of sRGB and opacity. Grey images, palettes and 16 bits per channel are
/// converted.
///
/// # Errors
/// The file is invalid.
pub(crate) fn decode(header: &ImageHeader, bytes: &[u8]) -> Result<Image, AssetError> {
    let image = match header.kind {
        ImageKind::Png => png(bytes),
        ImageKind::Jpeg => jpeg(bytes, header),
    };
    image.ok_or_else(|| AssetError::Broken("the image cannot be decoded".to_owned()))
}

/// A decoder that skips colour profiles and texts: half a megabyte of them may decode to half a gigabyte.
fn png_decoder(bytes: &[u8]) -> png::Decoder<Cursor<&[u8]>> {
    let limits = png::Limits { bytes: 16 * MOST_PIXELS as usize };
    let mut decoder = png::Decoder::new_with_limits(Cursor::new(bytes), limits);
    decoder.set_transformations(png::Transformations::normalize_to_color8());
    decoder.set_ignore_iccp_chunk(true);
    decoder.set_ignore_text_chunk(true);
    decoder
}

fn png(bytes: &[u8]) -> Option<Image> {
    let mut reader = png_decoder(bytes).read_info().ok()?;
    let mut pixels = vec![0; reader.output_buffer_size()?];
    let info = reader.next_frame(&mut pixels).ok()?;
    let pixels = &pixels[..info.buffer_size()];
    let opaque = |&[r, g, b]: &[u8; 3]| [r, g, b, 255];
    let rgba = match info.color_type {
        png::ColorType::Grayscale => pixels.iter().flat_map(|&y| [y, y, y, 255]).collect(),
        png::ColorType::GrayscaleAlpha => pixels.as_chunks::<2>().0.iter().flat_map(|&[y, a]| [y, y, y, a]).collect(),
        png::ColorType::Rgb => pixels.as_chunks::<3>().0.iter().flat_map(opaque).collect(),
        png::ColorType::Rgba => pixels.to_vec(),
        // The decoder expands palettes.
        png::ColorType::Indexed => return None,
    };
    whole(info.width as usize, info.height as usize, rgba)
}

fn jpeg(bytes: &[u8], header: &ImageHeader) -> Option<Image> {
    let options = DecoderOptions::default()
        .set_max_width(header.width as usize)
        .set_max_height(header.height as usize)
        .jpeg_set_max_scans(most_scans(header))
        .jpeg_set_out_colorspace(ColorSpace::RGB);
    let mut decoder = JpegDecoder::new_with_options(ZCursor::new(bytes), options);
    let pixels = decoder.decode().ok()?;
    let (width, height) = decoder.dimensions()?;
    whole(width, height, pixels.as_chunks::<3>().0.iter().flat_map(|&[r, g, b]| [r, g, b, 255]).collect())
}

/// The most scans of a progressive JPEG file that are decoded. Encoders write some ten. An empty scan has ten bytes, and the decoder goes
/// over all blocks for it, so large images have fewer.
fn most_scans(header: &ImageHeader) -> usize {
    let pixels = u64::from(header.width) * u64::from(header.height);
    (SCANNED_PIXELS / pixels.max(1)).clamp(24, 100) as usize
}

/// The pixels of all scans of an image, where it has more than 24.
const SCANNED_PIXELS: u64 = 24 * MOST_PIXELS;

fn whole(width: usize, height: usize, rgba: Vec<u8>) -> Option<Image> {
    (rgba.len() == 4 * width * height).then_some(Image { width, height, rgba })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::asset::image::header::header;

    fn encoded(color: png::ColorType, depth: png::BitDepth, size: u32, data: &[u8]) -> Vec<u8> {
        let mut bytes = Vec::new();
        let mut encoder = png::Encoder::new(&mut bytes, size, 1);
        encoder.set_color(color);
        encoder.set_depth(depth);
        if color == png::ColorType::Indexed {
            encoder.set_palette(vec![10, 20, 30, 40, 50, 60]);
            encoder.set_trns(vec![255, 128]);
        }
        encoder.write_header().and_then(|mut writer| writer.write_image_data(data)).expect("an image");
        bytes
    }

    fn pixels(bytes: &[u8]) -> Vec<[u8; 4]> {
        let image = decode(&header(bytes).expect("a header"), bytes).expect("pixels");
        image.rgba.as_chunks::<4>().0.to_vec()
    }

    #[test]
    fn all_kinds_of_png_become_four_bytes_a_pixel() {
        use png::{BitDepth, ColorType};
        assert_eq!(pixels(&encoded(ColorType::Grayscale, BitDepth::Eight, 1, &[7])), [[7, 7, 7, 255]]);
        assert_eq!(pixels(&encoded(ColorType::Grayscale, BitDepth::One, 2, &[0x40])), [[0, 0, 0, 255], [255; 4]]);
        assert_eq!(pixels(&encoded(ColorType::GrayscaleAlpha, BitDepth::Eight, 1, &[7, 9])), [[7, 7, 7, 9]]);
        let wide = [0x12, 0x34, 0x56, 0x78, 0x9a, 0xbc];
        assert_eq!(pixels(&encoded(ColorType::Rgb, BitDepth::Sixteen, 1, &wide)), [[0x12, 0x56, 0x9a, 255]]);
        let palette = encoded(ColorType::Indexed, BitDepth::Eight, 2, &[1, 0]);
        assert!(header(&palette).is_ok_and(|header| header.has_alpha));
        assert_eq!(pixels(&palette), [[40, 50, 60, 128], [10, 20, 30, 255]]);
    }

    /// A JPEG file of 8 by 8 pixels of middle grey: each table has one code, and both codes of the only block are a 0.
    fn grey_jpeg() -> Vec<u8> {
        let table = |class: u8| [&[0xff, 0xc4, 0, 20, class, 1][..], &[0; 15], &[0]].concat();
        [
            &[0xff, 0xd8, 0xff, 0xdb, 0, 67, 0][..],
            &[1; 64],
            &[0xff, 0xc0, 0, 11, 8, 0, 8, 0, 8, 1, 1, 0x11, 0],
            &table(0x00),
            &table(0x10),
            &[0xff, 0xda, 0, 8, 1, 1, 0, 0, 63, 0, 0x3f, 0xff, 0xd9],
        ]
        .concat()
    }

    #[test]
    fn a_jpeg_is_opaque() {
        let bytes = grey_jpeg();
        assert_eq!(header(&bytes).map(|head| (head.width, head.height, head.has_alpha)), Ok((8, 8, false)));
        assert_eq!(pixels(&bytes), [[128, 128, 128, 255]; 64]);
        let head = header(&bytes).expect("a header");
        for end in 0..bytes.len() {
            // A file with truncated data may still be decoded in part.
            let _ = decode(&head, &bytes[..end]);
        }
    }

    /// A decoder that has taken memory decodes such files: pixels without data are grey.
    #[test]
    fn a_small_jpeg_of_a_large_image_is_not_decoded() {
        let mut bytes = grey_jpeg();
        let frame = bytes.windows(2).position(|pair| pair == [0xff, 0xc0]).expect("a frame");
        bytes[frame + 5..frame + 9].copy_from_slice(&[0x16, 0xa0, 0x16, 0xa0]);
        let why = header(&bytes).expect_err("5792 x 5792 pixels in 141 bytes").to_string();
        assert_eq!(why, "its 141 bytes cannot hold an image of 5792 x 5792 pixels");
        // Arithmetic codes hold as many; the decoder refuses them.
        bytes[frame + 1] = 0xc9;
        assert!(header(&bytes).is_ok_and(|head| decode(&head, &bytes).is_err()));
    }

    /// A progressive file of one block of middle grey with that many scans.
    fn progressive(scans: usize) -> Vec<u8> {
        let mut bytes = grey_jpeg();
        let frame = bytes.windows(2).position(|pair| pair == [0xff, 0xc0]).expect("a frame");
        bytes[frame + 1] = 0xc2;
        let first = bytes.windows(2).position(|pair| pair == [0xff, 0xda]).expect("a scan");
        bytes.truncate(first);
        for scan in 0..scans {
            let [low, high] = if scan == 0 { [0, 0] } else { [1, 63] };
            bytes.extend([0xff, 0xda, 0, 8, 1, 1, 0, low, high, 0, 0x3f]);
        }
        bytes.extend([0xff, 0xd9]);
        bytes
    }

    #[test]
    fn large_images_have_fewer_scans() {
        for (scans, is_read) in [(1, true), (24, true), (90, true), (110, false)] {
            let bytes = progressive(scans);
            assert_eq!(decode(&header(&bytes).expect("a header"), &bytes).is_ok(), is_read, "{scans}");
        }
        let of = |side| most_scans(&ImageHeader { kind: ImageKind::Jpeg, width: side, height: side, has_alpha: false });
        assert_eq!([1, 2048, 4096, 5792].map(of), [100, 100, 48, 24]);
    }

    const PNG: &[u8] = b"\x89PNG\r\n\x1a\n";

    /// A chunk of a PNG file, with its checksum.
    fn chunk(name: &[u8; 4], data: &[u8]) -> Vec<u8> {
        let remainder = |byte: &u8, of: u32| {
            (0..8).fold(of ^ u32::from(*byte), |of, _| if of & 1 == 1 { of >> 1 ^ 0xedb8_8320 } else { of >> 1 })
        };
        let checksum = !name.iter().chain(data).fold(!0, |of, byte| remainder(byte, of));
        [&(data.len() as u32).to_be_bytes()[..], name, data, &checksum.to_be_bytes()].concat()
    }

    /// A stream of deflate that is not compressed.
    fn stored(data: &[u8]) -> Vec<u8> {
        let length = data.len() as u16;
        let sums = data.iter().fold([1, 0], |[a, b]: [u32; 2], byte| {
            let a = (a + u32::from(*byte)) % 65521;
            [a, (a + b) % 65521]
        });
        let ends = [length.to_le_bytes(), (!length).to_le_bytes()].concat();
        [&[0x78, 1, 1][..], &ends, data, &(sums[1] << 16 | sums[0]).to_be_bytes()].concat()
    }

    /// A grey image of 3 x 3 pixels with their numbers.
    fn numbered(is_interlaced: bool) -> Vec<[Vec<u8>; 2]> {
        let size = [0, 0, 0, 3];
        let header = [&size[..], &size, &[8, 0, 0, 0, u8::from(is_interlaced)]].concat();
        let rows: &[&[u8]] = match is_interlaced {
            // The passes begin at the pixels 0, 2, 6, 1 and 3; two of the seven are empty.
            true => &[&[0, 0], &[0, 2], &[0, 6, 8], &[0, 1], &[0, 7], &[0, 3, 4, 5]],
            false => &[&[0, 0, 1, 2], &[0, 3, 4, 5], &[0, 6, 7, 8]],
        };
        [(b"IHDR", header), (b"IDAT", stored(&rows.concat())), (b"IEND", Vec::new())]
            .map(|(name, data)| [name.to_vec(), data])
            .to_vec()
    }

    fn file(chunks: &[[Vec<u8>; 2]]) -> Vec<u8> {
        let all = chunks.iter().flat_map(|[name, data]| chunk(name.as_slice().try_into().expect("four bytes"), data));
        PNG.iter().copied().chain(all).collect()
    }

    /// The same image as the first frame of an animation of two frames; the second one has one pixel.
    fn animated() -> Vec<[Vec<u8>; 2]> {
        let control = |number: u8, side: u8| {
            [&[0, 0, 0, number, 0, 0, 0, side, 0, 0, 0, side][..], &[0; 8], &[0, 1, 0, 1, 0, 0]].concat()
        };
        let mut chunks = numbered(false);
        let second = [&[0, 0, 0, 2][..], &stored(&[0, 9])].concat();
        let end = chunks.len() - 1;
        chunks.splice(end..end, [[b"fcTL".to_vec(), control(1, 1)], [b"fdAT".to_vec(), second]]);
        let before = [[b"acTL".to_vec(), vec![0, 0, 0, 2, 0, 0, 0, 0]], [b"fcTL".to_vec(), control(0, 3)]];
        chunks.splice(1..1, before);
        chunks
    }

    #[test]
    fn interlaced_and_animated_images_are_read() {
        let grey: Vec<[u8; 4]> = (0..9).map(|number| [number, number, number, 255]).collect();
        for chunks in [numbered(false), numbered(true), animated()] {
            assert_eq!(pixels(&file(&chunks)), grey);
        }
    }

    /// Checksums are right, so that each decoder sees the changed byte.
    #[test]
    fn changed_bytes_of_png_files_never_panic() {
        for chunks in [numbered(true), animated()] {
            for (number, at) in
                (0..chunks.len()).flat_map(|number| (0..chunks[number][1].len()).map(move |at| (number, at)))
            {
                for change in [1, 2, 4, 0x10, 0x80, 0xff] {
                    let mut chunks = chunks.clone();
                    chunks[number][1][at] ^= change;
                    let bytes = file(&chunks);
                    if let Ok(image) = header(&bytes).and_then(|head| decode(&head, &bytes)) {
                        assert!(image.rgba.len() <= 4 * 1032 * 8 * bytes.len(), "chunk {number}, byte {at}");
                    }
                }
                let mut chunks = chunks.clone();
                chunks[number][1].truncate(at);
                let bytes = file(&chunks);
                let _ = header(&bytes).and_then(|head| decode(&head, &bytes));
            }
        }
    }

    /// They would take memory in proportion to their content, up to half a gigabyte.
    #[test]
    fn colour_profiles_and_texts_are_not_decoded() {
        let mut chunks = numbered(false);
        let content = stored(&[7; 4000]);
        let more = [
            [b"iCCP".to_vec(), [&b"profile\0\0"[..], &content].concat()],
            [b"tEXt".to_vec(), [&b"Title\0"[..], &[b'x'; 4000]].concat()],
            [b"zTXt".to_vec(), [&b"Comment\0\0"[..], &content].concat()],
            [b"iTXt".to_vec(), [&b"Author\0\x01\0\0\0"[..], &content].concat()],
        ];
        chunks.splice(1..1, more);
        let bytes = file(&chunks);
        let reader = png_decoder(&bytes).read_info().expect("an image");
        let info = reader.info();
        assert!(info.icc_profile.is_none() && info.uncompressed_latin1_text.is_empty());
        assert!(info.compressed_latin1_text.is_empty() && info.utf8_text.is_empty());
        assert_eq!(pixels(&bytes), pixels(&file(&numbered(false))));
    }

    #[test]
    fn a_broken_image_is_refused() {
        let mut bytes = encoded(png::ColorType::Rgb, png::BitDepth::Eight, 1, &[1, 2, 3]);
        let head = header(&bytes).expect("a header");
        assert!(decode(&head, &bytes[..40]).is_err());
        let data = bytes.windows(4).position(|name| name == b"IDAT").expect("data");
        bytes[data + 4] ^= 0xff;
        assert!(decode(&head, &bytes).is_err());
        let jpeg =
            [0xff, 0xd8, 0xff, 0xe0, 0, 4, 1, 2, 0xff, 0xc2, 0, 11, 8, 0, 0x7f, 0, 0x7f, 1, 1, 0x11, 0, 0xff, 0xd9];
        assert!(header(&jpeg).is_ok_and(|head| decode(&head, &jpeg).is_err()));
    }
}
