//! The tiles of a run in numbers, and their problems.

use std::collections::BTreeSet;
use std::io;

use serde::{Deserialize, Serialize};

use crate::problems::Problems;
use crate::tile_file::{TileFile, description};
use crate::tree::TileEvent;

/// The tiles of a level.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct LevelSummary {
    /// The number of tiles with a file.
    pub tiles: u64,
    /// The bytes of their files.
    pub bytes: u64,
    /// The number of buildings.
    pub buildings: u64,
}

/// The tiles of a run.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Tally {
    /// The tiles of each level, from near to far.
    pub levels: Vec<LevelSummary>,
    /// The number of tiles that were made.
    pub made: u64,
    /// The number of tiles that were finished before.
    pub kept: u64,
    /// The hashes of the names of all files.
    names: BTreeSet<u64>,
    /// The tiles with problems that are not written yet.
    #[serde(skip)]
    problems: Vec<(String, TileFile)>,
}

impl Tally {
    /// A tally without tiles.
    pub fn new(levels: usize) -> Self {
        Tally { levels: vec![LevelSummary::default(); levels], ..Tally::default() }
    }

    /// Adds a tile.
    pub fn add(&mut self, event: &TileEvent<'_>) {
        let TileEvent { name, level, tile, was_finished, .. } = event;
        *(if *was_finished { &mut self.kept } else { &mut self.made }) += 1;
        self.names.extend([hash(name), hash(&description(name))]);
        self.names.extend(tile.images.iter().map(|(name, _)| hash(name)));
        if !tile.problems.is_empty() {
            self.problems.push(((*name).to_owned(), (*tile).clone()));
        }
        let summary = &mut self.levels[*level];
        summary.tiles += u64::from(0 < tile.bytes);
        summary.bytes += tile.bytes;
        summary.buildings += tile.buildings;
    }

    /// Adds the name of another file.
    pub fn add_name(&mut self, name: &str) {
        self.names.insert(hash(name));
    }

    /// Returns true if a file is one of the tiles, or was added.
    pub fn has_name(&self, name: &str) -> bool {
        self.names.contains(&hash(name))
    }

    /// Adds another tally.
    pub fn merge(&mut self, other: Tally) {
        for (own, other) in self.levels.iter_mut().zip(other.levels) {
            own.tiles += other.tiles;
            own.bytes += other.bytes;
            own.buildings += other.buildings;
        }
        self.made += other.made;
        self.kept += other.kept;
        self.names.extend(other.names);
        self.problems.extend(other.problems);
    }

    /// Writes the problems of the tiles since the last call, in the order of their names.
    ///
    /// # Errors
    /// Errors of the writer.
    pub fn write_problems<W: io::Write>(&mut self, out: &mut Problems<W>) -> io::Result<()> {
        self.problems.sort_by(|(a, _), (b, _)| a.cmp(b));
        for (name, tile) in self.problems.drain(..) {
            for problem in &tile.problems {
                out.of_building(&name, &problem.id, problem.is_lost, &problem.reason)?;
            }
            if 0 < tile.problems_left_out {
                out.further(&name, tile.problems_left_out)?;
            }
        }
        Ok(())
    }
}

fn hash(name: &str) -> u64 {
    let [a, b, c, d, e, f, g, h, ..] = *blake3::hash(name.replace('\\', "/").as_bytes()).as_bytes();
    u64::from_le_bytes([a, b, c, d, e, f, g, h])
}
