//! Makes the tiles of a unit.

use std::io;
use std::sync::{Mutex, OnceLock, PoisonError};

use cga_city::lots::Sorter;
use cga_city::problems::Problems;
use cga_city::store::Store as _;
use cga_city::tally::Tally;
use cga_city::tree::{Block, TileEvent, Trees};
use cga_geo::footprint::Footprint;
use rayon::{ThreadPool, ThreadPoolBuilder};
use serde::{Deserialize, Serialize};

use crate::plan::Unit;
use crate::work::LoadedWork;

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

static THREADS: OnceLock<Result<ThreadPool, String>> = OnceLock::new();

/// The threads that make tiles in this process; the first call sets their number, and 0 is one on each processor.
///
/// # Errors
/// A sentence: the threads cannot be started.
pub fn threads(count: usize) -> Result<&'static ThreadPool, String> {
    // Rules may be nested deeply.
    let start = || ThreadPoolBuilder::new().num_threads(count).stack_size(16 << 20).build();
    let threads = THREADS.get_or_init(|| start().map_err(|why| format!("cannot start threads: {why}")));
    threads.as_ref().map_err(String::clone)
}

/// Makes the tiles of a unit and its file, from footprints as bytes in any order: its own, and others that its rules may find. Finished tiles are
/// kept.
///
/// # Errors
/// A sentence: bytes that are not a footprint, lots that have changed since they were counted, or an error of the store.
pub fn make_unit<'b>(
    work: &LoadedWork,
    unit: &Unit,
    footprints: impl Iterator<Item = &'b [u8]>,
) -> Result<UnitFile, String> {
    let failed = |why: io::Error| format!("cannot make the unit {}: {why}", unit.cell());
    let folder = tempfile::tempdir().map_err(failed)?;
    let mut sorter = Sorter::new(folder.path());
    for bytes in footprints {
        sorter.add(&Footprint::from_bytes(bytes)?).map_err(failed)?;
    }
    let lots = sorter.finish().map_err(failed)?;
    let [first, last] = unit.count.keys;
    let begin = lots.before(first, 0..lots.len()).map_err(failed)?;
    let own = begin..lots.before(last + 1, begin..lots.len()).map_err(failed)?;
    let (found, counted) = ([own.end - own.start, lots.len()], [unit.count.lots, unit.read_lots]);
    if found != counted {
        return Err(format!(
            "the unit {} has {} lots and reads {}, and had {} and {} before; start again when the lots do not change any more",
            unit.cell(),
            found[0],
            found[1],
            counted[0],
            counted[1]
        ));
    }
    let tally = Mutex::new(Tally::new(work.levels.len()));
    let each = |event: &TileEvent<'_>| {
        tally.lock().unwrap_or_else(PoisonError::into_inner).add(event);
        Ok(())
    };
    let (levels, store, most_bytes) = (&work.levels[..], &work.store, work.work.options.most_bytes);
    let trees = Trees { lots: &lots, levels, store, most_bytes, each: &each };
    let blocks = threads(0)?.install(|| trees.blocks_of(own.clone(), |_| Ok(()))).map_err(failed)?;
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
