//! Rules that Python programs load and run.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use cga::{Assets, Grammar, RuleFile as Rules, RuleFileError, RuleLoader, Watch};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyMapping};

use crate::attribute::{Attribute, StartRule};
use crate::call::Call;
use crate::diagnostic::{Diagnostic, rule_error};
use crate::errors::{AttributeValueError, RunError, late, run_error};
use crate::jobs::{Done, in_pool, jobs, run_all, threads_of};
use crate::model::Model;
use crate::models::Models;
use crate::rows::Columns;
use crate::run::supervised;
use crate::shape::lot;
use crate::source::Source;

/// Rules of a file. They never change; `generate` takes the values of attributes.
///
/// `name` is the name of the grammar, by default the name of the file without its ending. `imports` has texts of rule files by name, in place
/// of files on the disk. `assets` is the folder of the meshes and images that the rules insert. Rules are not read outside of `root`.
///
/// Rules can be pickled. The copy is made from the texts, so the files need not exist there; the folder of assets must.
#[pyclass(frozen, module = "pycga")]
#[derive(Debug)]
pub(crate) struct RuleFile {
    rules: Rules,
    assets: Arc<Assets>,
    folder: Option<PathBuf>,
}

type Texts = BTreeMap<String, String>;

#[pymethods]
impl RuleFile {
    #[new]
    #[pyo3(signature = (path, *, name=None, imports=None, assets=None, root=None))]
    fn new(
        py: Python<'_>,
        path: PathBuf,
        name: Option<String>,
        imports: Option<Texts>,
        assets: Option<PathBuf>,
        root: Option<PathBuf>,
    ) -> PyResult<Self> {
        let mut loader = loader(imports.unwrap_or_default());
        if let Some(name) = name {
            loader = loader.named(name);
        }
        if let Some(root) = root {
            loader = loader.root(root);
        }
        RuleFile::load(py, assets, || loader.open(&path))
    }

    /// Rules from text. `name` is the name of the grammar, and of the file in messages. `imports` has the texts of imported files by name.
    #[staticmethod]
    #[pyo3(signature = (text, *, name="rules", imports=None, assets=None))]
    fn from_text(
        py: Python<'_>,
        text: String,
        name: &str,
        imports: Option<Texts>,
        assets: Option<PathBuf>,
    ) -> PyResult<Self> {
        let file = format!("{name}.cga");
        let mut texts = imports.unwrap_or_default();
        if texts.insert(file.clone(), text).is_some() {
            return Err(PyValueError::new_err(format!(
                "`{file}` is also the name of an import; give the rules another `name`"
            )));
        }
        RuleFile::rebuild(py, name.to_owned(), file, texts, assets)
    }

    /// Loads rules that were pickled.
    #[staticmethod]
    #[pyo3(name = "_rebuild")]
    fn rebuild(py: Python<'_>, name: String, file: String, texts: Texts, assets: Option<PathBuf>) -> PyResult<Self> {
        let loader = loader(texts).named(name);
        RuleFile::load(py, assets, || loader.memory_file(&file))
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyAny>, Rebuilt)> {
        let rebuild = py.get_type::<RuleFile>().getattr("_rebuild")?;
        let texts = self.texts();
        Ok((rebuild, (self.rules.name().to_owned(), self.rules.file().to_owned(), texts, self.folder.clone())))
    }

    /// The name of the grammar.
    #[getter]
    fn name(&self) -> &str {
        self.rules.name()
    }

    /// The description of the rules.
    #[getter]
    fn about(&self) -> &str {
        self.rules.about()
    }

    /// The attributes by name, in the order of the rules.
    #[getter]
    fn attributes<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let attributes = PyDict::new(py);
        for row in self.rules.attributes() {
            attributes.set_item(row.name.as_str(), Attribute::new(py, &self.rules, row)?)?;
        }
        Ok(attributes)
    }

    /// The rules that a run can start with. The first is the default.
    #[getter]
    fn start_rules(&self) -> Vec<StartRule> {
        self.rules.start_rules().iter().map(StartRule::from).collect()
    }

    /// The warnings about the rules.
    #[getter]
    fn warnings(&self) -> Vec<Diagnostic> {
        self.rules.warning_details().iter().map(Diagnostic::from).collect()
    }

    /// The texts of the rule file and of its imports, by name.
    #[getter]
    fn texts(&self) -> Texts {
        self.rules.texts().map(|(name, text)| (name.to_owned(), text.to_owned())).collect()
    }

    /// Runs the rules on a lot and returns the model. `shape` is a `Shape`, or a geometry with one polygon, as `Shape` takes it.
    ///
    /// `attributes` has values by name; the values of the shape win over them. `seed` is the seed of random numbers, in place of the shape's.
    /// `start` is the start rule, `limits` has limits by name, such as `{"shapes": 100_000}`, and `deadline` ends the run after some
    /// seconds. Ctrl-C ends a run, too. Other threads of Python go on meanwhile.
    #[pyo3(signature = (shape, *, attributes=None, seed=None, start=None, limits=None, deadline=None, origin=None))]
    #[expect(clippy::too_many_arguments, reason = "keywords of Python")]
    fn generate(
        &self,
        py: Python<'_>,
        shape: &Bound<'_, PyAny>,
        attributes: Option<&Bound<'_, PyMapping>>,
        seed: Option<u64>,
        start: Option<String>,
        limits: Option<&Bound<'_, PyMapping>>,
        deadline: Option<f64>,
        origin: Option<(f64, f64)>,
    ) -> PyResult<Model> {
        let call = Call::new(&self.rules, &self.assets, attributes, start, limits, deadline)?;
        let (initial, own) = lot(shape, origin.unwrap_or_default().into())?;
        let initial = call.lot(&self.rules, initial.seed(seed.or(own).unwrap_or_default()));
        let run = || self.rules.generate_with(&initial, &call.settings);
        let model = supervised(py, &call.watch, run)?.map_err(|why| run_error(py, &why))?;
        match model.report().stopped {
            true => Err(late(py, call.deadline.unwrap_or_default())),
            false => Ok(Model::new(model, 0, 0)),
        }
    }

    /// Runs the rules on many lots with several threads. Lots that cannot be built are in `failures` of the result.
    ///
    /// `lots` is a list of shapes and geometries, a FeatureCollection of GeoJSON, an object with `__geo_interface__`, or a table of Arrow: any
    /// object with `__arrow_c_stream__` and a column `geometry` of WKB. Columns and properties with the names of attributes set them; `columns`
    /// has other columns by attribute. A value that its attribute cannot have is a fault of the model. `name` is the column of names; without
    /// it features have their ids. Each polygon of a geometry is a lot.
    ///
    /// The seed of a lot is its own one. Otherwise seeds count on from `seed`; without `seed` they follow from names, so other rows do not
    /// matter, and lots without names have their numbers. The models of all lots are kept in memory: give very large tables in parts.
    #[pyo3(signature = (lots, *, attributes=None, seed=None, start=None, limits=None, deadline=None, threads=None, origin=None, geometry="geometry", name=None, columns=None))]
    #[expect(clippy::too_many_arguments, reason = "keywords of Python")]
    fn generate_all(
        &self,
        py: Python<'_>,
        lots: &Bound<'_, PyAny>,
        attributes: Option<&Bound<'_, PyMapping>>,
        seed: Option<u64>,
        start: Option<String>,
        limits: Option<&Bound<'_, PyMapping>>,
        deadline: Option<f64>,
        threads: Option<usize>,
        origin: Option<(f64, f64)>,
        geometry: &str,
        name: Option<String>,
        columns: Option<&Bound<'_, PyDict>>,
    ) -> PyResult<Models> {
        let rules = &self.rules;
        let threads = threads_of(threads)?;
        let columns = Columns::new(rules, geometry.to_owned(), name, columns, origin.unwrap_or_default().into())?;
        let mut call = Call::new(rules, &self.assets, attributes, start, limits, deadline)?;
        let source = Source::of(lots, &columns)?;
        if source.has_columns {
            call = call.with_wrong_values();
        }
        let Source { rows, table, .. } = source;
        let (call, columns) = (&call, &columns);
        let work = move || {
            call.check(rules).map_err(Refused::Run)?;
            let all = move || {
                let rows = match &table {
                    Some(table) => table.rows(columns)?,
                    None => rows,
                };
                Ok(run_all(jobs(rows, seed, rules, call), rules, call))
            };
            in_pool(threads, all).map_err(Refused::Threads)?.map_err(Refused::Column)
        };
        let done: Vec<Done> = supervised(py, &call.watch, work)?.map_err(|refused| match refused {
            Refused::Run(why) => run_error(py, &why),
            Refused::Column(why) => AttributeValueError::new_err(why),
            Refused::Threads(why) => RunError::new_err(why),
        })?;
        Models::new(py, done)
    }

    fn __repr__(&self) -> String {
        format!("<RuleFile {:?}>", self.rules.name())
    }
}

/// The arguments of `_rebuild`.
type Rebuilt = (String, String, Texts, Option<PathBuf>);

impl RuleFile {
    /// The rules.
    pub(crate) fn rules(&self) -> &Rules {
        &self.rules
    }

    /// The folder of the meshes and images that the rules insert.
    pub(crate) fn assets_folder(&self) -> Option<&Path> {
        self.folder.as_deref()
    }

    fn load(
        py: Python<'_>,
        folder: Option<PathBuf>,
        load: impl FnOnce() -> Result<Rules, RuleFileError> + Send,
    ) -> PyResult<Self> {
        if let Some(folder) = folder.as_ref().filter(|folder| !folder.is_dir()) {
            return Err(PyValueError::new_err(format!("the folder of assets `{}` does not exist", folder.display())));
        }
        let rules = supervised(py, &Watch::new(), load)?.map_err(|why| rule_error(py, &why))?;
        let assets = Arc::new(folder.as_ref().map_or_else(Assets::new, Assets::below));
        Ok(RuleFile { rules, assets, folder })
    }
}

fn loader(imports: Texts) -> RuleLoader {
    imports.into_iter().fold(RuleLoader::new(), |loader, (name, text)| loader.with_file(name, text))
}

/// The reason why a call ends before its first lot.
enum Refused {
    Run(cga::Error),
    Column(String),
    Threads(String),
}
