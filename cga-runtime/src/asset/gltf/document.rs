//! A file with its binary data.

use std::borrow::Cow;
use std::collections::HashMap;

use base64::Engine as _;
use base64::alphabet;
use base64::engine::DecodePaddingMode;
use base64::engine::general_purpose::{GeneralPurpose, GeneralPurposeConfig};
use serde_json::Value;

use super::GltfError;
use super::container::{self, FileParts};
use super::item::{Item, item, items};

/// The JSON text of a file, and the data of its buffers.
pub(super) struct Document<'a> {
    pub(super) json: Value,
    blobs: Vec<Cow<'a, [u8]>>,
    /// The number of each buffer's data in `blobs`, if its data exist.
    buffers: Vec<Option<usize>>,
}

/// A range of bytes of a buffer.
#[derive(Clone, Copy)]
pub(super) struct BufferView<'a> {
    pub(super) bytes: &'a [u8],
    /// The distance of two elements, if it is given.
    pub(super) stride: Option<usize>,
}

impl<'a> Document<'a> {
    /// Reads the text and the buffers. `file` returns the bytes of a file by its name.
    pub(super) fn new(
        bytes: &'a [u8],
        file: &mut dyn FnMut(&str) -> Option<Vec<u8>>,
    ) -> Result<Document<'a>, GltfError> {
        let FileParts { json, binary } = container::parts(bytes)?;
        let json: Value = serde_json::from_slice(json).map_err(|error| GltfError::Json(error.to_string()))?;
        let mut document = Document { json: Value::Null, blobs: Vec::new(), buffers: Vec::new() };
        // Buffers with the same address are read once.
        let mut known: HashMap<String, Option<usize>> = HashMap::new();
        for buffer in items(&json, "buffers") {
            let data = match buffer.text("uri")? {
                None if buffer.index == 0 => binary.map(|binary| document.add(Cow::Borrowed(binary))),
                None => None,
                Some(uri) => match known.get(uri) {
                    Some(data) => *data,
                    None => {
                        let bytes = resource(&buffer, uri)?.into_bytes(file);
                        let data = bytes.map(|bytes| document.add(Cow::Owned(bytes)));
                        known.insert(uri.to_owned(), data);
                        data
                    }
                },
            };
            document.buffers.push(data);
        }
        document.json = json;
        Ok(document)
    }

    fn add(&mut self, bytes: Cow<'a, [u8]>) -> usize {
        self.blobs.push(bytes);
        self.blobs.len() - 1
    }

    /// The number of bytes of all buffers.
    pub(super) fn byte_count(&self) -> usize {
        self.blobs.iter().map(|blob| blob.len()).sum()
    }

    /// A view by its index.
    pub(super) fn view(&self, index: usize) -> Result<BufferView<'_>, GltfError> {
        let view = item(&self.json, "bufferViews", index)?;
        let buffer = view.required("buffer")?;
        item(&self.json, "buffers", buffer)?;
        let data = self.buffers.get(buffer).copied().flatten();
        let data = data.ok_or_else(|| GltfError::item("buffers", buffer, "its data cannot be found"))?;
        let start = view.whole("byteOffset")?.unwrap_or(0);
        let end = start.checked_add(view.required("byteLength")?);
        let bytes = end.and_then(|end| self.blobs[data].get(start..end));
        let bytes = bytes.ok_or_else(|| view.error("its buffer ends early"))?;
        Ok(BufferView { bytes, stride: view.whole("byteStride")? })
    }
}

/// The target of an address.
pub(super) enum Resource {
    /// Data inside the address.
    Data(Vec<u8>),
    /// A file, by its name relative to the file that names it.
    File(String),
}

impl Resource {
    fn into_bytes(self, file: &mut dyn FnMut(&str) -> Option<Vec<u8>>) -> Option<Vec<u8>> {
        match self {
            Resource::Data(bytes) => Some(bytes),
            Resource::File(name) => file(&name),
        }
    }
}

/// Base64 as found in files: with and without padding.
const BASE64: GeneralPurpose = GeneralPurpose::new(
    &alphabet::STANDARD,
    GeneralPurposeConfig::new().with_decode_padding_mode(DecodePaddingMode::Indifferent),
);

/// The target of the address of an item.
pub(super) fn resource(of: &Item<'_>, uri: &str) -> Result<Resource, GltfError> {
    let Some(data) = uri.strip_prefix("data:") else {
        return Ok(Resource::File(percent_decoded(uri)));
    };
    let (_, text) = data.split_once(";base64,").ok_or_else(|| of.error("its data are not in base64"))?;
    BASE64.decode(text).map(Resource::Data).map_err(|error| of.error(format!("its data are invalid: {error}")))
}

/// The text with each `%` and two hexadecimal digits replaced by their byte. Any other `%` stays, because some programs
/// write names without escapes.
fn percent_decoded(text: &str) -> String {
    let mut bytes = Vec::with_capacity(text.len());
    let mut rest = text.as_bytes();
    while let Some((&first, after)) = rest.split_first() {
        let digits = after.first_chunk::<2>().filter(|digits| digits.iter().all(u8::is_ascii_hexdigit));
        let code = digits.and_then(|digits| u8::from_str_radix(std::str::from_utf8(digits).ok()?, 16).ok());
        match code.filter(|_| first == b'%') {
            Some(code) => {
                bytes.push(code);
                rest = &after[2..];
            }
            None => {
                bytes.push(first);
                rest = after;
            }
        }
    }
    String::from_utf8_lossy(&bytes).into_owned()
}
