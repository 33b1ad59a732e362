//! Headers of image files: size, alpha channel, completeness.

use super::capacity::{jpeg_may_hold, png_may_hold};
use crate::asset::AssetError;

/// The kind of an image file.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum ImageKind {
    Png,
    Jpeg,
}

/// The properties of an image that are known without decoding its pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct ImageHeader {
    pub(crate) kind: ImageKind,
    /// The width in pixels.
    pub(crate) width: u32,
    /// The height in pixels.
    pub(crate) height: u32,
    pub(crate) has_alpha: bool,
}

/// The number of bytes that are read to find the size. Pictures from cameras have previews before it.
pub(crate) const LOOKED_AT: u64 = 1 << 20;

/// The largest image file that is read, in bytes.
pub(crate) const MOST_BYTES: u64 = 1 << 28;

/// The largest number of pixels of an image that is decoded, so that a small file cannot require much memory.
pub(crate) const MOST_PIXELS: u64 = 1 << 25;

const PNG: &[u8] = b"\x89PNG\r\n\x1a\n";

/// Width and height in pixels of a PNG or JPEG file, from its first bytes.
pub(crate) fn size(bytes: &[u8]) -> Option<(u32, u32)> {
    kind(bytes)?;
    let size = imagesize::blob_size(bytes).ok().filter(|size| size.width != 0 && size.height != 0)?;
    Some((u32::try_from(size.width).ok()?, u32::try_from(size.height).ok()?))
}

fn kind(bytes: &[u8]) -> Option<ImageKind> {
    match bytes {
        _ if bytes.starts_with(PNG) => Some(ImageKind::Png),
        _ if bytes.starts_with(b"\xff\xd8\xff") => Some(ImageKind::Jpeg),
        _ => None,
    }
}

/// The header of a complete PNG or JPEG file.
///
/// # Errors
/// The file has another format, has no size, ends early, or has more pixels than are decoded or than its bytes can hold.
pub(crate) fn header(bytes: &[u8]) -> Result<ImageHeader, AssetError> {
    let kind = kind(bytes).ok_or(AssetError::Format("only PNG and JPEG images can be read"))?;
    let (width, height) = size(bytes).ok_or_else(|| AssetError::Broken("the image has no size".to_owned()))?;
    let (has_alpha, is_complete) = match kind {
        ImageKind::Png => png(bytes),
        // The end of the image may be followed by padding or by other data.
        ImageKind::Jpeg => (false, bytes.windows(2).skip(2).any(|pair| pair == b"\xff\xd9")),
    };
    if !is_complete {
        return Err(AssetError::Broken("the image ends early".to_owned()));
    }
    let pixels = u64::from(width) * u64::from(height);
    if MOST_PIXELS < pixels {
        return Err(AssetError::Broken(format!("the image has more than {MOST_PIXELS} pixels")));
    }
    let may_hold = match kind {
        ImageKind::Png => png_may_hold(bytes, pixels),
        ImageKind::Jpeg => jpeg_may_hold(bytes, pixels),
    };
    if !may_hold {
        let length = bytes.len();
        return Err(AssetError::Broken(format!(
            "its {length} bytes cannot hold an image of {width} x {height} pixels"
        )));
    }
    Ok(ImageHeader { kind, width, height, has_alpha })
}

/// Visits the chunks of a PNG file. Returns whether it has an alpha channel or transparent colours, and whether it is
/// complete.
fn png(bytes: &[u8]) -> (bool, bool) {
    let mut has_alpha = false;
    let mut rest = bytes.strip_prefix(PNG).unwrap_or_default();
    while let Some((length, after)) = rest.split_first_chunk::<4>() {
        let length = u32::from_be_bytes(*length) as usize;
        let Some(chunk) = length.checked_add(4).and_then(|end| after.get(..end)) else { break };
        match &chunk[..4] {
            // Colour types 4 and 6.
            b"IHDR" => has_alpha |= chunk.get(13).is_some_and(|kind| kind & 4 != 0),
            b"tRNS" => has_alpha = true,
            b"IEND" => return (has_alpha, true),
            _ => {}
        }
        let Some(next) = after.get(length + 8..) else { break };
        rest = next;
    }
    (has_alpha, false)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn chunk(name: &[u8], data: &[u8]) -> Vec<u8> {
        [&(data.len() as u32).to_be_bytes(), name, data, &[0; 4]].concat()
    }

    fn png(kind: u8, more: &[u8]) -> Vec<u8> {
        let head = chunk(b"IHDR", &[0, 0, 2, 0, 0, 0, 0, 3, 8, kind, 0, 0, 0]);
        [PNG, &head, more, &chunk(b"IEND", &[])].concat()
    }

    #[test]
    fn headers_are_read_or_refused() {
        let read = |bytes: &[u8]| header(bytes).map(|head| (head.width, head.height, head.has_alpha));
        for (kind, has_alpha) in [(0, false), (2, false), (3, false), (4, true), (6, true)] {
            assert_eq!(read(&png(kind, &[])), Ok((512, 3, has_alpha)), "{kind}");
        }
        assert_eq!(read(&png(3, &chunk(b"tRNS", &[0, 255]))), Ok((512, 3, true)));
        let whole = png(6, &chunk(b"IDAT", &[1, 2, 3]));
        for end in 0..whole.len() - 4 {
            assert!(read(&whole[..end]).is_err(), "{end}");
        }
        let jpeg = [0xff, 0xd8, 0xff, 0xe0, 0, 4, 1, 2, 0xff, 0xc2, 0, 11, 8, 0, 3, 2, 0, 3, 0, 0, 0xff, 0xd9];
        assert_eq!(read(&jpeg), Ok((512, 3, false)));
        for end in 0..jpeg.len() {
            assert!(read(&jpeg[..end]).is_err(), "{end}");
        }
        assert_eq!(read(b"GIF89a"), Err(AssetError::Format("only PNG and JPEG images can be read")));
        // A length beyond the end, and a length of 0 that makes no progress.
        assert!(read(&[PNG, &[0xff; 40]].concat()).is_err());
        assert!(read(&[0xff, 0xd8, 0xff, 0xe0, 0, 0, 0xff, 0xda, 0, 0]).is_err());
    }

    #[test]
    fn an_image_with_too_many_pixels_is_refused_by_its_header() {
        let head = chunk(b"IHDR", &[0, 1, 0, 0, 0, 1, 0, 0, 8, 6, 0, 0, 0]);
        let bytes = [PNG, &head, &chunk(b"IEND", &[])].concat();
        assert_eq!(size(&bytes), Some((1 << 16, 1 << 16)));
        assert!(header(&bytes).is_err_and(|why| why.to_string() == "the image has more than 33554432 pixels"));
    }

    #[test]
    fn an_image_that_its_bytes_cannot_hold_is_refused() {
        let head = chunk(b"IHDR", &[0, 0, 16, 0, 0, 0, 16, 0, 8, 2, 0, 0, 0]);
        let png = [PNG, &head, &chunk(b"IDAT", &[0; 40_000]), &chunk(b"IEND", &[])].concat();
        let why = header(&png).expect_err("a bomb").to_string();
        assert_eq!(why, "its 40057 bytes cannot hold an image of 4096 x 4096 pixels");
        let png = [PNG, &head, &chunk(b"IDAT", &[0; 50_000]), &chunk(b"IEND", &[])].concat();
        assert!(header(&png).is_ok(), "48,771 bytes of deflate hold it");
        let jpeg = [0xff, 0xd8, 0xff, 0xc0, 0, 11, 8, 0x16, 0xa0, 0x16, 0xa0, 1, 1, 0x11, 0, 0xff, 0xd9];
        let why = header(&jpeg).expect_err("a bomb").to_string();
        assert_eq!(why, "its 17 bytes cannot hold an image of 5792 x 5792 pixels");
    }
}
