//! The choices of a city, from the arguments of Python.

use std::path::{Path, PathBuf};

use cga::{Array, Grammar as _, RuleFile as Rules, Text, Value, ValueType};
use cga_city::build::Options;
use cga_city::surroundings::{Distances, MOST_DISTANCE};
use cga_city::units::work::{LoadedWork, RuleTexts};
use cga_geo::crs::{Crs, WGS_84};
use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyMapping};

use crate::call::items;
use crate::errors::AttributeValueError;
use crate::rule_file::RuleFile;
use crate::value::{elements, from_python, type_name};

/// The rules of a city: a `RuleFile`, or a list of several.
pub(crate) fn rule_files<'py>(given: &Bound<'py, PyAny>) -> PyResult<Vec<Bound<'py, RuleFile>>> {
    let list = elements(given).unwrap_or_else(|| vec![given.clone()]);
    let file = |one: &Bound<'py, PyAny>| {
        let wrong = || format!("{} is not a RuleFile; write `pycga.RuleFile(\"house.cga\")`", type_name(one));
        one.cast::<RuleFile>().cloned().map_err(|_| PyTypeError::new_err(wrong()))
    };
    list.iter().map(file).collect()
}

/// The texts of rule files.
pub(crate) fn texts(files: &[Bound<'_, RuleFile>]) -> Vec<RuleTexts> {
    let texts = |file: &Bound<'_, RuleFile>| {
        let rules = file.get().rules();
        let texts = rules.texts().map(|(name, text)| (name.to_owned(), text.to_owned())).collect();
        RuleTexts { file: rules.file().to_owned(), texts }
    };
    files.iter().map(texts).collect()
}

/// The folder of assets of rule files.
///
/// # Errors
/// A `ValueError` for files with different folders.
pub(crate) fn assets(files: &[Bound<'_, RuleFile>]) -> PyResult<Option<PathBuf>> {
    let mut folders = files.iter().filter_map(|file| file.get().assets_folder());
    let Some(first) = folders.next() else { return Ok(None) };
    if folders.any(|other| other != first) {
        return Err(PyValueError::new_err("the rules of a city have one folder of assets; give all of them the same"));
    }
    absolute(first).map(Some)
}

/// The path as other processes know it.
pub(crate) fn absolute(path: &Path) -> PyResult<PathBuf> {
    std::path::absolute(path).map_err(|why| PyValueError::new_err(format!("`{}`: {why}", path.display())))
}

/// Checks that rules have the names of their files, as a copy on another machine has them.
///
/// # Errors
/// A `ValueError` for rules with another name.
pub(crate) fn check_names(files: &[Bound<'_, RuleFile>], work: &LoadedWork) -> PyResult<()> {
    for (file, grammar) in files.iter().zip(work.rules.grammars()) {
        let given = file.get().rules().name();
        if given != grammar.name() {
            return Err(PyValueError::new_err(format!(
                "the rules `{given}` of a city have the name of their file, `{}`; load them without `name`",
                grammar.name()
            )));
        }
    }
    Ok(())
}

/// The names of attributes and the texts of their values, by name.
///
/// # Errors
/// An `AttributeValueError` for an object that is not a value.
pub(crate) fn values(
    files: &[Bound<'_, RuleFile>],
    attributes: Option<&Bound<'_, PyMapping>>,
) -> PyResult<Vec<(String, String)>> {
    let mut values = Vec::new();
    for (name, given) in items(attributes)?.into_iter().filter(|(_, given)| !given.is_none()) {
        let kind = files.iter().find_map(|file| kind_of(file.get().rules(), &name));
        let value = from_python(&given, kind);
        let value = value.map_err(|why| AttributeValueError::new_err(format!("attribute `{name}`: {why}")))?;
        values.push((name, text_of(&value)));
    }
    values.sort();
    Ok(values)
}

/// The text of a value, as rules read it. The language prints numbers with fewer digits, and texts of arrays without quotes.
fn text_of(value: &Value) -> String {
    fn rows<T>(array: &Array<T>, element: impl Fn(&T) -> String) -> String {
        let row = |row: &[T]| row.iter().map(&element).collect::<Vec<_>>().join(", ");
        format!("[{}]", array.iter_rows().map(row).collect::<Vec<_>>().join("; "))
    }
    let quoted = |text: &Text| format!("\"{}\"", text.replace('\\', "\\\\").replace('"', "\\\""));
    match value {
        Value::Float(number) => number.to_string(),
        Value::Floats(array) => rows(array, f64::to_string),
        Value::Bools(array) => rows(array, bool::to_string),
        Value::Texts(array) => rows(array, quoted),
        other => other.to_string(),
    }
}

fn kind_of(rules: &Rules, name: &str) -> Option<ValueType> {
    rules.attributes().iter().find(|attribute| attribute.name.is(name)).map(|attribute| attribute.ty)
}

/// Columns and the attributes that they set, by column.
pub(crate) fn attribute_columns(columns: Option<&Bound<'_, PyDict>>) -> PyResult<Vec<(String, String)>> {
    let mut pairs = Vec::new();
    for (attribute, column) in columns.into_iter().flatten() {
        pairs.push((column.extract()?, attribute.extract()?));
    }
    pairs.sort();
    Ok(pairs)
}

/// The code of a coordinate system: a number, or a text such as `EPSG:25832`.
///
/// # Errors
/// A `ValueError` for a system that is not known.
pub(crate) fn crs(given: Option<&Bound<'_, PyAny>>) -> PyResult<u32> {
    let Some(given) = given else { return Ok(WGS_84) };
    let crs = match given.extract::<u32>() {
        Ok(code) => Crs::from_epsg(code),
        Err(_) => given.str()?.to_str()?.parse(),
    };
    crs.map(|crs| crs.code()).map_err(|why| PyValueError::new_err(format!("crs: {why}")))
}

/// The sizes and the levels of tiles.
///
/// # Errors
/// A `ValueError` for a level that cannot be read, or a distance that is too long.
pub(crate) fn options(
    lod: &[String],
    tile_lots: u64,
    tile_size: u64,
    distances: [(&str, Option<f64>); 2],
) -> PyResult<Options> {
    let level = |text: &String| text.parse().map_err(|why| PyValueError::new_err(format!("lod: {why}")));
    let (usual, near) = (Options::default(), Distances::default());
    let distance = |(name, metres): (&str, Option<f64>), usual: f64| {
        let metres = metres.unwrap_or(usual);
        let why = || PyValueError::new_err(format!("{name}: a distance is from 0 to {MOST_DISTANCE} metres"));
        (0.0..=MOST_DISTANCE).contains(&metres).then_some(metres).ok_or_else(why)
    };
    let [occlusion, context] = distances;
    let neighbours =
        Distances { occlusion: distance(occlusion, near.occlusion)?, context: distance(context, near.context)? };
    Ok(Options {
        levels: lod.iter().map(level).collect::<PyResult<_>>()?,
        lots_per_tile: tile_lots.max(1),
        most_bytes: tile_size.max(1).saturating_mul(1 << 10),
        neighbours: Some(neighbours),
        ..usual
    })
}
