//! A job from its rows to the root of the city, in queries of an engine.

use std::collections::HashMap;
use std::time::Duration;

use cga_city::area::Area;
use cga_city::tally::Tally;
use cga_city::tree::block_lots;
use cga_city::units::city::{Finished, begin, delete_old_files, finish, keep_failed, unfinished};
use cga_city::units::failed_rows::{FailedPart, FailedParts};
use cga_city::units::lot::Sums;
use cga_city::units::plan::{Count, Plan, Unit};
use datafusion::arrow::array::{Array as _, AsArray as _, RecordBatch};
use datafusion::arrow::compute::cast;
use datafusion::arrow::datatypes::{DataType, Float64Type, UInt64Type};

use crate::engine::{Engine, PAUSE};
use crate::job::Job;
use crate::lots::Lots;
use crate::sql::literal;
use crate::store::Objects;
use crate::work::{StoredWork, publish};

/// The seconds from one look at the files of units to the next.
const LOOK: u64 = 3;

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
    let StoredWork { loaded: work, .. } = StoredWork::new(job.work(&lots.geometry.crs)?, store.clone())?;
    work.rules.check_attributes(work.work.columns.attributes.iter().map(|(_, name)| name.as_str()))?;
    work.rules.warnings().for_each(|warning| log::warn!("{warning}"));
    let name = publish(&store, &work.work)?;
    let address = |name: &str| format!("{}/{name}", job.store.trim_end_matches('/'));
    let names = work.column_names();
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
            for [unit, lots, bytes, low, high] in numbers(&batch)? {
                let unit = plan.units.get_mut(unit as usize);
                unit.into_iter().for_each(|unit| unit.set_read(Sums { lots, bytes, digests: [low, high] }));
            }
        }
        plan_name = publish(&store, &plan)?;
    }

    progress.step("checking rows", None);
    let mut parts = FailedParts::default();
    for batch in engine.retry(&failures(&call("cga_failures"))).await? {
        parts_of(&batch)?.into_iter().for_each(|part| parts.add(part));
    }
    let [failed_rows, lost_rows] = [parts.lines(), parts.lost()];
    // Also the parts of a query that failed and was tried again.
    keep_failed(&store, &parts).map_err(|why| why.to_string())?;

    let lots = plan.units.iter().map(|unit| unit.count.lots).sum();
    progress.step("making tiles", Some(lots));
    let wave = job.wave_size.saturating_mul(1 << 20);
    let made = make(engine, &store, &plan, wave, &call("cga_lots"), &address(&plan_name), progress).await?;
    let Finished { tally, lost, notes } = finish(&store, &plan, work.levels.len())?;
    let units_kept = plan.units.len() - made;
    Ok(Summary { lots, units_made: made, units_kept, tally, failed_rows, lost_rows, lost, notes })
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

/// The parts of the table of rows that failed.
fn parts_of(batch: &RecordBatch) -> Result<Vec<FailedPart>, String> {
    let names = cast(batch.column(0), &DataType::Utf8).map_err(|why| why.to_string())?;
    let (lines, lost) = (column(batch, 1)?, column(batch, 2)?);
    let names = names.as_string::<i32>().iter().flatten().map(str::to_owned);
    Ok(names.zip(lines.into_iter().zip(lost)).map(|(name, (lines, lost))| FailedPart { name, lines, lost }).collect())
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
