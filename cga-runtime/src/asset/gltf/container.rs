//! The two containers: JSON text alone, and GLB, which has binary data behind the text.

use super::GltfError;

/// The parts of a file.
pub(super) struct FileParts<'a> {
    pub(super) json: &'a [u8],
    /// The binary chunk of a GLB file.
    pub(super) binary: Option<&'a [u8]>,
}

const JSON: u32 = u32::from_le_bytes(*b"JSON");
const BINARY: u32 = u32::from_le_bytes(*b"BIN\0");

/// Divides a file. Chunks of unknown kinds are skipped.
pub(super) fn parts(bytes: &[u8]) -> Result<FileParts<'_>, GltfError> {
    let Some(rest) = bytes.strip_prefix(b"glTF") else {
        // Other programs write a byte order mark.
        return Ok(FileParts { json: bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes), binary: None });
    };
    let early = || GltfError::Container("the file ends early");
    let (version, rest) = word(rest).ok_or_else(early)?;
    if version != 2 {
        return Err(GltfError::Container("only version 2 of GLB can be read"));
    }
    let (length, _) = word(rest).ok_or_else(early)?;
    let mut rest = bytes.get(12..length as usize).ok_or_else(early)?;
    let mut parts = FileParts { json: &[], binary: None };
    let mut is_first = true;
    while !rest.is_empty() {
        let (length, after) = word(rest).ok_or_else(early)?;
        let (kind, after) = word(after).ok_or_else(early)?;
        let chunk = after.get(..length as usize).ok_or_else(early)?;
        match kind {
            JSON if is_first => parts.json = chunk,
            BINARY if !is_first && parts.binary.is_none() => parts.binary = Some(chunk),
            _ if is_first => return Err(GltfError::Container("the first chunk of the file is not JSON")),
            _ => {}
        }
        is_first = false;
        rest = &after[length as usize..];
    }
    if is_first {
        return Err(early());
    }
    Ok(parts)
}

/// A little-endian word, and the bytes behind it.
fn word(bytes: &[u8]) -> Option<(u32, &[u8])> {
    let (word, rest) = bytes.split_first_chunk::<4>()?;
    Some((u32::from_le_bytes(*word), rest))
}
