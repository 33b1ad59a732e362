//! The container: a header, the description, the binary part.

use std::io::{self, Write};
use std::path::Path;

use super::binary::BinaryChunk;
use super::words::Words;
use crate::geometry::each::Each;
use crate::output::error::WriteError;
use crate::output::whole_file;

/// A file of known length, whose parts are not in one place yet.
pub(super) struct Container<'a> {
    json: String,
    binary: BinaryChunk<'a>,
    /// The length of the description: it is padded so that the binary part begins on an 8-byte boundary of the file.
    json_length: u32,
    length: u32,
}

impl<'a> Container<'a> {
    pub(super) fn new(json: String, binary: BinaryChunk<'a>) -> Result<Self, WriteError> {
        let json_length = (json.len() + 4).next_multiple_of(8) - 4;
        let binary_chunk = if binary.length == 0 { 0 } else { 8 + binary.length };
        match u32::try_from(20 + json_length + binary_chunk) {
            Ok(length) => Ok(Container { json, binary, json_length: json_length as u32, length }),
            Err(_) => Err(WriteError::TooLarge { what: "bytes", limit: u64::from(u32::MAX) }),
        }
    }

    /// The bytes of the file.
    pub(super) fn into_bytes(self) -> Result<Vec<u8>, WriteError> {
        let mut bytes = Vec::with_capacity(self.length as usize);
        self.write(&mut bytes)?;
        Ok(bytes)
    }

    /// Writes the file with its name.
    pub(super) fn write_file(&self, path: &Path) -> Result<(), WriteError> {
        whole_file::write_with(path, |out| Ok(self.write(out)?))
    }

    /// Writes the file in blocks.
    pub(super) fn write(&self, out: &mut dyn Write) -> io::Result<()> {
        let mut words = Words::new(out);
        let [version, length, json_length] = [2, self.length, self.json_length].each(u32::to_le_bytes);
        words.each(&[*b"glTF", version, length, json_length, *b"JSON"], |word| [*word])?;
        words.bytes(self.json.as_bytes(), b' ')?;
        words.pad((20 + self.json_length as usize) / 4, b' ')?;
        if self.binary.length != 0 {
            words.each(&[(self.binary.length as u32).to_le_bytes(), *b"BIN\0"], |word| [*word])?;
            self.binary.write(&mut words)?;
        }
        words.finish()
    }
}
