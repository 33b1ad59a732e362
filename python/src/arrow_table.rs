//! Tables of Arrow: their columns are borrowed, and rows become lots without the interpreter lock.

use std::panic::{AssertUnwindSafe, catch_unwind};

use arrow_array::cast::AsArray;
use arrow_array::types::Float64Type;
use arrow_array::{Array as _, ArrayRef, BooleanArray, Float64Array, LargeListArray, LargeStringArray, RecordBatch};
use arrow_cast::cast;
use arrow_schema::{DataType, Field, SchemaRef};
use cga::{Array, Text, Value, ValueType};
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::PyCapsule;
use pyo3_arrow::{PyRecordBatchReader, PyTable};
use rayon::prelude::*;

use crate::errors::panicked;
use crate::outline::Outline;
use crate::proposal::proposal;
use crate::rows::{Columns, Row};
use crate::value::{coerced, type_name};
use crate::wkb;

/// A table with a column of WKB.
pub(crate) struct ArrowTable {
    batches: Vec<RecordBatch>,
}

impl ArrowTable {
    /// The table of an object with `__arrow_c_stream__`; `None` for other objects.
    pub(crate) fn of(given: &Bound<'_, PyAny>) -> PyResult<Option<Self>> {
        // The stream of a GeoDataFrame itself is the stream of pandas, which knows no geometries.
        let given = match (given.getattr_opt("__geo_interface__").ok().flatten(), given.getattr_opt("to_arrow")?) {
            (Some(_), Some(to_arrow)) => to_arrow.call0()?,
            _ => given.clone(),
        };
        if given.getattr_opt("__arrow_c_stream__")?.is_none() {
            return Ok(None);
        }
        let wrong = |why: PyErr| {
            let why =
                format!("{} is not a table of Arrow ({why}); give a table with a column of WKB", type_name(&given));
            PyTypeError::new_err(why)
        };
        let reader = || given.extract::<PyRecordBatchReader>().map_err(wrong);
        let read = || Ok::<_, PyErr>(reader()?.into_table()?.into_inner());
        let (batches, _) = catch_unwind(AssertUnwindSafe(read)).map_err(|_| panicked(given.py()))??;
        Ok(Some(ArrowTable { batches }))
    }

    /// The batches of a table.
    ///
    /// # Errors
    /// A `TypeError` for another object.
    pub(crate) fn batches_of(given: &Bound<'_, PyAny>) -> PyResult<Vec<RecordBatch>> {
        let table = ArrowTable::of(given)?.map(|table| table.batches);
        table.ok_or_else(|| PyTypeError::new_err(format!("{} is not a table of Arrow", type_name(given))))
    }

    /// The rows, in order.
    ///
    /// # Errors
    /// A sentence about a column.
    pub(crate) fn rows(&self, columns: &Columns) -> Result<Vec<Row>, String> {
        let mut rows = Vec::new();
        for batch in &self.batches {
            let batch = Batch::new(batch, columns)?;
            rows.par_extend((0..batch.count).into_par_iter().map(|at| batch.row(at, columns)));
        }
        Ok(rows)
    }
}

/// The stream of batches in the Arrow PyCapsule interface.
///
/// # Errors
/// The batches do not have the columns of the schema.
pub(crate) fn stream<'py>(
    py: Python<'py>,
    batches: Vec<RecordBatch>,
    schema: SchemaRef,
    requested: Option<Bound<'py, PyCapsule>>,
) -> PyResult<Bound<'py, PyAny>> {
    PyTable::try_new(batches, schema)?.into_pyobject(py)?.call_method1("__arrow_c_stream__", (requested,))
}

/// The columns of a batch that lots use.
struct Batch<'b> {
    count: usize,
    geometry: &'b ArrayRef,
    names: Option<LargeStringArray>,
    values: Vec<(&'b str, ValueType, Cells)>,
}

impl<'b> Batch<'b> {
    fn new(batch: &'b RecordBatch, columns: &'b Columns) -> Result<Self, String> {
        let schema = batch.schema();
        let column = |name: &str| batch.column_by_name(name).ok_or_else(|| missing(name, &schema));
        let geometry = column(&columns.geometry)?;
        if !matches!(geometry.data_type(), DataType::Binary | DataType::LargeBinary | DataType::BinaryView) {
            return Err(format!("the column `{}` is {}, and not WKB", columns.geometry, geometry.data_type()));
        }
        let names = columns.name.as_deref().map(|name| texts(name, column(name)?)).transpose()?;
        let mut values = Vec::new();
        for (attribute, ty, name) in &columns.attributes {
            match batch.column_by_name(name) {
                Some(array) => values.push((attribute.as_str(), *ty, Cells::new(name, array)?)),
                // A column that was named must exist.
                None if attribute != name => return Err(missing(name, &schema)),
                None => {}
            }
        }
        Ok(Batch { count: batch.num_rows(), geometry, names, values })
    }

    fn row(&self, at: usize, columns: &Columns) -> Row {
        let names = self.names.as_ref().filter(|names| names.is_valid(at));
        let name = names.map_or_else(String::new, |names| names.value(at).to_owned());
        let values: Vec<(&str, Value)> = self
            .values
            .iter()
            .filter_map(|(attribute, ty, cells)| Some((*attribute, coerced(cells.value(at)?, *ty))))
            .collect();
        columns.row(name, self.outlines(at), &values)
    }

    fn outlines(&self, at: usize) -> Result<Vec<Outline>, String> {
        if self.geometry.is_null(at) {
            return Err("it has no geometry".to_owned());
        }
        wkb::outlines(match self.geometry.data_type() {
            DataType::Binary => self.geometry.as_binary::<i32>().value(at),
            DataType::LargeBinary => self.geometry.as_binary::<i64>().value(at),
            _ => self.geometry.as_binary_view().value(at),
        })
    }
}

fn missing(name: &str, schema: &SchemaRef) -> String {
    let known = schema.fields().iter().map(|field| field.name().as_str());
    format!("the table has no column `{name}`; {}", proposal(name, "columns", known))
}

/// A column of values.
enum Cells {
    Numbers(Float64Array),
    Truths(BooleanArray),
    Texts(LargeStringArray),
    Lists(LargeListArray),
}

impl Cells {
    fn new(name: &str, array: &ArrayRef) -> Result<Self, String> {
        let unusable = || format!("the column `{name}` is {}, which no attribute can have", array.data_type());
        match array.data_type() {
            DataType::Boolean => Ok(Cells::Truths(array.as_boolean().clone())),
            DataType::List(field) | DataType::LargeList(field) | DataType::FixedSizeList(field, _) => {
                let element = match field.data_type() {
                    DataType::Boolean => DataType::Boolean,
                    number if is_number(number) => DataType::Float64,
                    _ => DataType::LargeUtf8,
                };
                let list = DataType::LargeList(Field::new("item", element, true).into());
                let list = cast(array, &list).map_err(|_| unusable())?;
                Ok(Cells::Lists(list.as_list::<i64>().clone()))
            }
            number if is_number(number) => {
                let numbers = cast(array, &DataType::Float64).map_err(|_| unusable())?;
                Ok(Cells::Numbers(numbers.as_primitive::<Float64Type>().clone()))
            }
            DataType::Struct(_) | DataType::Map(..) | DataType::Union(..) => Err(unusable()),
            _ => texts(name, array).map(Cells::Texts),
        }
    }

    /// The value of a row; `None` for null.
    fn value(&self, at: usize) -> Option<Value> {
        match self {
            Cells::Numbers(cells) => cells.is_valid(at).then(|| Value::Float(cells.value(at))),
            Cells::Truths(cells) => cells.is_valid(at).then(|| Value::Bool(cells.value(at))),
            Cells::Texts(cells) => cells.is_valid(at).then(|| Value::from(cells.value(at))),
            Cells::Lists(cells) => cells.is_valid(at).then(|| list(&cells.value(at))),
        }
    }
}

/// The elements of a list; null is NaN, false or empty.
fn list(elements: &ArrayRef) -> Value {
    match elements.data_type() {
        DataType::Float64 => {
            let numbers = elements.as_primitive::<Float64Type>();
            numbers.iter().map(|number| number.unwrap_or(f64::NAN)).collect::<Array<f64>>().into()
        }
        DataType::Boolean => {
            elements.as_boolean().iter().map(Option::unwrap_or_default).collect::<Array<bool>>().into()
        }
        _ => {
            let texts = elements.as_string::<i64>();
            texts.iter().map(|text| Text::from(text.unwrap_or_default())).collect::<Array<Text>>().into()
        }
    }
}

fn is_number(ty: &DataType) -> bool {
    ty.is_numeric()
}

fn texts(name: &str, array: &ArrayRef) -> Result<LargeStringArray, String> {
    let texts = cast(array, &DataType::LargeUtf8)
        .map_err(|_| format!("the column `{name}` is {}, and not text", array.data_type()))?;
    Ok(texts.as_string::<i64>().clone())
}
