//! The binary part of a file: views whose bytes are written once, in place, when all lengths are known.

use std::fmt;

use crate::sink::error::WriteError;

/// Views of bytes and accessors into them.
#[derive(Default)]
pub(super) struct Binary<'a> {
    pub(super) length: usize,
    pub(super) views: Vec<String>,
    pub(super) accessors: Vec<String>,
    bytes: Vec<View<'a>>,
}

/// Fills the bytes of a view.
type Write<'a> = Box<dyn Fn(&mut [u8]) + 'a>;

/// The place of a view, and what writes its bytes.
struct View<'a> {
    start: usize,
    length: usize,
    write: Write<'a>,
}

impl fmt::Debug for Binary<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Binary").field("length", &self.length).field("views", &self.views).finish_non_exhaustive()
    }
}

impl<'a> Binary<'a> {
    /// Continues on an 8-byte boundary.
    pub(super) fn align(&mut self) {
        self.length = self.length.next_multiple_of(8);
    }

    /// Appends a view of that many bytes, on an 8-byte boundary; gives its number. `write` fills it later.
    pub(super) fn view(&mut self, length: usize, more: &str, write: impl Fn(&mut [u8]) + 'a) -> usize {
        self.align();
        let start = self.length;
        self.length += length;
        let offset = if start == 0 { String::new() } else { format!(",\"byteOffset\":{start}") };
        self.views.push(format!("{{\"buffer\":0{offset},\"byteLength\":{length}{more}}}"));
        self.bytes.push(View { start, length, write: Box::new(write) });
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

/// Writes words one after the other; gives the rest of the bytes.
pub(super) fn put(to: &mut [u8], words: impl Iterator<Item = [u8; 4]>) -> &mut [u8] {
    let mut count = 0;
    for (to, word) in to.as_chunks_mut::<4>().0.iter_mut().zip(words) {
        *to = word;
        count += 4;
    }
    &mut to[count..]
}

/// Header and chunks. The description is padded so that the binary part starts on an 8-byte boundary of the file.
pub(super) fn container(json: &str, binary: &Binary<'_>) -> Result<Vec<u8>, WriteError> {
    let json_length = (json.len() + 4).next_multiple_of(8) - 4;
    let binary_chunk = if binary.length == 0 { 0 } else { 8 + binary.length };
    let total = 20 + json_length + binary_chunk;
    let Ok(word) = u32::try_from(total) else {
        return Err(WriteError::TooLarge { what: "bytes", limit: u64::from(u32::MAX) });
    };
    let mut file = vec![0; total];
    let (head, rest) = file.split_at_mut(20);
    head[..4].copy_from_slice(b"glTF");
    for (to, word) in head[4..].chunks_exact_mut(4).zip([2, word, json_length as u32]) {
        to.copy_from_slice(&word.to_le_bytes());
    }
    head[16..].copy_from_slice(b"JSON");
    let (text, rest) = rest.split_at_mut(json_length);
    text.fill(b' ');
    text[..json.len()].copy_from_slice(json.as_bytes());
    if binary.length != 0 {
        let (head, bytes) = rest.split_at_mut(8);
        head[..4].copy_from_slice(&(binary.length as u32).to_le_bytes());
        head[4..].copy_from_slice(b"BIN\0");
        for view in &binary.bytes {
            (view.write)(&mut bytes[view.start..view.start + view.length]);
        }
    }
    Ok(file)
}
