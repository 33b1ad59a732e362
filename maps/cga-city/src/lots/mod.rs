//! Footprints on the disk, sorted along the curve of cells, then by id and digest: memory does not grow with the city.

mod near;
mod sorter;

use std::fs::File;
use std::io::{self, Read as _, Seek as _, SeekFrom};
use std::ops::Range;
use std::sync::{Mutex, PoisonError};

use cga_geo::footprint::Footprint;

pub(crate) use self::near::MOST_NEAR;
use self::near::{Large, Near};
pub use self::sorter::Sorter;

/// The bytes of an entry of the index: key, digest, place in the file of footprints.
const ENTRY: u64 = 8 + 32 + 8;

/// Sorted footprints. They can be read by several threads.
#[derive(Debug)]
pub struct Lots {
    index: Mutex<File>,
    footprints: Mutex<File>,
    count: u64,
    large: Large,
}

/// An entry of the index.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Entry {
    /// The place of the centroid along the curve; see [`key`](crate::cell::key).
    pub key: u64,
    /// The digest of the footprint.
    pub digest: [u8; 32],
    /// The first byte of the footprint.
    offset: u64,
}

impl Lots {
    /// The number of footprints.
    pub fn len(&self) -> u64 {
        self.count
    }

    /// True without footprints.
    pub fn is_empty(&self) -> bool {
        self.count == 0
    }

    /// The entries of a range.
    ///
    /// # Errors
    /// Errors of the file system.
    pub fn entries(&self, range: Range<u64>) -> io::Result<Vec<Entry>> {
        let bytes = read(&self.index, range.start * ENTRY..range.end * ENTRY)?;
        let (entries, _) = bytes.as_chunks::<{ ENTRY as usize }>();
        Ok(entries.iter().map(Entry::of).collect())
    }

    /// The number of footprints with smaller keys, among those in a range; the result is in the range.
    ///
    /// # Errors
    /// Errors of the file system.
    pub fn before(&self, key: u64, range: Range<u64>) -> io::Result<u64> {
        let (mut low, mut high) = (range.start, range.end);
        while low < high {
            let middle = low + (high - low) / 2;
            if self.key(middle)? < key { low = middle + 1 } else { high = middle }
        }
        Ok(low)
    }

    /// The key of a footprint.
    ///
    /// # Errors
    /// Errors of the file system, and a number beyond the end.
    pub fn key(&self, number: u64) -> io::Result<u64> {
        let entries = self.entries(number..number + 1)?;
        entries.first().map(|entry| entry.key).ok_or_else(|| io::ErrorKind::UnexpectedEof.into())
    }

    /// The footprints of a range, by id, then by digest.
    ///
    /// # Errors
    /// Errors of the file system.
    pub fn footprints(&self, range: Range<u64>) -> io::Result<Vec<Footprint>> {
        let mut footprints = self.with_digests(range)?;
        footprints.sort_by(|(a_digest, a), (b_digest, b)| a.id.cmp(&b.id).then(a_digest.cmp(b_digest)));
        Ok(footprints.into_iter().map(|(_, footprint)| footprint).collect())
    }

    /// The footprints of a range with their digests, by number.
    fn with_digests(&self, range: Range<u64>) -> io::Result<Vec<Near>> {
        let entries = self.entries(range.start..range.end + 1)?;
        let (Some(first), Some(last)) = (entries.first(), entries.last()) else { return Ok(Vec::new()) };
        let bytes = read(&self.footprints, first.offset..last.offset)?;
        let footprint = |pair: &[Entry]| {
            let part = (pair[0].offset - first.offset) as usize..(pair[1].offset - first.offset) as usize;
            let footprint = bytes.get(part).ok_or(io::ErrorKind::UnexpectedEof)?;
            let footprint =
                Footprint::from_bytes(footprint).map_err(|why| io::Error::new(io::ErrorKind::InvalidData, why))?;
            Ok((pair[0].digest, footprint))
        };
        entries.windows(2).map(footprint).collect()
    }
}

impl Entry {
    fn of(bytes: &[u8; ENTRY as usize]) -> Self {
        let number = |at: usize| u64::from_le_bytes(std::array::from_fn(|byte| bytes[at + byte]));
        Entry { key: number(0), digest: std::array::from_fn(|byte| bytes[8 + byte]), offset: number(40) }
    }

    fn write(&self, out: &mut impl io::Write) -> io::Result<()> {
        out.write_all(&self.key.to_le_bytes())?;
        out.write_all(&self.digest)?;
        out.write_all(&self.offset.to_le_bytes())
    }
}

fn read(file: &Mutex<File>, range: Range<u64>) -> io::Result<Vec<u8>> {
    let mut bytes = vec![0; (range.end - range.start) as usize];
    let mut file = file.lock().unwrap_or_else(PoisonError::into_inner);
    file.seek(SeekFrom::Start(range.start))?;
    file.read_exact(&mut bytes)?;
    Ok(bytes)
}
