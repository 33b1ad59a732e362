//! The table of rows that failed: a line of JSON for each row, polygon and value that cannot be used, in parts.

use std::collections::BTreeMap;

use cga_geo::footprint::Footprint;
use cga_geo::row::Row;
use cga_geo::survey::Surveyor;
use serde::{Deserialize, Serialize};
use serde_json::json;

use crate::store::Store;

/// A part of the table.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct FailedPart {
    /// The name of its file.
    pub name: String,
    /// The number of its lines.
    pub lines: u64,
    /// The number of lines whose row, or a polygon of it, is lost.
    pub lost: u64,
}

/// The parts of the table of all rows. Batches with equal rows have one name: they count as often as they are added, and each has its lines in the table.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FailedParts(BTreeMap<String, (FailedPart, u64)>);

impl FailedParts {
    /// Adds the part of a batch.
    pub fn add(&mut self, part: FailedPart) {
        self.0.entry(part.name.clone()).or_insert((part, 0)).1 += 1;
    }

    /// The number of lines.
    pub fn lines(&self) -> u64 {
        self.0.values().map(|(part, count)| part.lines * count).sum()
    }

    /// The number of lines whose row, or a polygon of it, is lost.
    pub fn lost(&self) -> u64 {
        self.0.values().map(|(part, count)| part.lost * count).sum()
    }

    /// The names of all files, each after the file that it is a copy of.
    pub(crate) fn files(&self) -> impl Iterator<Item = (&str, String)> {
        let copy = |name: &str, number: u64| match number {
            1 => name.to_owned(),
            _ => format!("{}-{number}.jsonl", name.trim_end_matches(".jsonl")),
        };
        self.0.iter().flat_map(move |(name, (_, count))| (1..=*count).map(move |number| (&**name, copy(name, number))))
    }
}

impl FromIterator<FailedPart> for FailedParts {
    fn from_iter<P: IntoIterator<Item = FailedPart>>(parts: P) -> Self {
        let mut all = FailedParts::default();
        parts.into_iter().for_each(|part| all.add(part));
        all
    }
}

/// The part of a batch of rows. Its name follows from the rows, so a batch that is read twice has one file.
#[derive(Debug, Default)]
pub struct FailedRows {
    table: String,
    digest: blake3::Hasher,
    lines: u64,
    lost: u64,
}

impl FailedRows {
    /// Adds the problems of a row with its geometry as WKB. A line has the columns in place of the number of the row. The result is its footprints.
    pub fn survey(&mut self, surveyor: &Surveyor<'_>, wkb: &[u8], row: Row) -> Vec<Footprint> {
        self.digest.update(wkb);
        let columns = row.columns.clone();
        let survey = surveyor.survey(row);
        if survey.problems.is_empty() {
            return survey.footprints;
        }
        let values: serde_json::Map<_, _> =
            columns.into_iter().map(|(name, value)| (name, json!(value.to_string()))).collect();
        for problem in survey.problems {
            let line = json!({ "id": problem.id, "lost": problem.is_lost, "reason": problem.reason, "row": values });
            self.table.push_str(&format!("{line}\n"));
            self.lines += 1;
            self.lost += u64::from(problem.is_lost);
        }
        survey.footprints
    }

    /// Writes the part, if it has a line.
    ///
    /// # Errors
    /// A sentence about the store.
    pub fn write(mut self, store: &dyn Store) -> Result<Option<FailedPart>, String> {
        if self.lines == 0 {
            return Ok(None);
        }
        self.digest.update(self.table.as_bytes());
        let name = format!("failures/rows/{}.jsonl", &self.digest.finalize().to_hex()[..32]);
        store.write(&name, self.table.into_bytes()).map_err(|why| format!("cannot write `{name}`: {why}"))?;
        Ok(Some(FailedPart { name, lines: self.lines, lost: self.lost }))
    }
}
