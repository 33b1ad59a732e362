//! Counts of rows: lots in cells of the map, and parts of the table of rows that failed. Programs without an engine's sums add them here.

use std::collections::BTreeMap;

use cga_geo::row::Row;
use serde::{Deserialize, Serialize};

use super::failed_rows::{FailedPart, FailedParts, FailedRows};
use super::lot::UnitLot;
use super::plan::{Count, Plan, counted};
use super::work::LoadedWork;
use crate::store::Store;
use crate::tree::block_lots;

/// The counts of some rows. Their order does not matter.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Counts {
    /// The digest of the work.
    work: String,
    /// The lots of each counted cell.
    cells: BTreeMap<u64, Count>,
    /// The parts of the table of rows that failed.
    failed: Vec<FailedPart>,
}

impl Counts {
    /// Counts the lots of rows, each after its geometry as WKB, and writes the rows that failed to the store.
    ///
    /// # Errors
    /// A sentence about the store or the coordinate system.
    pub fn of<'r>(
        work: &LoadedWork,
        rows: impl Iterator<Item = (&'r [u8], Row)>,
        store: &dyn Store,
    ) -> Result<Self, String> {
        let (surveyor, mut failed) = (work.surveyor()?, FailedRows::default());
        let mut cells: BTreeMap<u64, Count> = BTreeMap::new();
        for (wkb, row) in rows {
            for footprint in failed.survey(&surveyor, wkb, row) {
                let count = Count::of(&UnitLot::new(&footprint, work));
                let cell = cells.entry(counted(count.keys[0]));
                cell.and_modify(|cell| cell.add(count)).or_insert(count);
            }
        }
        Ok(Counts { work: work.digest.clone(), cells, failed: failed.write(store)?.into_iter().collect() })
    }

    /// Adds the counts of other rows.
    ///
    /// # Errors
    /// A sentence: they were made with other rules, values, assets or choices.
    pub fn add(&mut self, other: Counts) -> Result<(), String> {
        if self.work.is_empty() {
            self.work = other.work;
        } else if self.work != other.work {
            return Err("the counts were made with different rules, assets or choices; count all rows again".to_owned());
        }
        for (cell, count) in other.cells {
            self.cells.entry(cell).and_modify(|own| own.add(count)).or_insert(count);
        }
        self.failed.extend(other.failed);
        Ok(())
    }

    /// The counts as bytes.
    pub fn to_bytes(&self) -> Vec<u8> {
        postcard::to_allocvec(self).unwrap_or_default()
    }

    /// Reads the bytes of [`to_bytes`](Counts::to_bytes).
    ///
    /// # Errors
    /// The bytes are not counts.
    pub fn from_bytes(bytes: &[u8]) -> Result<Self, String> {
        postcard::from_bytes(bytes).map_err(|why| format!("the bytes are not the counts of rows: {why}"))
    }

    /// The parts of the table of rows that failed.
    pub fn failed(&self) -> FailedParts {
        self.failed.iter().cloned().collect()
    }

    /// The plan of units with at most some lots.
    ///
    /// # Errors
    /// A sentence: they were made with other rules, values, assets or choices than the work.
    pub fn plan(self, work: &LoadedWork, unit_lots: u64) -> Result<Plan, String> {
        if !self.work.is_empty() && self.work != work.digest {
            return Err(
                "the counts were made with other rules, assets or choices than this city; count all rows again"
                    .to_owned(),
            );
        }
        let cells = self.cells.into_values().collect();
        Ok(Plan::new(String::new(), &work.digest, cells, unit_lots, block_lots(&work.levels), work.distance()))
    }
}
