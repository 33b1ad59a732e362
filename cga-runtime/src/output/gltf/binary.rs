//! The binary part of a file: views whose bytes are written once, after all lengths are known.
//!
//! Everything in a file begins at a multiple of four bytes. A file is a list of words until it is complete, so that
//! lists of numbers are copied at the speed of memory.

use crate::output::error::WriteError;
use crate::value::each::Each;

/// Views of bytes and accessors into them.
#[derive(Default)]
pub(super) struct BinaryChunk<'a> {
    pub(super) length: usize,
    pub(super) views: Vec<String>,
    pub(super) accessors: Vec<String>,
    bytes: Vec<BufferView<'a>>,
}

/// Four bytes.
pub(super) type FourBytes = [u8; 4];

/// Appends the words of a view.
type Write<'a> = Box<dyn Fn(&mut Vec<FourBytes>) + 'a>;

/// The place of a view, and the function that writes its bytes.
struct BufferView<'a> {
    start: usize,
    write: Write<'a>,
}

impl<'a> BinaryChunk<'a> {
    /// Continues on an 8-byte boundary.
    pub(super) fn align(&mut self) {
        self.length = self.length.next_multiple_of(8);
    }

    /// Appends a view of `length` bytes, on an 8-byte boundary. Returns its number. `write` writes the bytes later.
    pub(super) fn view(&mut self, length: usize, more: &str, write: impl Fn(&mut Vec<FourBytes>) + 'a) -> usize {
        self.add_view(length, more, Box::new(write))
    }

    fn add_view(&mut self, length: usize, more: &str, write: Write<'a>) -> usize {
        self.align();
        let start = self.length;
        self.length += length;
        let offset = if start == 0 { String::new() } else { format!(",\"byteOffset\":{start}") };
        self.views.push(format!("{{\"buffer\":0{offset},\"byteLength\":{length}{more}}}"));
        self.bytes.push(BufferView { start, write });
        self.views.len() - 1
    }

    pub(super) fn accessor(
        &mut self,
        view: usize,
        offset: usize,
        component: u32,
        count: usize,
        kind: &str,
        more: &str,
    ) -> usize {
        let offset = if offset == 0 { String::new() } else { format!(",\"byteOffset\":{offset}") };
        self.accessors.push(format!(
            "{{\"bufferView\":{view}{offset},\"componentType\":{component},\"count\":{count},\"type\":\"{kind}\"{more}}}"
        ));
        self.accessors.len() - 1
    }
}

/// Appends bytes, and zeros or spaces up to the next word.
pub(super) fn text(to: &mut Vec<FourBytes>, bytes: &[u8], padding: u8) {
    let (words, rest) = bytes.as_chunks::<4>();
    to.extend_from_slice(words);
    if !rest.is_empty() {
        let mut word = [padding; 4];
        word[..rest.len()].copy_from_slice(rest);
        to.push(word);
    }
}

/// The header and the chunks. The description is padded so that the binary part starts on an 8-byte boundary of the
/// file.
pub(super) fn container(json: &str, binary: &BinaryChunk<'_>) -> Result<Vec<u8>, WriteError> {
    let json_length = (json.len() + 4).next_multiple_of(8) - 4;
    let binary_chunk = if binary.length == 0 { 0 } else { 8 + binary.length };
    let total = 20 + json_length + binary_chunk;
    let Ok(length) = u32::try_from(total) else {
        return Err(WriteError::TooLarge { what: "bytes", limit: u64::from(u32::MAX) });
    };
    let mut file: Vec<FourBytes> = Vec::with_capacity(total / 4);
    file.push(*b"glTF");
    file.extend([2, length, json_length as u32].each(u32::to_le_bytes));
    file.push(*b"JSON");
    text(&mut file, json.as_bytes(), b' ');
    file.resize((20 + json_length) / 4, [b' '; 4]);
    if binary.length != 0 {
        file.extend([(binary.length as u32).to_le_bytes(), *b"BIN\0"]);
        let start = file.len();
        for view in &binary.bytes {
            file.resize(start + view.start / 4, [0; 4]);
            (view.write)(&mut file);
        }
        file.resize(start + binary.length / 4, [0; 4]);
    }
    Ok(file.into_flattened())
}
