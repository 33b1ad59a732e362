//! The file of problems: a line of JSON for each row, each value and each building that is not as the map has it.

use std::fs::File;
use std::io::{self, BufWriter, Write};
use std::path::Path;

use serde_json::json;

/// Writes problems and counts them.
#[derive(Debug)]
pub struct Problems {
    out: BufWriter<File>,
    /// The number of rows, polygons and buildings that the city does not have.
    pub lost: u64,
    /// The number of other problems.
    pub notes: u64,
    /// The first problems for a person to read: of losses, and of others.
    pub first: [Vec<String>; 2],
}

/// The number of losses, and the number of other problems, that are shown.
pub const SHOWN: [usize; 2] = [10, 3];

impl Problems {
    /// Begins a file.
    ///
    /// # Errors
    /// Errors of the file system.
    pub fn create(path: &Path) -> io::Result<Self> {
        Ok(Problems { out: BufWriter::new(File::create(path)?), lost: 0, notes: 0, first: Default::default() })
    }

    /// Adds a problem of a row of a file.
    ///
    /// # Errors
    /// Errors of the file system.
    pub fn of_row(&mut self, file: &str, row: u64, id: &str, is_lost: bool, reason: &str) -> io::Result<()> {
        let name = if id.is_empty() { String::new() } else { format!(" (id {id})") };
        self.add(is_lost, format!("{file}, row {row}{name}: {reason}"));
        let line = json!({ "file": file, "row": row, "id": id, "lost": is_lost, "reason": reason });
        writeln!(self.out, "{line}")
    }

    /// Adds a problem of a building in a tile.
    ///
    /// # Errors
    /// Errors of the file system.
    pub fn of_building(&mut self, tile: &str, id: &str, is_lost: bool, reason: &str) -> io::Result<()> {
        self.add(is_lost, format!("{tile}, building `{id}`: {reason}"));
        let line = json!({ "tile": tile, "id": id, "lost": is_lost, "reason": reason });
        writeln!(self.out, "{line}")
    }

    /// Adds problems of a tile that are counted, not listed.
    ///
    /// # Errors
    /// Errors of the file system.
    pub fn further(&mut self, tile: &str, count: u64) -> io::Result<()> {
        self.notes += count;
        writeln!(self.out, "{}", json!({ "tile": tile, "further": count }))
    }

    fn add(&mut self, is_lost: bool, line: String) {
        *(if is_lost { &mut self.lost } else { &mut self.notes }) += 1;
        let kind = usize::from(!is_lost);
        if self.first[kind].len() < SHOWN[kind] {
            self.first[kind].push(line);
        }
    }

    /// Completes the file.
    ///
    /// # Errors
    /// Errors of the file system.
    pub fn finish(&mut self) -> io::Result<()> {
        self.out.flush()
    }
}
