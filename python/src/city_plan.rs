//! The units of a city.

use std::io;
use std::sync::Arc;

use arrow_array::cast::AsArray as _;
use arrow_array::types::Int64Type;
use arrow_array::{LargeBinaryArray, RecordBatch};
use arrow_cast::cast;
use arrow_schema::DataType;
use cga::Watch;
use cga_city::build::Progress;
use cga_city::store::Store as _;
use cga_city::tree::TileEvent;
use cga_city::units::city::finish;
use cga_city::units::lot::UnitLot;
use cga_city::units::make::{UnitFile, UnitLots, UnitMaker};
use cga_city::units::plan::{Plan, PlanIndex};
use pyo3::prelude::*;
use pyo3::pybacked::PyBackedBytes;
use pyo3::types::{PyBytes, PyDict};
use serde::{Deserialize, Serialize};

use crate::arrow_table::ArrowTable;
use crate::city::{City, CityWork};
use crate::errors::CityError;
use crate::jobs::{pool, threads_of};
use crate::lot_table::{LotTable, LotTableBuilder};
use crate::run::{guarded, supervised};

/// The units of a city: parts of the map, each with whole tiles. `len(plan)` is their number. A plan can be pickled.
#[pyclass(frozen, module = "pycga")]
#[derive(Debug)]
pub(crate) struct CityPlan {
    city: Arc<CityWork>,
    index: PlanIndex,
    /// The number of lines in the table of rows that failed, and the number of losses among them.
    failed: [u64; 2],
}

/// A unit that is made.
#[derive(Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Made {
    unit: usize,
    /// The digest of all that its tiles depend on, with the lots of other units that it has read.
    digest: String,
}

#[pymethods]
impl CityPlan {
    /// Loads a plan that was pickled.
    #[staticmethod]
    #[pyo3(name = "_rebuild")]
    fn rebuild(city: &Bound<'_, City>, plan: &[u8], failed: [u64; 2]) -> PyResult<Self> {
        let plan: Plan = serde_json::from_slice(plan).map_err(|why| CityError::new_err(why.to_string()))?;
        let city = city.get().work().clone();
        if plan.digest != city.loaded.digest {
            return Err(CityError::new_err(
                "this machine has other assets, or another version of pycga, than the machine that made the plan; all machines need the same",
            ));
        }
        Ok(CityPlan::new(city, plan, failed))
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyAny>, Rebuilt<'py>)> {
        let plan = serde_json::to_vec(&self.index.plan).map_err(|why| CityError::new_err(why.to_string()))?;
        let rebuild = py.get_type::<CityPlan>().getattr("_rebuild")?;
        Ok((rebuild, (City::of(self.city.clone()), PyBytes::new(py, &plan), self.failed)))
    }

    /// The lots of a batch of rows, as a table of Arrow with the columns `unit` and `lot`.
    ///
    /// A lot has a row for each unit that reads it: its own one, and units around it whose rules may ask about it.
    fn lots(&self, py: Python<'_>, table: &Bound<'_, PyAny>) -> PyResult<LotTable> {
        let (city, batches) = (&*self.city, ArrowTable::batches_of(table)?);
        let lots = || {
            let (surveyor, mut out) = (city.loaded.surveyor()?, LotTableBuilder::default());
            for (_, row) in city.rows(&batches)?.iter().flat_map(|rows| rows.iter()) {
                for footprint in surveyor.survey(row).footprints {
                    let lot = UnitLot::new(&footprint, &city.loaded);
                    let units = self.index.units(lot.key, lot.class);
                    if units.is_empty() {
                        return Err(CHANGED.to_owned());
                    }
                    units.into_iter().try_for_each(|unit| out.add(unit, &lot.bytes))?;
                }
            }
            out.finish()
        };
        guarded(py, lots)?.map_err(CityError::new_err)
    }

    /// Makes the tiles of a unit and returns bytes for `finish`. Tiles that are finished are kept, and other threads of Python go on meanwhile.
    ///
    /// `group` is a table of Arrow with all lots of one unit: the rows of `lots` that have one number in the column `unit`. `threads` is the number of threads, by default
    /// one for each processor.
    #[pyo3(signature = (group, *, threads=None))]
    fn make<'py>(
        &self,
        py: Python<'py>,
        group: &Bound<'py, PyAny>,
        threads: Option<usize>,
    ) -> PyResult<Bound<'py, PyBytes>> {
        let (batches, watch, threads) = (ArrowTable::batches_of(group)?, Watch::new(), threads_of(threads)?);
        let make = || {
            let (unit, lots) = self.group(&batches)?;
            let made = self.make_unit(unit, &lots, threads, &watch)?;
            serde_json::to_vec(&made).map_err(|why| why.to_string())
        };
        let made = supervised(py, &watch, make)?.map_err(CityError::new_err)?;
        Ok(PyBytes::new(py, &made))
    }

    /// Makes the root of the city, `tileset.json`, from the results of `make` for all units in any order. One process calls it. Files of earlier cities that do
    /// not belong to this one are deleted.
    ///
    /// The result has numbers: `lots`, `units`, `tiles`, `buildings`, `bytes`; `failed_rows`, the lines of the tables in `failures/rows`, and
    /// `lost_rows`, the rows and polygons among them that have no building; `lost`, the buildings that failed, and `notes`, other problems of buildings.
    fn finish<'py>(&self, py: Python<'py>, made: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyDict>> {
        let mut plan = self.index.plan.clone();
        let mut open: Vec<bool> = vec![true; plan.units.len()];
        for bytes in made.try_iter()? {
            let bytes: PyBackedBytes = bytes?.extract()?;
            let wrong = |_| CityError::new_err("the bytes are not a result of `make`");
            let Made { unit, digest } = serde_json::from_slice(&bytes).map_err(wrong)?;
            let Some((own, is_open)) = plan.units.get_mut(unit).zip(open.get_mut(unit)) else {
                return Err(CityError::new_err("a unit is of another plan; make all units again"));
            };
            (own.digest, *is_open) = (digest, false);
        }
        let missing = open.iter().filter(|is_open| **is_open).count();
        if 0 < missing {
            let all = open.len();
            return Err(CityError::new_err(format!(
                "{missing} of {all} units are not made; make them before `finish`"
            )));
        }
        let (city, levels) = (&*self.city, self.city.loaded.levels.len());
        let finished = guarded(py, || finish(&city.store, &plan, levels))?.map_err(CityError::new_err)?;
        let levels = &finished.tally.levels;
        let numbers = [
            ("lots", plan.units.iter().map(|unit| unit.count.lots).sum()),
            ("units", plan.units.len() as u64),
            ("tiles", levels.iter().map(|level| level.tiles).sum()),
            ("buildings", levels.first().map_or(0, |near| near.buildings)),
            ("bytes", levels.iter().map(|level| level.bytes).sum()),
            ("failed_rows", self.failed[0]),
            ("lost_rows", self.failed[1]),
            ("lost", finished.lost),
            ("notes", finished.notes),
        ];
        let out = PyDict::new(py);
        numbers.into_iter().try_for_each(|(name, number)| out.set_item(name, number))?;
        Ok(out)
    }

    fn __len__(&self) -> usize {
        self.index.plan.units.len()
    }

    fn __repr__(&self) -> String {
        format!("<CityPlan of {} units>", self.index.plan.units.len())
    }
}

const CHANGED: &str = "the lots have changed since they were counted; count all rows again";

/// The arguments of `_rebuild`.
type Rebuilt<'py> = (City, Bound<'py, PyBytes>, [u64; 2]);

/// Ends the work of a unit when its call is stopped. Finished tiles stay.
struct Stop<'w>(&'w Watch);

impl Progress for Stop<'_> {
    fn tile(&self, _: &TileEvent<'_>) -> io::Result<()> {
        if self.0.is_stopped() { Err(io::ErrorKind::Interrupted.into()) } else { Ok(()) }
    }
}

impl CityPlan {
    pub(crate) fn new(city: Arc<CityWork>, plan: Plan, failed: [u64; 2]) -> Self {
        CityPlan { city, index: PlanIndex::new(plan), failed }
    }

    /// The number of the unit of a group, and its lots.
    ///
    /// # Errors
    /// A sentence about a column.
    fn group(&self, batches: &[RecordBatch]) -> Result<(usize, Vec<LargeBinaryArray>), String> {
        let (mut unit, mut lots) = (None, Vec::new());
        for batch in batches {
            let column = |name: &str, kind: &DataType| {
                let array = batch.column_by_name(name).ok_or_else(|| {
                    format!("the group has no column `{name}`; give `make` a group of the rows that `lots` returns")
                })?;
                cast(array, kind).map_err(|why| format!("the column `{name}`: {why}"))
            };
            for number in column("unit", &DataType::Int64)?.as_primitive::<Int64Type>() {
                let number = number.ok_or("a lot has no unit")?;
                if *unit.get_or_insert(number) != number {
                    return Err("the group has lots of several units; group the rows by `unit`".to_owned());
                }
            }
            let column = column("lot", &DataType::LargeBinary)?;
            lots.push(column.as_binary::<i64>().clone());
        }
        let unit = unit.ok_or("the group is empty")?;
        let number = usize::try_from(unit).ok().filter(|unit| *unit < self.index.plan.units.len());
        Ok((number.ok_or_else(|| format!("the plan has no unit {unit}"))?, lots))
    }

    fn make_unit(
        &self,
        number: usize,
        lots: &[LargeBinaryArray],
        threads: usize,
        watch: &Watch,
    ) -> Result<Made, String> {
        let CityWork { loaded, store, .. } = &*self.city;
        let mut unit = self.index.plan.units[number].clone();
        let lots = UnitLots::new(&unit, lots.iter().flat_map(|lots| lots.iter().flatten()))?;
        if self.index.plan.has_margins() {
            unit.set_read(lots.read);
        }
        let failed = |why: io::Error| format!("cannot use the file `{}`: {why}", unit.name());
        if UnitFile::finished(store.read(&unit.name()).map_err(failed)?.as_deref(), &unit).is_none() {
            // The file of older lots must not describe the tiles of these.
            store.delete(&unit.name()).map_err(failed)?;
            let threads = &pool(threads)?;
            UnitMaker { work: loaded, store, threads, progress: &Stop(watch) }.make(&unit, &lots)?;
        }
        Ok(Made { unit: number, digest: unit.digest })
    }
}
