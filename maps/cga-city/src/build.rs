//! A city from rows to the finished folder.

use std::fs::{self, File, TryLockError};
use std::io::{self, Write as _};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

use cga_geo::plain::plain;
use cga_geo::row::Row;
use cga_geo::survey::Surveyor;
use serde::{Deserialize, Serialize};
use serde_json::json;

use crate::cell::Cell;
use crate::leftovers::delete_others;
use crate::level::Level;
use crate::lots::Sorter;
use crate::problems::Problems;
use crate::root::write_root;
use crate::rules::Rules;
use crate::store::Folder;
use crate::surroundings::Distances;
use crate::tally::{LevelSummary, Tally};
use crate::tree::{self, Block, TileEvent, TreeLevel, Trees};

/// The choices of a city.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Options {
    /// Levels of detail for buildings far away, from near to far.
    pub levels: Vec<Level>,
    /// The most lots of a tile of the near level. Tiles of each further level have sixteen times as many, up to 65,536.
    pub lots_per_tile: u64,
    /// The most bytes of a tile with several lots.
    pub most_bytes: u64,
    /// The number of threads; `None` for one on each processor.
    pub jobs: Option<usize>,
    /// True for tiles that share their images: each is a file of its own, however many tiles show it.
    pub shares_images: bool,
    /// True for far tiles without normals, which are smaller. Some viewers show them without light and shade.
    pub plain_far: bool,
    /// True for near tiles whose triangles meet edge to edge, so that single pixels do not show through a façade. They take several times as long.
    pub watertight_near: bool,
    /// The distances up to which rules find other lots; `None` for rules that find no others.
    pub neighbours: Option<Distances>,
}

impl Default for Options {
    fn default() -> Self {
        Options {
            levels: Vec::new(),
            lots_per_tile: 256,
            most_bytes: 4 << 20,
            jobs: None,
            shares_images: true,
            plain_far: false,
            watertight_near: false,
            neighbours: Some(Distances::default()),
        }
    }
}

/// The lots of a tile of a level, as a multiple of the level below.
const LEVEL_LOTS: u64 = 16;

/// The error in metres of the first far level, and the factor to each further one.
const LEVEL_ERROR: (f64, f64) = (8.0, 4.0);

/// The file that marks a folder as a city.
const MARK: &str = "cga-city.json";

/// A finished city in numbers.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Summary {
    /// The number of rows.
    pub rows: u64,
    /// The number of lots: each polygon of a row is one.
    pub lots: u64,
    /// The tiles of each level, from near to far.
    pub levels: Vec<LevelSummary>,
    /// The number of tiles that this run made.
    pub made: u64,
    /// The number of tiles that were finished before.
    pub kept: u64,
    /// The number of rows, polygons and buildings that the city does not have.
    pub lost: u64,
    /// The number of other problems.
    pub notes: u64,
    /// The first problems: losses, then others.
    pub problems: Vec<String>,
}

/// Hears how far a city is.
pub trait Progress: Sync {
    /// A row was read; the number of rows so far.
    fn row(&self, _rows: u64) {}

    /// Reading has ended. The tiles of all levels together will have a number of lots.
    fn read(&self, _lots: u64) {}

    /// A tile is finished. An error ends the run; its tiles are kept for the next one.
    ///
    /// # Errors
    /// Any, to end the run.
    fn tile(&self, _event: &TileEvent<'_>) -> io::Result<()> {
        Ok(())
    }
}

/// Hears nothing.
#[derive(Clone, Copy, Debug, Default)]
pub struct NoProgress;

impl Progress for NoProgress {}

/// A city whose rows are being read.
#[derive(Debug)]
pub struct Build {
    folder: PathBuf,
    options: Options,
    problems: Problems,
    sorter: Sorter,
    /// The folder of sorted footprints; it is deleted with this value.
    _sorted: tempfile::TempDir,
    /// The locked mark of the folder. The lock ends with the process, however it ends.
    _lock: File,
    rows: u64,
    /// A sentence about each file that is damaged and ended early.
    damaged: Vec<String>,
}

impl Build {
    /// Begins a city in a folder: a new one, an empty one, or one that has a city. The folder is locked until the end of this value.
    ///
    /// # Errors
    /// A sentence about the folder, for example if another run has locked it.
    pub fn begin(folder: &Path, options: Options) -> Result<Self, String> {
        let unusable = |why: io::Error| format!("cannot write to `{}`: {why}", folder.display());
        fs::create_dir_all(folder).map_err(unusable)?;
        let has_mark = folder.join(MARK).is_file();
        if !has_mark && fs::read_dir(folder).map_err(unusable)?.next().is_some() {
            return Err(format!(
                "`{}` has files that are not a city, and old tiles are deleted; name a new folder",
                folder.display()
            ));
        }
        let lock = lock(folder)?;
        // A run that was stopped leaves such folders.
        for entry in fs::read_dir(folder).map_err(unusable)? {
            let path = entry.map_err(unusable)?.path();
            if path.file_name().is_some_and(|name| name.to_string_lossy().starts_with(".lots-")) {
                fs::remove_dir_all(&path).map_err(unusable)?;
            }
        }
        let sorted = tempfile::Builder::new().prefix(".lots-").tempdir_in(folder).map_err(unusable)?;
        let problems = Problems::create(&folder.join("problems.jsonl")).map_err(unusable)?;
        let sorter = Sorter::new(sorted.path());
        let (folder, damaged) = (folder.to_owned(), Vec::new());
        Ok(Build { folder, options, problems, sorter, _sorted: sorted, _lock: lock, rows: 0, damaged })
    }

    /// Adds the rows of a file.
    ///
    /// # Errors
    /// Errors of the file system.
    pub fn add(
        &mut self,
        file: &str,
        rows: impl Iterator<Item = Row>,
        surveyor: &Surveyor<'_>,
        progress: &dyn Progress,
    ) -> io::Result<()> {
        for row in rows {
            if let Some(why) = row.outlines.as_ref().err().filter(|_| row.is_damaged_end) {
                self.damaged.push(format!(
                    "`{}` is damaged in row {}: {}",
                    plain(file, 200),
                    row.number,
                    plain(why, 300)
                ));
            }
            let survey = surveyor.survey(row);
            for problem in &survey.problems {
                self.problems.of_row(file, problem.row, &problem.id, problem.is_lost, &problem.reason)?;
            }
            survey.footprints.iter().try_for_each(|footprint| self.sorter.add(footprint))?;
            self.rows += 1;
            progress.row(self.rows);
        }
        Ok(())
    }

    /// Returns true if a file of lots is damaged and ended early. Then no tiles are made.
    pub fn is_damaged(&self) -> bool {
        !self.damaged.is_empty()
    }

    /// Makes the tiles, and deletes tiles of older runs that do not belong to the city.
    ///
    /// # Errors
    /// A sentence: a file of lots is damaged and ended early, so that an older city stays as it is; a level does not fit the rules; or an
    /// error of the file system.
    pub fn finish(self, rules: &Rules, progress: &dyn Progress) -> Result<Summary, String> {
        let Build { folder, options, mut problems, sorter, _sorted, _lock, rows, damaged } = self;
        let levels = options.tree_levels(rules)?;
        let unusable = |why: io::Error| format!("cannot make the tiles in `{}`: {why}", folder.display());
        if !damaged.is_empty() {
            problems.finish().map_err(unusable)?;
            return Err(format!("{}; no tile was made or deleted", damaged.join("\n")));
        }
        let lots = sorter.finish().map_err(unusable)?;
        progress.read(lots.len() * levels.len() as u64);
        let mut pool = rayon::ThreadPoolBuilder::new();
        if let Some(jobs) = options.jobs {
            pool = pool.num_threads(jobs);
        }
        // Rules may be nested deeply.
        let pool = pool.stack_size(16 << 20).build().map_err(|why| format!("cannot start threads: {why}"))?;
        let log = Mutex::new(Tally::new(levels.len()));
        let each = |event: &TileEvent<'_>| {
            log.lock().unwrap_or_else(PoisonError::into_inner).add(event);
            progress.tile(event)
        };
        let store = Folder(folder.clone());
        let trees = Trees { lots: &lots, levels: &levels, store: &store, most_bytes: options.most_bytes, each: &each };
        let blocks = |problems: &mut Problems| -> io::Result<()> {
            let (cell, blocks) = blocks(&trees, &log, problems)?;
            // A city without lots is a mistake, and the older one stays.
            if !lots.is_empty() || !folder.join("tileset.json").exists() {
                let mut log = log.lock().unwrap_or_else(PoisonError::into_inner);
                write_root(&store, cell, blocks, &mut |name| log.add_name(name))?;
            }
            problems.finish()
        };
        pool.install(|| blocks(&mut problems)).map_err(unusable)?;
        let log = log.into_inner().unwrap_or_else(PoisonError::into_inner);
        if !lots.is_empty() {
            delete_others(&folder, &|name| log.has_name(name)).map_err(unusable)?;
        }
        Ok(Summary {
            rows,
            lots: lots.len(),
            levels: log.levels,
            made: log.made,
            kept: log.kept,
            lost: problems.lost,
            notes: problems.notes,
            problems: problems.first.concat(),
        })
    }
}

/// Opens the mark of a folder and locks it. Two runs in one folder would delete the tiles of each other.
fn lock(folder: &Path) -> Result<File, String> {
    let path = folder.join(MARK);
    let unusable = |why: io::Error| format!("cannot write to `{}`: {why}", path.display());
    // A link leads to a file of its own, and the mark is written from its beginning.
    if fs::symlink_metadata(&path).is_ok_and(|found| found.is_symlink()) {
        return Err(format!("`{}` is a link, and its file is not written over; delete the link", path.display()));
    }
    let mut file = File::options().read(true).write(true).create(true).truncate(false).open(&path).map_err(unusable)?;
    match file.try_lock() {
        Ok(()) => {}
        Err(TryLockError::WouldBlock) => {
            let folder = folder.display();
            return Err(format!(
                "another run of cga-city writes to `{folder}`; wait for its end, or name another folder"
            ));
        }
        // Some file systems of networks have no locks.
        Err(TryLockError::Error(why)) if why.kind() == io::ErrorKind::Unsupported => {}
        Err(TryLockError::Error(why)) => return Err(unusable(why)),
    }
    let mark = format!("{}\n", json!({ "generator": concat!("cga-city ", env!("CARGO_PKG_VERSION")) }));
    file.set_len(0).and_then(|()| file.write_all(mark.as_bytes())).map_err(unusable)?;
    Ok(file)
}

impl Options {
    /// Checks the levels of detail before rows are read.
    ///
    /// # Errors
    /// A sentence: a level is given twice, has an error that is not above the error of the nearer level, or does not fit the rules.
    pub fn check(&self, rules: &Rules) -> Result<(), String> {
        self.tree_levels(rules).map(drop)
    }

    /// The levels of detail, from near to far.
    ///
    /// # Errors
    /// As [`check`](Options::check).
    pub fn tree_levels(&self, rules: &Rules) -> Result<Vec<TreeLevel>, String> {
        let near = Level { error: Some(0.0), ..Level::default() };
        let mut lots = self.lots_per_tile.max(1);
        let mut error = LEVEL_ERROR.0;
        let Options { neighbours, shares_images, plain_far, watertight_near, .. } = *self;
        let near = TreeLevel {
            rules: rules.at(&near)?,
            lots,
            error: 0.0,
            neighbours,
            shares_images,
            has_normals: true,
            is_watertight: watertight_near,
        };
        let mut levels = vec![near];
        for (number, level) in self.levels.iter().enumerate() {
            let is_same = |other: &Level| (&other.start, &other.values) == (&level.start, &level.values);
            if self.levels[..number].iter().any(is_same) {
                return Err(format!("the level `{level}` is given twice"));
            }
            // The footprints of a tile are in memory.
            lots = lots.saturating_mul(LEVEL_LOTS).min(tree::BLOCK_LOTS.max(lots));
            error = level.error.unwrap_or(error);
            if error <= levels[levels.len() - 1].error {
                let nearer = levels[levels.len() - 1].error;
                return Err(format!(
                    "the error of the level `{level}` is {error} m, which is not above the {nearer} m of the nearer level"
                ));
            }
            let rules = rules.at(level).map_err(|why| format!("the level `{level}`: {why}"))?;
            let has_normals = !plain_far;
            levels.push(TreeLevel { rules, lots, error, neighbours, shares_images, has_normals, is_watertight: false });
            error *= LEVEL_ERROR.1;
        }
        Ok(levels)
    }
}

/// The blocks of the city, and the cell around them.
fn blocks(trees: &Trees<'_>, log: &Mutex<Tally>, problems: &mut Problems) -> io::Result<(Cell, Vec<Block>)> {
    let cell = trees.piece(0..trees.lots.len())?.map_or(Cell::WORLD, |all| all.cell);
    let blocks = trees.blocks(|block| {
        let mut log = log.lock().unwrap_or_else(PoisonError::into_inner);
        log.write_problems(problems)?;
        block.iter().for_each(|block| log.add_name(&block.name));
        Ok(())
    })?;
    Ok((cell, blocks))
}
