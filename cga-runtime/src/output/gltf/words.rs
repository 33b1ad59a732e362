//! The words of a file, in blocks.
//!
//! Everything in a file begins at a multiple of four bytes. A block is a list of words, so that lists of numbers are copied at the speed of
//! memory.

use std::io::{self, Write};

/// Four bytes.
pub(super) type FourBytes = [u8; 4];

/// The words, or the items of a list, after which a block is written.
const BLOCK: usize = 1 << 13;

/// Collects words and writes them in blocks.
pub(super) struct Words<'w> {
    out: &'w mut dyn Write,
    block: Vec<FourBytes>,
    /// The number of words before the block.
    written: usize,
}

impl<'w> Words<'w> {
    pub(super) fn new(out: &'w mut dyn Write) -> Self {
        Words { out, block: Vec::new(), written: 0 }
    }

    /// The number of words.
    pub(super) fn len(&self) -> usize {
        self.written + self.block.len()
    }

    /// Appends the words of each item.
    pub(super) fn each<T, const N: usize>(
        &mut self,
        items: &[T],
        words: impl Fn(&T) -> [FourBytes; N],
    ) -> io::Result<()> {
        for items in items.chunks(BLOCK) {
            let start = self.block.len();
            self.block.resize(start + N * items.len(), [0; 4]);
            let (places, _) = self.block[start..].as_chunks_mut::<N>();
            for (place, item) in places.iter_mut().zip(items) {
                *place = words(item);
            }
            if BLOCK <= self.block.len() {
                self.hand_over()?;
            }
        }
        Ok(())
    }

    /// Appends a word a number of times.
    pub(super) fn repeat(&mut self, word: FourBytes, count: usize) -> io::Result<()> {
        for start in (0..count).step_by(BLOCK) {
            self.block.resize(self.block.len() + (count - start).min(BLOCK), word);
            if BLOCK <= self.block.len() {
                self.hand_over()?;
            }
        }
        Ok(())
    }

    /// Appends numbers.
    pub(super) fn floats(&mut self, numbers: &[f32]) -> io::Result<()> {
        self.each(numbers, |number| [number.to_le_bytes()])
    }

    /// Appends bytes, and `padding` up to the next word.
    pub(super) fn bytes(&mut self, bytes: &[u8], padding: u8) -> io::Result<()> {
        let (words, rest) = bytes.as_chunks::<4>();
        self.each(words, |word| [*word])?;
        if !rest.is_empty() {
            let mut word = [padding; 4];
            word[..rest.len()].copy_from_slice(rest);
            self.block.push(word);
        }
        Ok(())
    }

    /// Appends a few bytes `padding`, up to a number of words.
    pub(super) fn pad(&mut self, words: usize, padding: u8) {
        self.block.resize(words - self.written, [padding; 4]);
    }

    /// Writes the last block.
    pub(super) fn finish(mut self) -> io::Result<()> {
        self.hand_over()?;
        self.out.flush()
    }

    fn hand_over(&mut self) -> io::Result<()> {
        self.written += self.block.len();
        let written = self.out.write_all(self.block.as_flattened());
        self.block.clear();
        written
    }
}
