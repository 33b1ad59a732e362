//! The file of problems: a line of JSON for each row, each value and each building that is not as the map has it.

use std::fs::File;
use std::io::{self, BufWriter, Write};
use std::path::Path;

use cga_geo::plain::plain;
use serde_json::json;

/// Writes problems and counts them.
#[derive(Debug)]
pub struct Problems<W = BufWriter<File>> {
    out: W,
    /// The number of rows, polygons and buildings that the city does not have.
    pub lost: u64,
    /// The number of other problems.
    pub notes: u64,
    /// The first problems for a person to read: of losses, and of others.
    pub first: [Vec<String>; 2],
}

/// The number of losses, and the number of other problems, that are shown.
pub const SHOWN: [usize; 2] = [10, 3];

/// The most characters of an id and of a reason that are shown. The file has them whole.
const MOST_ID: usize = 60;
const MOST_REASON: usize = 400;

impl Problems {
    /// Begins a file.
    ///
    /// # Errors
    /// Errors of the file system.
    pub fn create(path: &Path) -> io::Result<Self> {
        // A link to another file is replaced, not followed.
        match std::fs::remove_file(path) {
            Err(why) if why.kind() != io::ErrorKind::NotFound => return Err(why),
            _ => {}
        }
        Ok(Problems::new(BufWriter::new(File::create(path)?)))
    }
}

impl<W: Write> Problems<W> {
    /// Begins with an empty writer.
    pub fn new(out: W) -> Self {
        Problems { out, lost: 0, notes: 0, first: Default::default() }
    }

    /// The writer.
    pub fn into_inner(self) -> W {
        self.out
    }

    /// Adds a problem of a row of a file.
    ///
    /// # Errors
    /// Errors of the file system.
    pub fn of_row(&mut self, file: &str, row: u64, id: &str, is_lost: bool, reason: &str) -> io::Result<()> {
        let name = if id.is_empty() { String::new() } else { format!(" (id {})", plain(id, MOST_ID)) };
        self.add(is_lost, format!("{file}, row {row}{name}: {}", plain(reason, MOST_REASON)));
        let line = json!({ "file": file, "row": row, "id": id, "lost": is_lost, "reason": reason });
        writeln!(self.out, "{line}")
    }

    /// Adds a problem of a building in a tile.
    ///
    /// # Errors
    /// Errors of the file system.
    pub fn of_building(&mut self, tile: &str, id: &str, is_lost: bool, reason: &str) -> io::Result<()> {
        self.add(is_lost, format!("{tile}, building `{}`: {}", plain(id, MOST_ID), plain(reason, MOST_REASON)));
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ids_and_reasons_are_shown_short_and_plain_and_written_whole() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("problems.jsonl");
        let mut problems = Problems::create(&path).expect("room");
        let id = format!("\u{1b}]0;x\u{7}\n{}", "9".repeat(1 << 20));
        problems.of_row("lots", 7, &id, true, &id).expect("room");
        problems.of_building("tile", &id, true, &id).expect("room");
        problems.finish().expect("room");
        for line in &problems.first[0] {
            assert!(line.len() < 1000 && !line.chars().any(char::is_control), "{line}");
            assert!(line.contains("\\u{1b}]0;x\\u{7}\\n999"), "{line}");
        }
        let text = std::fs::read_to_string(&path).expect("the file");
        let first: serde_json::Value = serde_json::from_str(text.lines().next().expect("a line")).expect("JSON");
        assert_eq!((first["id"].as_str(), first["row"].as_u64()), (Some(id.as_str()), Some(7)));
    }
}
