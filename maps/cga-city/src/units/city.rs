//! A city from the files of its units.

use std::collections::HashSet;
use std::io;

use serde_json::json;

use super::failed_rows::FailedParts;
use super::make::UnitFile;
use super::plan::Plan;
use super::store::UnitStore;
use crate::cell::Cell;
use crate::leftovers::is_made;
use crate::root::write_root;
use crate::tally::Tally;

/// The file that marks a store as a city that is made in units.
const MARK: &str = "cga-cluster.json";

/// A finished city in numbers.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Finished {
    /// The tiles of all units.
    pub tally: Tally,
    /// The number of buildings that are lost.
    pub lost: u64,
    /// The number of other problems of buildings.
    pub notes: u64,
}

/// Marks a store. Old tiles are deleted in the end, so a store with other files is refused.
///
/// # Errors
/// A sentence about the store.
pub fn begin(store: &dyn UnitStore, address: &str) -> Result<(), String> {
    let failed = |why: io::Error| format!("cannot use the store `{address}`: {why}");
    if store.read(MARK).map_err(failed)?.is_none() {
        if !store.is_empty().map_err(failed)? {
            return Err(format!(
                "`{address}` has files that are not a city of cga-cluster or pycga; name a new folder"
            ));
        }
        let mark = json!({ "generator": concat!("cga-cluster ", env!("CARGO_PKG_VERSION")) });
        store.write(MARK, format!("{mark}\n").into_bytes()).map_err(failed)?;
    }
    Ok(())
}

/// Deletes the parts of the table of rows that failed which are not in the list: of older runs, and of batches that were read again. Batches with equal
/// rows have written one file, which is copied for each of them.
///
/// # Errors
/// Errors of the store.
pub fn keep_failed(store: &dyn UnitStore, parts: &FailedParts) -> io::Result<()> {
    let names: HashSet<String> = parts.files().map(|(_, name)| name).collect();
    store.delete_where("failures/rows", &|name| !names.contains(name))?;
    store.delete_parts("failures/rows", &|_| true)?;
    for (part, copy) in parts.files().filter(|(part, copy)| part != copy) {
        let lines = store.read(part)?.ok_or_else(|| io::Error::other(format!("`{part}` is missing")))?;
        store.write(&copy, lines)?;
    }
    Ok(())
}

/// Calls a function for each of some units with its file, if it is finished. Some files are read at a time.
fn each_file(
    store: &dyn UnitStore,
    plan: &Plan,
    units: impl IntoIterator<Item = usize>,
    mut each: impl FnMut(usize, Option<UnitFile>) -> Result<(), String>,
) -> Result<(), String> {
    let mut units = units.into_iter();
    loop {
        let part: Vec<usize> = units.by_ref().take(64).collect();
        if part.is_empty() {
            return Ok(());
        }
        let files = store.read_all(part.iter().map(|unit| plan.units[*unit].name()).collect());
        for (unit, file) in part.into_iter().zip(files.map_err(|why| why.to_string())?) {
            each(unit, UnitFile::finished(file.as_deref(), &plan.units[unit]))?;
        }
    }
}

/// The units without a finished file.
///
/// # Errors
/// A sentence about the store.
pub fn unfinished(store: &dyn UnitStore, plan: &Plan, units: Vec<usize>) -> Result<Vec<usize>, String> {
    let mut open = Vec::new();
    each_file(store, plan, units, |unit, file| {
        if file.is_none() {
            open.push(unit);
        }
        Ok(())
    })?;
    Ok(open)
}

/// Deletes the files of other units, and of units that will be made. The file of an older plan must not describe the tiles of this one.
///
/// # Errors
/// A sentence about the store.
pub fn delete_old_files(store: &dyn UnitStore, plan: &Plan, open: &[usize]) -> Result<(), String> {
    let open: HashSet<usize> = open.iter().copied().collect();
    let kept = plan.units.iter().enumerate().filter(|(unit, _)| !open.contains(unit));
    let kept: HashSet<String> = kept.map(|(_, unit)| unit.name()).collect();
    store.delete_where("units", &|name| !kept.contains(name)).map_err(|why| format!("cannot delete old files: {why}"))
}

/// Makes the root of the city from the files of its units, and deletes files of earlier runs that do not belong to it.
///
/// # Errors
/// A sentence: the city is empty, a unit is missing, or an error of the store.
pub fn finish(store: &dyn UnitStore, plan: &Plan, levels: usize) -> Result<Finished, String> {
    let failed = |why: io::Error| format!("cannot finish the city: {why}");
    let (Some(first), Some(last)) = (plan.units.first(), plan.units.last()) else {
        return Err(
            "the city is empty: no row has a polygon that can be used; the reasons are in `failures`".to_owned()
        );
    };
    let cell = Cell::around(first.count.keys[0], last.count.keys[1]);
    let (mut blocks, mut tally, mut lost, mut notes) = (Vec::new(), Tally::new(levels), 0, 0);
    each_file(store, plan, 0..plan.units.len(), |unit, file| {
        let unit = &plan.units[unit];
        let file = file.ok_or_else(|| format!("the unit {} is missing; start the job again", unit.cell()))?;
        blocks.extend(file.blocks);
        tally.merge(file.tally);
        (lost, notes) = (lost + file.lost, notes + file.notes);
        Ok(())
    })?;
    write_root(store, cell, blocks, &mut |name| tally.add_name(name)).map_err(failed)?;
    for folder in ["tiles", "sets", "areas", "images", "units", "failures/buildings"] {
        let is_own = |name: &str| !["tiles", "sets", "areas", "images"].contains(&folder) || is_made(name);
        store.delete_where(folder, &|name| is_own(name) && !tally.has_name(name)).map_err(failed)?;
        store.delete_parts(folder, &is_own).map_err(failed)?;
    }
    Ok(Finished { tally, lost, notes })
}
