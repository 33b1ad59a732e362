//! Sorts footprints with little memory: sorted runs on the disk, then a merge.

use std::cmp::Reverse;
use std::collections::BinaryHeap;
use std::fs::File;
use std::io::{self, BufReader, BufWriter, ErrorKind, Read, Seek as _, Write};
use std::path::{Path, PathBuf};
use std::sync::Mutex;

use cga_geo::footprint::Footprint;

use super::near::Large;
use super::{Entry, Lots};
use crate::area::Area;
use crate::cell;

/// The bytes of a run in memory.
const RUN_BYTES: usize = 64 << 20;

/// The bytes that an item in memory has beside its footprint.
const ITEM_BYTES: usize = 160;

/// Collects footprints and sorts them.
#[derive(Debug)]
pub struct Sorter {
    folder: PathBuf,
    run: Vec<Item>,
    bytes: usize,
    most_bytes: usize,
    runs: Vec<PathBuf>,
}

/// A footprint with its place in the order.
#[derive(Debug, PartialEq, Eq, PartialOrd, Ord)]
struct Item {
    key: u64,
    id: String,
    digest: [u8; 32],
    footprint: Vec<u8>,
    /// Its size; see [`Area::class`].
    class: u8,
}

impl Sorter {
    /// A sorter with its files in a folder that exists.
    pub fn new(folder: &Path) -> Self {
        Sorter { folder: folder.to_owned(), run: Vec::new(), bytes: 0, most_bytes: RUN_BYTES, runs: Vec::new() }
    }

    /// Sets the bytes of a run in memory, 64 MB by default.
    #[must_use]
    pub fn run_bytes(mut self, bytes: usize) -> Self {
        self.most_bytes = bytes;
        self
    }

    /// Adds a footprint.
    ///
    /// # Errors
    /// Errors of the file system.
    pub fn add(&mut self, footprint: &Footprint) -> io::Result<()> {
        let bytes = footprint.to_bytes();
        let digest = *blake3::hash(&bytes).as_bytes();
        self.bytes += bytes.len() + footprint.id.len() + ITEM_BYTES;
        let (middle, id) = (footprint.middle(), footprint.id.clone());
        let class = Area::of(footprint).class(middle);
        self.run.push(Item { key: cell::key(middle), id, digest, footprint: bytes, class });
        if self.most_bytes <= self.bytes {
            self.end_run()?;
        }
        Ok(())
    }

    /// Writes the run to the disk.
    fn end_run(&mut self) -> io::Result<()> {
        self.run.sort_unstable();
        let path = self.folder.join(format!("run-{}", self.runs.len()));
        let mut out = BufWriter::new(File::create(&path)?);
        self.run.drain(..).try_for_each(|item| item.write(&mut out))?;
        out.flush()?;
        self.bytes = 0;
        self.runs.push(path);
        Ok(())
    }

    /// The sorted footprints.
    ///
    /// # Errors
    /// Errors of the file system.
    pub fn finish(mut self) -> io::Result<Lots> {
        self.end_run()?;
        self.run = Vec::new();
        let mut out = Output::new(&self.folder)?;
        let mut runs =
            self.runs.iter().map(|path| File::open(path).map(BufReader::new)).collect::<io::Result<Vec<_>>>()?;
        let mut next = BinaryHeap::new();
        for (number, run) in runs.iter_mut().enumerate() {
            next.extend(Item::read(run)?.map(|item| Reverse((item, number))));
        }
        while let Some(Reverse((item, number))) = next.pop() {
            out.add(&item)?;
            next.extend(Item::read(&mut runs[number])?.map(|item| Reverse((item, number))));
        }
        drop(runs);
        self.runs.iter().try_for_each(std::fs::remove_file)?;
        out.finish()
    }
}

impl Item {
    fn write(&self, out: &mut impl Write) -> io::Result<()> {
        out.write_all(&self.key.to_le_bytes())?;
        out.write_all(&self.digest)?;
        out.write_all(&[self.class])?;
        for bytes in [self.id.as_bytes(), &self.footprint] {
            out.write_all(&(bytes.len() as u64).to_le_bytes())?;
            out.write_all(bytes)?;
        }
        Ok(())
    }

    /// The next item of a run; `None` at its end.
    fn read(input: &mut impl Read) -> io::Result<Option<Self>> {
        let mut key = [0; 8];
        match input.read_exact(&mut key) {
            Err(why) if why.kind() == ErrorKind::UnexpectedEof => return Ok(None),
            read => read?,
        }
        let (mut digest, mut class) = ([0; 32], [0]);
        input.read_exact(&mut digest)?;
        input.read_exact(&mut class)?;
        let mut text = || {
            let mut length = [0; 8];
            input.read_exact(&mut length)?;
            let mut bytes = vec![0; u64::from_le_bytes(length) as usize];
            input.read_exact(&mut bytes)?;
            Ok::<_, io::Error>(bytes)
        };
        let id = String::from_utf8(text()?).map_err(|_| ErrorKind::InvalidData)?;
        let [class] = class;
        Ok(Some(Item { key: u64::from_le_bytes(key), id, digest, footprint: text()?, class }))
    }
}

/// The two files of sorted footprints.
struct Output {
    index: BufWriter<File>,
    footprints: BufWriter<File>,
    offset: u64,
    count: u64,
    large: Large,
}

impl Output {
    fn new(folder: &Path) -> io::Result<Self> {
        let create = |name: &str| {
            let path = folder.join(name);
            File::options().read(true).write(true).create(true).truncate(true).open(path).map(BufWriter::new)
        };
        Ok(Output {
            index: create("index")?,
            footprints: create("footprints")?,
            offset: 0,
            count: 0,
            large: Large::default(),
        })
    }

    fn add(&mut self, item: &Item) -> io::Result<()> {
        Entry { key: item.key, digest: item.digest, offset: self.offset }.write(&mut self.index)?;
        self.footprints.write_all(&item.footprint)?;
        self.offset += item.footprint.len() as u64;
        self.large.add(item.class, item.key, self.count);
        self.count += 1;
        Ok(())
    }

    /// The index ends with an entry for the end of the footprints.
    fn finish(mut self) -> io::Result<Lots> {
        Entry { key: u64::MAX, digest: [0; 32], offset: self.offset }.write(&mut self.index)?;
        let file = |out: BufWriter<File>| {
            let mut file = out.into_inner().map_err(io::IntoInnerError::into_error)?;
            file.rewind()?;
            Ok::<_, io::Error>(Mutex::new(file))
        };
        let (index, footprints) = (file(self.index)?, file(self.footprints)?);
        Ok(Lots { index, footprints, count: self.count, large: self.large })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn footprint(number: u64) -> Footprint {
        // An order that has nothing to do with the ids.
        let place = (number * 7919 % 1000) as f64 / 1e4;
        let ring = vec![[place, 0.0], [place + 1e-4, 0.0], [place + 1e-4, 1e-4], [place, 1e-4]];
        let id = format!("{:03}", number % 500);
        Footprint { id, seed: number, grammar: None, start: None, values: Vec::new(), rings: vec![ring], base: 0.0 }
    }

    fn sorted(order: impl Iterator<Item = u64>, run_bytes: usize) -> (Vec<Entry>, Vec<Footprint>) {
        let folder = tempfile::tempdir().expect("a folder");
        let mut sorter = Sorter::new(folder.path()).run_bytes(run_bytes);
        order.for_each(|number| sorter.add(&footprint(number)).expect("room"));
        let lots = sorter.finish().expect("room");
        let entries = lots.entries(0..lots.len()).expect("entries");
        assert!(entries.windows(2).all(|pair| pair[0].key <= pair[1].key));
        assert_eq!(
            lots.before(entries[700].key, 0..1000).map(|at| entries[at as usize].key).ok(),
            Some(entries[700].key)
        );
        (entries, lots.footprints(0..lots.len()).expect("footprints"))
    }

    #[test]
    fn the_order_does_not_depend_on_runs_and_on_the_order_of_rows() {
        let expected = sorted(0..1000, 1 << 20);
        assert!(expected.1.windows(2).all(|pair| pair[0].id <= pair[1].id));
        assert_eq!(expected.1.len(), 1000);
        assert_eq!(sorted((0..1000).rev(), 10_000), expected);
    }

    #[test]
    fn a_city_without_lots_is_empty() {
        let folder = tempfile::tempdir().expect("a folder");
        let lots = Sorter::new(folder.path()).finish().expect("room");
        assert!(lots.is_empty());
        assert_eq!(lots.footprints(0..0).expect("none"), []);
    }
}
