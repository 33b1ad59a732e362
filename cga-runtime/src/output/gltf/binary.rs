//! The binary part of a file: views whose bytes are written once, after all lengths are known.

use super::words::Words;
use std::io;

/// Views of bytes and accessors into them.
#[derive(Default)]
pub(super) struct BinaryChunk<'a> {
    pub(super) length: usize,
    pub(super) views: Vec<String>,
    pub(super) accessors: Vec<String>,
    bytes: Vec<BufferView<'a>>,
}

/// Appends the words of a view.
type Append<'a> = Box<dyn Fn(&mut Words<'_>) -> io::Result<()> + 'a>;

/// The place of a view, and the function that writes its bytes.
struct BufferView<'a> {
    start: usize,
    append: Append<'a>,
}

impl<'a> BinaryChunk<'a> {
    /// Continues on an 8-byte boundary.
    pub(super) fn align(&mut self) {
        self.length = self.length.next_multiple_of(8);
    }

    /// Appends a view of `length` bytes, on an 8-byte boundary. Returns its number. `append` writes the bytes later.
    pub(super) fn view(
        &mut self,
        length: usize,
        more: &str,
        append: impl Fn(&mut Words<'_>) -> io::Result<()> + 'a,
    ) -> usize {
        self.add_view(length, more, Box::new(append))
    }

    fn add_view(&mut self, length: usize, more: &str, append: Append<'a>) -> usize {
        self.align();
        let start = self.length;
        self.length += length;
        let offset = if start == 0 { String::new() } else { format!(",\"byteOffset\":{start}") };
        self.views.push(format!("{{\"buffer\":0{offset},\"byteLength\":{length}{more}}}"));
        self.bytes.push(BufferView { start, append });
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
    /// Writes all views.
    pub(super) fn write(&self, to: &mut Words<'_>) -> io::Result<()> {
        let start = to.len();
        for view in &self.bytes {
            to.pad(start + view.start / 4, 0)?;
            (view.append)(to)?;
        }
        to.pad(start + self.length / 4, 0)
    }
}
