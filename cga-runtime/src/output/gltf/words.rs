//! The words of a file, in blocks.
//!
//! Everything in a file begins at a multiple of four bytes. A block is a list of words, so that lists of numbers are copied at the speed of
//! memory.

use std::io::{self, Write};

use crate::output::packed::Collect;

/// Four bytes.
pub(super) type FourBytes = [u8; 4];

/// The number of words of a block.
const BLOCK: usize = 1 << 13;

/// Collects words and writes them in blocks.
pub(super) struct Words<'w> {
    out: &'w mut dyn Write,
    block: Box<[FourBytes]>,
    /// The number of words in the block.
    used: usize,
    /// The number of words before the block.
    written: usize,
}

impl<'w> Words<'w> {
    pub(super) fn new(out: &'w mut dyn Write) -> Self {
        Words { out, block: vec![[0; 4]; BLOCK].into(), used: 0, written: 0 }
    }

    /// The number of words.
    pub(super) fn len(&self) -> usize {
        self.written + self.used
    }

    /// Room for the next words, at most [`BLOCK`].
    #[inline]
    fn room(&mut self, words: usize) -> io::Result<&mut [FourBytes]> {
        if BLOCK - self.used < words {
            self.hand_over()?;
        }
        let start = self.used;
        self.used += words;
        Ok(&mut self.block[start..start + words])
    }

    /// Appends the words of each item.
    pub(super) fn each<T, const N: usize>(
        &mut self,
        items: &[T],
        words: impl Fn(&T) -> [FourBytes; N],
    ) -> io::Result<()> {
        for items in items.chunks(BLOCK / N) {
            let (places, _) = self.room(N * items.len())?.as_chunks_mut::<N>();
            for (place, item) in places.iter_mut().zip(items) {
                *place = words(item);
            }
        }
        Ok(())
    }

    /// Appends a word a number of times.
    pub(super) fn repeat(&mut self, word: FourBytes, count: usize) -> io::Result<()> {
        for start in (0..count).step_by(BLOCK) {
            self.room((count - start).min(BLOCK))?.fill(word);
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
            self.repeat(word, 1)?;
        }
        Ok(())
    }

    /// Appends bytes `padding`, up to a number of words.
    pub(super) fn pad(&mut self, words: usize, padding: u8) -> io::Result<()> {
        self.repeat([padding; 4], words - self.len())
    }

    /// Writes the last block.
    pub(super) fn finish(mut self) -> io::Result<()> {
        self.hand_over()?;
        self.out.flush()
    }

    #[cold]
    fn hand_over(&mut self) -> io::Result<()> {
        let used = std::mem::take(&mut self.used);
        self.written += used;
        self.out.write_all(self.block[..used].as_flattened())
    }
}

impl Collect<[f32; 3]> for Words<'_> {
    type Error = io::Error;

    #[inline]
    fn add<const N: usize>(&mut self, items: [[f32; 3]; N]) -> io::Result<()> {
        let (places, _) = self.room(3 * N)?.as_chunks_mut::<3>();
        for (place, item) in places.iter_mut().zip(items) {
            *place = item.map(f32::to_le_bytes);
        }
        Ok(())
    }
}

impl Collect<u32> for Words<'_> {
    type Error = io::Error;

    #[inline]
    fn add<const N: usize>(&mut self, items: [u32; N]) -> io::Result<()> {
        self.room(N)?.copy_from_slice(&items.map(u32::to_le_bytes));
        Ok(())
    }
}
