//! A job from its rows to the root of the city, in queries of an engine.

use std::collections::{BTreeMap, HashMap, HashSet};
use std::time::Duration;

use cga_city::area::Area;
use cga_city::cell::Cell;
use cga_city::leftovers::is_made;
use cga_city::root::write_root;
use cga_city::store::Store as _;
use cga_city::tally::Tally;
use cga_city::tree::block_lots;
use datafusion::arrow::array::{Array as _, AsArray as _, RecordBatch};
use datafusion::arrow::compute::cast;
use datafusion::arrow::datatypes::{DataType, Float64Type, UInt64Type};
use serde_json::json;

use crate::engine::{Engine, PAUSE};
use crate::job::Job;
use crate::lots::Lots;
use crate::plan::{Count, Plan, Unit};
use crate::sql::literal;
use crate::store::Objects;
use crate::unit::UnitFile;
use crate::work::{LoadedWork, publish};

/// The seconds from one look at the files of units to the next.
const LOOK: u64 = 3;

/// The file that marks an address as a city of this program.
const MARK: &str = "cga-cluster.json";

/// Hears how far a job is.
pub trait Progress: Sync {
    /// A step begins, with its number of buildings if it is known.
    fn step(&self, name: &str, buildings: Option<u64>);

    /// The number of buildings that are finished in this step.
    fn finished(&self, buildings: u64);
}

/// Hears nothing.
#[derive(Clone, Copy, Debug, Default)]
pub struct NoProgress;

impl Progress for NoProgress {
    fn step(&self, _: &str, _: Option<u64>) {}

    fn finished(&self, _: u64) {}
}

/// A finished city in numbers.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Summary {
    /// The number of lots: each polygon of a row is one.
    pub lots: u64,
    /// The number of units that this run made.
    pub units_made: usize,
    /// The number of units that were finished before.
    pub units_kept: usize,
    /// The tiles of all units.
    pub tally: Tally,
    /// The number of lines in the table of rows that failed.
    pub failed_rows: u64,
    /// The number of these lines whose row, or a polygon of it, is lost.
    pub lost_rows: u64,
    /// The number of buildings that are lost.
    pub lost: u64,
    /// The number of other problems of buildings.
    pub notes: u64,
}

/// Makes a city.
///
/// # Errors
/// A sentence about the job, its rules or its lots, or an error of the store or the engine. Finished tiles are kept for the next run.
pub async fn run(engine: &Engine, job: &Job, progress: &dyn Progress) -> Result<Summary, String> {
    let store = Objects::open(&job.store)?;
    begin(&store, &job.store)?;
    let lots = Lots::open(&engine.context, &job.lots).await?;
    let work = LoadedWork::new(job.work(&lots.geometry.crs)?, store.clone())?;
    work.rules.check_attributes(work.work.columns.attributes.iter().map(|(_, name)| name.as_str()))?;
    work.rules.warnings().for_each(|warning| log::warn!("{warning}"));
    let name = publish(&store, &work.work)?;
    let address = |name: &str| format!("{}/{name}", job.store.trim_end_matches('/'));
    let names = work.work.columns.names(&work.rules.grammars());
    let call = lots.register(&engine.context, &work.work.columns, &names, &address(&name))?;

    progress.step("counting lots", None);
    let mut counts = Vec::new();
    for batch in engine.retry(&count(&call("cga_lots"))).await? {
        counts.extend(counts_of(&batch)?);
    }
    let (most, block_lots) = (job.unit_lots, block_lots(&work.levels));
    let mut plan = Plan::new(name.clone(), &work.digest, counts, most, block_lots, work.distance());
    let mut plan_name = publish(&store, &plan)?;
    if plan.has_margins() {
        progress.step("finding neighbours", None);
        for batch in engine.retry(&read(&call("cga_lots"), &address(&plan_name))).await? {
            numbers::<5>(&batch)?.into_iter().for_each(|[unit, read @ ..]| plan.set_read(unit as usize, read));
        }
        plan_name = publish(&store, &plan)?;
    }

    progress.step("checking rows", None);
    let mut parts = BTreeMap::new();
    for batch in engine.retry(&failures(&call("cga_failures"))).await? {
        parts.extend(parts_of(&batch)?);
    }
    let [failed_rows, lost_rows] = [0, 1].map(|at: usize| parts.values().map(|part| part[at]).sum());
    // Also the parts of a query that failed and was tried again.
    store.delete_where("failures/rows", |name| !parts.contains_key(name)).map_err(|why| why.to_string())?;
    store.delete_parts("failures/rows", |_| true).map_err(|why| why.to_string())?;

    let lots = plan.units.iter().map(|unit| unit.count.lots).sum();
    progress.step("making tiles", Some(lots));
    let wave = job.wave_size.saturating_mul(1 << 20);
    let made = make(engine, &store, &plan, wave, &call("cga_lots"), &address(&plan_name), progress).await?;
    let (tally, lost, notes) = finish(&store, &plan, work.levels.len())?;
    let units_kept = plan.units.len() - made;
    Ok(Summary { lots, units_made: made, units_kept, tally, failed_rows, lost_rows, lost, notes })
}

/// Marks an address. Old tiles are deleted in the end, so an address with other files is refused.
fn begin(store: &Objects, address: &str) -> Result<(), String> {
    let failed = |why: std::io::Error| format!("cannot use the store `{address}`: {why}");
    if store.read(MARK).map_err(failed)?.is_none() {
        if !store.is_empty().map_err(failed)? {
            return Err(format!("`{address}` has files that are not a city of cga-cluster; name a new folder"));
        }
        let mark = json!({ "generator": concat!("cga-cluster ", env!("CARGO_PKG_VERSION")) });
        store.write(MARK, format!("{mark}\n").into_bytes()).map_err(failed)?;
    }
    Ok(())
}

/// The lots of each counted cell.
fn count(lots: &str) -> String {
    format!(
        "select count(*), sum(lot['bytes']), min(lot['key']), max(lot['key']), sum(lot['low']), sum(lot['high']), \
         min(lot['west']), min(lot['north']), max(lot['east']), max(lot['south']) from (select unnest({lots}) as lot from lots) group by lot['cell']"
    )
}

fn counts_of(batch: &RecordBatch) -> Result<Vec<Count>, String> {
    let side = |at| cast(batch.column(at), &DataType::Float64).map_err(|why| why.to_string());
    let sides = (6..10).map(side).collect::<Result<Vec<_>, _>>()?;
    let count = |(row, [lots, bytes, first, last, low, high]): (usize, [u64; 6])| {
        let sides = sides.iter().map(|side| side.as_primitive::<Float64Type>());
        let sides: Option<Vec<f64>> = sides.map(|side| side.is_valid(row).then(|| side.value(row))).collect();
        let area = sides.map(|sides| Area { low: [sides[0], sides[1]], high: [sides[2], sides[3]] });
        Count { lots, bytes, keys: [first, last], sums: [low, high], area }
    };
    Ok(numbers(batch)?.into_iter().enumerate().map(count).collect())
}

/// The first columns of each row.
fn numbers<const N: usize>(batch: &RecordBatch) -> Result<Vec<[u64; N]>, String> {
    let columns = (0..N).map(|at| column(batch, at)).collect::<Result<Vec<_>, _>>()?;
    Ok((0..batch.num_rows()).map(|row| std::array::from_fn(|at| columns[at][row])).collect())
}

fn column(batch: &RecordBatch, at: usize) -> Result<Vec<u64>, String> {
    let numbers = cast(batch.column(at), &DataType::UInt64).map_err(|why| why.to_string())?;
    Ok(numbers.as_primitive::<UInt64Type>().values().to_vec())
}

/// Writes the table of rows that failed. A part of it has the problems of a batch of rows, so memory does not grow with their number.
fn failures(failures: &str) -> String {
    format!(
        "select part['name'], part['lines'], part['lost'] from (select unnest({failures}) as part from lots) \
         where part['name'] is not null"
    )
}

/// The names of parts of the table, each with the number of its lines and the number of losses.
fn parts_of(batch: &RecordBatch) -> Result<Vec<(String, [u64; 2])>, String> {
    let names = cast(batch.column(0), &DataType::Utf8).map_err(|why| why.to_string())?;
    let (lines, lost) = (column(batch, 1)?, column(batch, 2)?);
    let names = names.as_string::<i32>().iter().flatten().map(str::to_owned);
    Ok(names.zip(lines.into_iter().zip(lost)).map(|(name, (lines, lost))| (name, [lines, lost])).collect())
}

/// The lots that each unit reads.
fn read(lots: &str, plan: &str) -> String {
    let plan = literal(plan);
    format!(
        "select unit, count(*), sum(bytes), sum(low), sum(high) \
         from (select unnest(cga_units({plan}, lot['key'], lot['class'])) as unit, lot['bytes'] as bytes, lot['low'] as low, lot['high'] as high \
         from (select unnest({lots}) as lot from lots)) group by unit"
    )
}

/// Makes the tiles of units.
fn tiles(lots: &str, plan: &str, units: &[usize]) -> String {
    let units: Vec<String> = units.iter().map(usize::to_string).collect();
    let (plan, units) = (literal(plan), units.join(", "));
    format!(
        "select cga_tile({plan}, unit, array_agg(footprint)) \
         from (select unnest(cga_units({plan}, lot['key'], lot['class'])) as unit, lot['footprint'] as footprint \
         from (select unnest({lots}) as lot from lots)) where unit in ({units}) group by unit"
    )
}

/// Makes the units that are not finished, in waves: the footprints of a wave are in memory, on all machines together. The result is their number.
async fn make(
    engine: &Engine,
    store: &Objects,
    plan: &Plan,
    wave_bytes: u64,
    lots: &str,
    address: &str,
    progress: &dyn Progress,
) -> Result<usize, String> {
    let mut open: Vec<usize> = unfinished(store, plan, (0..plan.units.len()).collect())?;
    delete_old_files(store, plan, &open)?;
    let (count, mut failures) = (open.len(), 0);
    let total: u64 = plan.units.iter().map(|unit| unit.count.lots).sum();
    while !open.is_empty() {
        let mut bytes = 0;
        let fits = |unit: &&usize| {
            bytes += plan.units[**unit].read_bytes;
            bytes <= wave_bytes
        };
        let length = open.iter().take_while(fits).count().max(1);
        let wave: Vec<usize> = open.drain(..length).collect();
        let before = total - wave.iter().chain(&open).map(|unit| plan.units[*unit].count.lots).sum::<u64>();
        let sql = tiles(lots, address, &wave);
        let result = watched(engine.query(&sql), store, plan, &wave, |lots| progress.finished(before + lots)).await;
        // The files of units decide, not the rows of the query, which may be on an executor that is lost.
        let rest = unfinished(store, plan, wave)?;
        failures = if rest.len() < length { 0 } else { failures + 1 };
        match result {
            Err(why) if engine.attempts <= failures => return Err(why),
            Err(why) if !rest.is_empty() => {
                log::warn!("{} units are tried again: {why}", rest.len());
                tokio::time::sleep(PAUSE).await;
            }
            Ok(_) if !rest.is_empty() => {
                return Err("the lots have changed since they were counted; start the job again".to_owned());
            }
            _ => {}
        }
        open.splice(0..0, rest);
    }
    Ok(count)
}

/// Calls a function for each of some units with its file, if it is finished. Some files are read at a time.
fn each_file(
    store: &Objects,
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
        let files = store.read_all(part.iter().map(|unit| plan.units[*unit].name()));
        for (unit, file) in part.into_iter().zip(files.map_err(|why| why.to_string())?) {
            each(unit, UnitFile::finished(file.as_deref(), &plan.units[unit]))?;
        }
    }
}

/// The units without a finished file.
fn unfinished(store: &Objects, plan: &Plan, units: Vec<usize>) -> Result<Vec<usize>, String> {
    let mut open = Vec::new();
    each_file(store, plan, units, |unit, file| {
        if file.is_none() {
            open.push(unit);
        }
        Ok(())
    })?;
    Ok(open)
}

/// Deletes the files of other units, and of units that will be made. The file of an older job must not describe the tiles of this one.
fn delete_old_files(store: &Objects, plan: &Plan, open: &[usize]) -> Result<(), String> {
    let open: HashSet<usize> = open.iter().copied().collect();
    let kept = plan.units.iter().enumerate().filter(|(unit, _)| !open.contains(unit));
    let kept: HashSet<String> = kept.map(|(_, unit)| unit.name()).collect();
    store.delete_where("units", |name| !kept.contains(name)).map_err(|why| format!("cannot delete old files: {why}"))
}

/// Waits for a query and looks at the files of its units, which any machine writes.
async fn watched<T>(
    query: impl Future<Output = T>,
    store: &Objects,
    plan: &Plan,
    wave: &[usize],
    mut progress: impl FnMut(u64),
) -> T {
    let look = || -> HashMap<String, _> {
        let files = store.list("units").unwrap_or_default().into_iter();
        files.map(|(name, file)| (name, file.last_modified)).collect()
    };
    let units: Vec<(String, &Unit)> = wave.iter().map(|at| (plan.units[*at].name(), &plan.units[*at])).collect();
    let before = look();
    progress(0);
    tokio::pin!(query);
    loop {
        tokio::select! {
            result = &mut query => return result,
            () = tokio::time::sleep(Duration::from_secs(LOOK)) => {
                let now = look();
                let is_new = |name: &String| now.get(name).is_some_and(|time| before.get(name) != Some(time));
                progress(units.iter().filter(|(name, _)| is_new(name)).map(|(_, unit)| unit.count.lots).sum());
            }
        }
    }
}

/// Makes the root of the city from the files of its units, and deletes files of earlier runs that do not belong to it.
fn finish(store: &Objects, plan: &Plan, levels: usize) -> Result<(Tally, u64, u64), String> {
    let failed = |why: std::io::Error| format!("cannot finish the city: {why}");
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
        store.delete_where(folder, |name| is_own(name) && !tally.has_name(name)).map_err(failed)?;
        store.delete_parts(folder, is_own).map_err(failed)?;
    }
    Ok((tally, lost, notes))
}
