//! Rows of tables and of collections: lots, or the reason why they are missing.

use std::collections::BTreeSet;

use cga::{Attribute, Grammar, RuleFile, Shape as Initial, Value, ValueType};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::errors::AttributeValueError;
use crate::geometry::{geo_json, geo_object, geo_type, member, outlines};
use crate::outline::{Origin, Outline};
use crate::proposal::proposal;
use crate::shape::Shape;
use crate::value::{coerced, elements, from_python};

/// A lot that has not been run.
pub(crate) struct Draft {
    pub(crate) initial: Initial,
    /// The seed that the program has given it.
    pub(crate) own_seed: Option<u64>,
    /// The seed that follows from its name.
    pub(crate) name_seed: Option<u64>,
}

/// A row: a lot for each of its polygons.
pub(crate) struct Row {
    pub(crate) name: String,
    pub(crate) lots: Result<Vec<Result<Draft, String>>, String>,
}

/// The columns of a row that its lots use.
pub(crate) struct Columns {
    pub(crate) geometry: String,
    /// The column of names.
    pub(crate) name: Option<String>,
    /// The attributes, each with its type and its column.
    pub(crate) attributes: Vec<(String, ValueType, String)>,
    pub(crate) origin: Origin,
}

impl Columns {
    /// Each attribute of the rules has the column of its name, or the column that `renamed` has for it.
    ///
    /// # Errors
    /// `renamed` has the name of something else.
    pub(crate) fn new(
        rules: &RuleFile,
        geometry: String,
        name: Option<String>,
        renamed: Option<&Bound<'_, PyDict>>,
        origin: Origin,
    ) -> PyResult<Self> {
        let own = |row: &Attribute| (row.name.to_string(), row.ty, row.name.to_string());
        let mut attributes: Vec<_> = rules.attributes().iter().map(own).collect();
        for (attribute, column) in renamed.into_iter().flatten() {
            let (attribute, column): (String, String) = (attribute.extract()?, column.extract()?);
            match attributes.iter_mut().find(|(name, ..)| *name == attribute) {
                Some(found) => found.2 = column,
                None => {
                    let why = rules.get(&attribute).map_or_else(|why| why.to_string(), |_| String::new());
                    return Err(AttributeValueError::new_err(why));
                }
            }
        }
        Ok(Columns { geometry, name, attributes, origin })
    }

    /// A row with the values of its attributes.
    pub(crate) fn row(&self, name: String, outlines: Result<Vec<Outline>, String>, values: &[(&str, Value)]) -> Row {
        let draft = |(part, outline): (usize, &Outline)| {
            let mut initial = outline.shape(self.origin, None)?;
            for (attribute, value) in values {
                initial = initial.attribute(*attribute, value.clone());
            }
            let name_seed = if name.is_empty() { None } else { Some(name_seed(&name, part)) };
            let initial = if name.is_empty() { initial } else { initial.named(name.as_str()) };
            Ok(Draft { initial, own_seed: None, name_seed })
        };
        let lots = outlines.map(|outlines| outlines.iter().enumerate().map(draft).collect());
        Row { name, lots }
    }

    /// The row of a feature of GeoJSON.
    fn feature(&self, object: &Bound<'_, PyDict>) -> Row {
        match self.values_of(object) {
            Ok((name, values)) => self.row(name, geo_json(object), &values),
            Err(why) => Row { name: String::new(), lots: Err(why) },
        }
    }

    fn values_of(&self, object: &Bound<'_, PyDict>) -> Result<Named<'_>, String> {
        let properties = member(object, "properties")?;
        let properties = properties.as_ref().and_then(|properties| properties.cast::<PyDict>().ok());
        let property = |name: &str| properties.map_or(Ok(None), |properties| member(properties, name));
        let name = match &self.name {
            Some(column) => property(column)?,
            None => member(object, "id")?,
        };
        let name = name.map_or(Ok(String::new()), |name| name.str().and_then(|name| name.extract::<String>()));
        let mut values = Vec::new();
        for (attribute, ty, column) in &self.attributes {
            if let Some(given) = property(column)? {
                let value = from_python(&given, Some(*ty)).map_err(|why| format!("property `{column}`: {why}"))?;
                values.push((attribute.as_str(), coerced(value, *ty)));
            }
        }
        Ok((name.map_err(|why| why.to_string())?, values))
    }
}

/// The name of a row, and the values of its attributes.
type Named<'c> = (String, Vec<(&'c str, Value)>);

/// The features of a collection: an object of GeoJSON, its text, or an object with such an interface. `None` for other objects.
pub(crate) fn features<'py>(given: &Bound<'py, PyAny>) -> Result<Option<Vec<Bound<'py, PyAny>>>, String> {
    let Some(object) = geo_object(given)? else { return Ok(None) };
    match geo_type(&object)?.as_str() {
        "FeatureCollection" => {
            let features = member(&object, "features")?.and_then(|list| elements(&list));
            features.map(Some).ok_or_else(|| "a FeatureCollection needs the member `features`".to_owned())
        }
        _ => Ok(Some(vec![object.into_any()])),
    }
}

/// Checks the properties that a call names. Features may leave them out, but a property that no feature has is misspelt.
///
/// # Errors
/// A sentence about a property.
pub(crate) fn check_properties(features: &[Bound<'_, PyAny>], columns: &Columns) -> Result<(), String> {
    let renamed = columns.attributes.iter().filter(|(attribute, _, column)| attribute != column);
    let named = renamed.map(|(_, _, column)| column).chain(&columns.name);
    let properties = features.iter().filter_map(|feature| {
        let properties = feature.cast::<PyDict>().ok()?.get_item("properties").ok()??;
        properties.cast_into::<PyDict>().ok()
    });
    let properties: Vec<Bound<'_, PyDict>> = properties.collect();
    for name in named {
        if properties.is_empty() || properties.iter().any(|own| own.contains(name).unwrap_or(true)) {
            continue;
        }
        let mut known = BTreeSet::new();
        for own in properties.iter().take(MOST_FEATURES) {
            known.extend(own.keys().iter().filter_map(|name| name.extract::<String>().ok()));
        }
        let known = proposal(name, "properties", known.iter().map(String::as_str));
        return Err(format!("no feature has the property `{name}`; {known}"));
    }
    Ok(())
}

/// The most features whose properties are listed in a message.
const MOST_FEATURES: usize = 1000;

/// The row of an element of a list: a `Shape`, a feature, or a geometry.
pub(crate) fn row_of(given: &Bound<'_, PyAny>, columns: &Columns) -> Row {
    if let Ok(shape) = given.cast::<Shape>() {
        let Shape { initial, own_seed } = shape.get();
        let draft = Draft { initial: initial.clone(), own_seed: *own_seed, name_seed: None };
        return Row { name: initial.name().to_owned(), lots: Ok(vec![Ok(draft)]) };
    }
    match given.cast::<PyDict>() {
        Ok(object) if geo_type(object).is_ok_and(|kind| kind == "Feature") => columns.feature(object),
        _ => columns.row(String::new(), outlines(given), &[]),
    }
}

/// The seed of a polygon of a named row. It does not depend on other rows, and it is the seed that `cga-city` gives the lot.
fn name_seed(name: &str, part: usize) -> u64 {
    let mut hasher = blake3::Hasher::new();
    hasher.update(name.as_bytes()).update(&(part as u64).to_le_bytes());
    let [a, b, c, d, e, f, g, h, ..] = *hasher.finalize().as_bytes();
    u64::from_le_bytes([a, b, c, d, e, f, g, h])
}
