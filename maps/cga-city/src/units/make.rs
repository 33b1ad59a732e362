//! Makes the tiles of a unit.

use std::io;
use std::ops::Range;
use std::sync::{Mutex, PoisonError};

use cga_geo::footprint::Footprint;
use rayon::ThreadPool;
use serde::{Deserialize, Serialize};

use super::lot::Sums;
use super::plan::Unit;
use super::work::LoadedWork;
use crate::build::Progress;
use crate::cell::key;
use crate::lots::{Lots, Sorter};
use crate::problems::Problems;
use crate::store::Store;
use crate::tally::Tally;
use crate::tree::{Block, TileEvent, Trees};

/// The file of a finished unit. The root of the city is made from these files.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct UnitFile {
    /// The digest of all that the unit depends on.
    pub digest: String,
    /// Its blocks along the curve.
    pub blocks: Vec<Block>,
    /// Its tiles in numbers.
    pub tally: Tally,
    /// The number of buildings that are lost.
    pub lost: u64,
    /// The number of other problems.
    pub notes: u64,
}

impl UnitFile {
    /// The file of a finished unit, from its bytes. `None` if the unit must be made.
    pub fn finished(bytes: Option<&[u8]>, unit: &Unit) -> Option<Self> {
        let file: UnitFile = serde_json::from_slice(bytes?).ok()?;
        (file.digest == unit.digest).then_some(file)
    }
}

/// The name of the table of the buildings of a unit that failed.
fn failures(unit: &Unit) -> String {
    format!("failures/buildings/{}.jsonl", unit.cell().to_string().replace('/', "-"))
}

/// The lots that a unit reads, sorted on the disk: its own, and others that its rules may find.
#[derive(Debug)]
pub struct UnitLots {
    lots: Lots,
    /// The numbers of its own lots.
    own: Range<u64>,
    own_sums: Sums,
    /// All lots in numbers.
    pub read: Sums,
    /// The folder is deleted with this value.
    _folder: tempfile::TempDir,
}

impl UnitLots {
    /// Sorts footprints, which are bytes in any order.
    ///
    /// # Errors
    /// A sentence: bytes that are not a footprint, or an error of the file system.
    pub fn new<'b>(unit: &Unit, footprints: impl Iterator<Item = &'b [u8]>) -> Result<Self, String> {
        let failed = |why: io::Error| format!("cannot sort the lots of the unit {}: {why}", unit.cell());
        let folder = tempfile::tempdir().map_err(failed)?;
        let mut sorter = Sorter::new(folder.path());
        let ([first, last], mut own_sums, mut read) = (unit.count.keys, Sums::default(), Sums::default());
        for bytes in footprints {
            let footprint = Footprint::from_bytes(bytes)?;
            let sums = Sums::of(bytes);
            read.add(sums);
            if (first..=last).contains(&key(footprint.middle())) {
                own_sums.add(sums);
            }
            sorter.add(&footprint).map_err(failed)?;
        }
        let lots = sorter.finish().map_err(failed)?;
        let begin = lots.before(first, 0..lots.len()).map_err(failed)?;
        let own = begin..lots.before(last + 1, begin..lots.len()).map_err(failed)?;
        Ok(UnitLots { lots, own, own_sums, read, _folder: folder })
    }

    /// # Errors
    /// A sentence: the lots have changed since they were counted.
    fn check(&self, unit: &Unit) -> Result<(), String> {
        let (own, read) = (&self.own_sums, &self.read);
        let numbers = [own.lots, read.lots, own.bytes, read.bytes];
        let counted = [unit.count.lots, unit.read_lots, unit.count.bytes, unit.read_bytes];
        if numbers[..2] != counted[..2] {
            return Err(format!(
                "the unit {} has {} lots and reads {}, and had {} and {} before; start again when the lots do not change any more",
                unit.cell(),
                numbers[0],
                numbers[1],
                counted[0],
                counted[1]
            ));
        }
        if numbers != counted || own.digests != unit.count.sums {
            return Err(format!(
                "the unit {} has as many lots as before, but some have changed; start again when the lots do not change any more",
                unit.cell()
            ));
        }
        Ok(())
    }
}

/// Makes units.
#[derive(Clone, Copy)]
pub struct UnitMaker<'m> {
    /// The work.
    pub work: &'m LoadedWork,
    /// The store of the tiles.
    pub store: &'m dyn Store,
    /// The threads. Rules may be nested deeply, so a thread needs a stack of 16 MB.
    pub threads: &'m ThreadPool,
    /// Hears of each tile, and may end the work.
    pub progress: &'m dyn Progress,
}

impl UnitMaker<'_> {
    /// Makes the tiles of a unit and its file. Finished tiles are kept.
    ///
    /// # Errors
    /// A sentence: lots that have changed since they were counted, or an error of the store.
    pub fn make(&self, unit: &Unit, lots: &UnitLots) -> Result<UnitFile, String> {
        lots.check(unit)?;
        let failed = |why: io::Error| format!("cannot make the unit {}: {why}", unit.cell());
        let tally = Mutex::new(Tally::new(self.work.levels.len()));
        let each = |event: &TileEvent<'_>| {
            tally.lock().unwrap_or_else(PoisonError::into_inner).add(event);
            self.progress.tile(event)
        };
        let (levels, store, most_bytes) = (&self.work.levels[..], self.store, self.work.work.options.most_bytes);
        let trees = Trees { lots: &lots.lots, levels, store, most_bytes, each: &each };
        let blocks = self.threads.install(|| trees.blocks_of(lots.own.clone(), |_| Ok(()))).map_err(failed)?;
        let mut tally = tally.into_inner().unwrap_or_else(PoisonError::into_inner);
        blocks.iter().for_each(|block| tally.add_name(&block.name));
        let mut problems = Problems::new(Vec::new());
        tally.write_problems(&mut problems).map_err(failed)?;
        let (lost, notes, table) = (problems.lost, problems.notes, problems.into_inner());
        let name = failures(unit);
        if table.is_empty() {
            store.delete(&name).map_err(failed)?;
        } else {
            store.write(&name, table).map_err(failed)?;
            tally.add_name(&name);
        }
        let name = unit.name();
        tally.add_name(&name);
        let file = UnitFile { digest: unit.digest.clone(), blocks, tally, lost, notes };
        // The file comes last, so a unit with a file is whole.
        store.write(&name, serde_json::to_vec(&file).map_err(|why| why.to_string())?).map_err(failed)?;
        Ok(file)
    }
}
