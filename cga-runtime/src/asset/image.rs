//! The size of an image, from the beginning of its file.

/// How many bytes of a file are looked at: pictures from cameras have previews in front of what counts.
pub(crate) const LOOKED_AT: u64 = 1 << 20;

/// Width and height in pixels of a PNG or JPEG file, from its first bytes.
pub(crate) fn size(bytes: &[u8]) -> Option<(u32, u32)> {
    let (width, height) = png(bytes).or_else(|| jpeg(bytes))?;
    (width != 0 && height != 0).then_some((width, height))
}

/// Signature, then the chunk IHDR, which begins with the size.
fn png(bytes: &[u8]) -> Option<(u32, u32)> {
    let rest = bytes.strip_prefix(b"\x89PNG\r\n\x1a\n")?;
    if rest.get(4..8)? != b"IHDR" {
        return None;
    }
    let word = |at: usize| Some(u32::from_be_bytes(rest.get(at..at + 4)?.try_into().ok()?));
    Some((word(8)?, word(12)?))
}

/// Segments until the first frame header, which has the size behind its length and precision.
fn jpeg(bytes: &[u8]) -> Option<(u32, u32)> {
    let mut rest = bytes.strip_prefix(b"\xff\xd8")?;
    let half = |bytes: &[u8], at: usize| Some(u16::from_be_bytes(bytes.get(at..at + 2)?.try_into().ok()?));
    loop {
        let (&[0xff, marker], segment) = rest.split_first_chunk::<2>()? else { return None };
        match marker {
            // Filling.
            0xff => rest = &rest[1..],
            // Without a length.
            0x01 | 0xd0..=0xd7 => rest = segment,
            // All frame headers; the three others in their range are tables.
            0xc0..=0xcf if !matches!(marker, 0xc4 | 0xc8 | 0xcc) => {
                return Some((half(segment, 5)?.into(), half(segment, 3)?.into()));
            }
            _ => rest = segment.get(usize::from(half(segment, 0)?).max(2)..)?,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes_are_read_or_refused() {
        let png = [b"\x89PNG\r\n\x1a\n\0\0\0\x0dIHDR".as_slice(), &[0, 0, 2, 0, 0, 0, 1, 44, 8, 6]].concat();
        assert_eq!(size(&png), Some((512, 300)));
        let jpeg = [0xff, 0xd8, 0xff, 0xe0, 0, 4, 1, 2, 0xff, 0xff, 0xc2, 0, 11, 8, 1, 44, 2, 0, 3];
        assert_eq!(size(&jpeg), Some((512, 300)));
        for end in 0..png.len().min(24) {
            assert_eq!(size(&png[..end]), None);
        }
        for end in 0..jpeg.len() - 1 {
            assert_eq!(size(&jpeg[..end]), None);
        }
        assert_eq!(size(b"GIF89a"), None);
        // A length of 0 does not hold it up.
        assert_eq!(size(&[0xff, 0xd8, 0xff, 0xe0, 0, 0, 0xff, 0xda, 0, 0]), None);
    }
}
