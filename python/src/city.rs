//! Cities as 3D Tiles of tables, for engines with many machines.

use std::path::PathBuf;
use std::sync::Arc;

use arrow_array::RecordBatch;
use cga_city::store::Folder;
use cga_city::units::city::{begin, delete_old_files, keep_failed};
use cga_city::units::counts::Counts;
use cga_city::units::work::{LoadedWork, Work};
use cga_geo::missing;
use cga_geo::reader::arrow::{self, Rows};
use cga_geo::survey::Columns;
use pyo3::prelude::*;
use pyo3::pybacked::PyBackedBytes;
use pyo3::types::{PyBytes, PyDict, PyMapping};

use crate::arrow_table::ArrowTable;
use crate::city_choices::{absolute, assets, attribute_columns, check_names, crs, options, rule_files, texts, values};
use crate::city_plan::CityPlan;
use crate::errors::{AttributeValueError, CityError};
use crate::run::guarded;

/// A city of a table of lots: 3D Tiles in a folder, with the bytes of the command `cga-city`. An engine runs the calls on many machines:
///
/// 1. `count` for each batch of rows, then `plan` once with all counts;
/// 2. `CityPlan.lots` for each batch of rows, then `CityPlan.make` for each group of lots with one `unit`;
/// 3. `CityPlan.finish` once with the results of all groups.
///
/// `folder` is a new folder, or a folder of an earlier city, at the same path on all machines. `rules` is a `RuleFile` or a list of several; the
/// first has all rows that name none in `grammar_column`. A table has a column of WKB, `geometry`, and columns with the names of attributes, which
/// they set; `columns` has other columns by attribute. `attributes` has values for all lots. `name` is the column of names, from which seeds follow;
/// without it, it is the column `id`. `crs` is the coordinate system, as in `25832` or `"EPSG:25832"`; without it, coordinates are degrees.
///
/// `lod` has levels of detail for far away, as in `["Block@8"]`. `tile_lots` is the most lots of a near tile, `tile_size` the most kilobytes of a
/// tile, `unit_lots` the most lots of a unit, the work of one call of `make`. Rules find other lots up to `occlusion_distance` (1 m) and
/// `context_distance` (100 m).
///
/// A city can be pickled. The folder and the assets must be the same on all machines.
#[pyclass(frozen, module = "pycga")]
#[derive(Debug)]
pub(crate) struct City {
    work: Arc<CityWork>,
}

/// A city, as its plan knows it.
#[derive(Debug)]
pub(crate) struct CityWork {
    pub(crate) loaded: LoadedWork,
    pub(crate) store: Folder,
    geometry: String,
    unit_lots: u64,
}

#[pymethods]
impl City {
    #[new]
    #[pyo3(signature = (folder, rules, *, attributes=None, columns=None, name=None, grammar_column=None, start_column=None, geometry="geometry", crs=None, lod=None, occlusion_distance=None, context_distance=None, tile_lots=256, tile_size=4096, unit_lots=65_536))]
    #[expect(clippy::too_many_arguments, reason = "keywords of Python")]
    fn new(
        py: Python<'_>,
        folder: PathBuf,
        rules: &Bound<'_, PyAny>,
        attributes: Option<&Bound<'_, PyMapping>>,
        columns: Option<&Bound<'_, PyDict>>,
        name: Option<String>,
        grammar_column: Option<String>,
        start_column: Option<String>,
        geometry: &str,
        crs: Option<&Bound<'_, PyAny>>,
        lod: Option<Vec<String>>,
        occlusion_distance: Option<f64>,
        context_distance: Option<f64>,
        tile_lots: u64,
        tile_size: u64,
        unit_lots: u64,
    ) -> PyResult<Self> {
        let files = rule_files(rules)?;
        let distances = [("occlusion_distance", occlusion_distance), ("context_distance", context_distance)];
        let (values, attributes) = (values(&files, attributes)?, attribute_columns(columns)?);
        let work = Work {
            rules: texts(&files),
            compiled: Vec::new(),
            assets: assets(&files)?,
            values,
            columns: Columns { id: name, grammar: grammar_column, start: start_column, attributes, footing: None },
            crs: self::crs(crs)?,
            options: options(&lod.unwrap_or_default(), tile_lots, tile_size, distances)?,
        };
        let city = CityWork::new(py, work, absolute(&folder)?, geometry.to_owned(), unit_lots)?;
        check_names(&files, &city.loaded)?;
        let attributes = city.loaded.work.columns.attributes.iter().map(|(_, name)| name.as_str());
        city.loaded.rules.check_attributes(attributes).map_err(AttributeValueError::new_err)?;
        begin(&city.store, &folder.display().to_string()).map_err(CityError::new_err)?;
        Ok(City { work: Arc::new(city) })
    }

    /// Loads a city that was pickled.
    #[staticmethod]
    #[pyo3(name = "_rebuild")]
    fn rebuild(py: Python<'_>, work: &[u8], folder: PathBuf, geometry: String, unit_lots: u64) -> PyResult<Self> {
        let work = serde_json::from_slice(work).map_err(|why| CityError::new_err(why.to_string()))?;
        Ok(City { work: Arc::new(CityWork::new(py, work, folder, geometry, unit_lots)?) })
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyAny>, Rebuilt<'py>)> {
        let CityWork { loaded, store, geometry, unit_lots } = &*self.work;
        let work = serde_json::to_vec(&loaded.work).map_err(|why| CityError::new_err(why.to_string()))?;
        let rebuild = py.get_type::<City>().getattr("_rebuild")?;
        Ok((rebuild, (PyBytes::new(py, &work), store.0.clone(), geometry.clone(), *unit_lots)))
    }

    /// Counts the lots of a batch of rows, and returns the counts as bytes.
    ///
    /// `table` is a table of Arrow. Rows and values that cannot be used are written to the folder, in `failures/rows`.
    fn count<'py>(&self, py: Python<'py>, table: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyBytes>> {
        let (city, batches) = (&*self.work, ArrowTable::batches_of(table)?);
        let count = || -> Result<Vec<u8>, String> {
            let rows = city.rows(&batches)?;
            let counts = Counts::of(&city.loaded, rows.iter().flat_map(Rows::iter), &city.store)?;
            Ok(counts.to_bytes())
        };
        guarded(py, count)?.map(|counts| PyBytes::new(py, &counts)).map_err(CityError::new_err)
    }

    /// Plans the units of the city, from the counts of all batches in any order. One process calls it.
    fn plan(&self, py: Python<'_>, counts: &Bound<'_, PyAny>) -> PyResult<CityPlan> {
        let mut all = Counts::default();
        for counts in counts.try_iter()? {
            let counts: PyBackedBytes = counts?.extract()?;
            all.add(Counts::from_bytes(&counts).map_err(CityError::new_err)?).map_err(CityError::new_err)?;
        }
        let (city, failed) = (self.work.clone(), all.failed());
        let plan = || {
            let plan = all.plan(&city.loaded, city.unit_lots)?;
            keep_failed(&city.store, &failed).map_err(|why| format!("cannot delete old files: {why}"))?;
            if plan.units.is_empty() {
                return Err("the city is empty: no row has a polygon that can be used; the reasons are in `failures`"
                    .to_owned());
            }
            delete_old_files(&city.store, &plan, &[])?;
            Ok(plan)
        };
        let plan = guarded(py, plan)?.map_err(CityError::new_err)?;
        Ok(CityPlan::new(city, plan, [failed.lines(), failed.lost()]))
    }

    fn __repr__(&self) -> String {
        format!("<City {:?}>", self.work.store.0)
    }
}

/// The arguments of `_rebuild`.
type Rebuilt<'py> = (Bound<'py, PyBytes>, PathBuf, String, u64);

impl City {
    /// The city of a plan.
    pub(crate) fn of(work: Arc<CityWork>) -> Self {
        City { work }
    }

    pub(crate) fn work(&self) -> &Arc<CityWork> {
        &self.work
    }
}

impl CityWork {
    fn new(py: Python<'_>, work: Work, folder: PathBuf, geometry: String, unit_lots: u64) -> PyResult<Self> {
        let loaded = guarded(py, || LoadedWork::new(work))?.map_err(CityError::new_err)?;
        Ok(CityWork { loaded, store: Folder(folder), geometry, unit_lots: unit_lots.max(1) })
    }

    /// The rows of batches.
    ///
    /// # Errors
    /// A sentence about a column.
    pub(crate) fn rows(&self, batches: &[RecordBatch]) -> Result<Vec<Rows>, String> {
        let wanted = self.loaded.column_names();
        let rows = |batch: &RecordBatch| {
            let known = arrow::names(&batch.schema());
            if let Some((_, name)) =
                self.loaded.work.columns.named().find(|(_, name)| !known.iter().any(|own| own == name))
            {
                let known = known.iter().map(String::as_str).filter(|own| *own != self.geometry);
                let known = missing::names(name, "the table", "columns", known);
                return Err(format!("the table has no column `{name}`; {known}"));
            }
            Rows::of_batch(batch, &self.geometry, &wanted)
        };
        batches.iter().map(rows).collect()
    }
}
