//! Rows of a map, from the columns of a batch.

use cga_geo::column::ColumnValue;
use cga_geo::reader::geoparquet::outlines;
use cga_geo::reader::parquet_text;
use cga_geo::row::Row;
use datafusion::arrow::array::{
    Array, ArrayRef, AsArray, BooleanArray, Float64Array, LargeBinaryArray, StringArray, StructArray,
};
use datafusion::arrow::compute::cast;
use datafusion::arrow::datatypes::{
    DataType, Date32Type, Decimal128Type, Field, Float64Type, TimeUnit, TimestampMicrosecondType,
    TimestampMillisecondType,
};
use datafusion::error::{DataFusionError, Result};

use crate::sql;

/// A batch of rows: geometries as WKB, and the columns that rules use.
pub(crate) struct Rows {
    geometries: LargeBinaryArray,
    columns: Vec<(String, Column)>,
}

/// A column with one of the types that map files have.
enum Column {
    Number(Float64Array),
    Truth(BooleanArray),
    Text(StringArray),
}

impl Rows {
    /// The rows of a column of WKB and a group of other columns.
    pub(crate) fn new(geometries: &ArrayRef, columns: &StructArray) -> Result<Self> {
        let column = |(array, name): (&ArrayRef, &String)| Ok((name.clone(), Column::new(name, array)?));
        let names: Vec<String> = columns.fields().iter().map(|field| field.name().clone()).collect();
        Ok(Rows {
            geometries: cast(geometries, &DataType::LargeBinary)?.as_binary().clone(),
            columns: columns.columns().iter().zip(&names).map(column).collect::<Result<_>>()?,
        })
    }

    pub(crate) fn len(&self) -> usize {
        self.geometries.len()
    }

    /// The geometry of a row as WKB.
    pub(crate) fn wkb(&self, at: usize) -> Option<&[u8]> {
        self.geometries.is_valid(at).then(|| self.geometries.value(at))
    }

    /// A row. Its number is unknown, as the order of a file is lost when many machines read it.
    pub(crate) fn row(&self, at: usize) -> Row {
        let mut notes = Vec::new();
        let outlines = match self.wkb(at) {
            Some(wkb) => outlines(wkb, &mut notes),
            None => Err("it has no geometry".to_owned()),
        };
        let value = |(name, column): &(String, Column)| Some((name.clone(), column.value(at)?));
        Row { columns: self.columns.iter().filter_map(value).collect(), notes, ..Row::new(0, outlines) }
    }
}

impl Column {
    /// The values that `cga-city` reads from the same file: dates, times and decimal numbers are texts.
    fn new(name: &str, array: &ArrayRef) -> Result<Self> {
        check(name, array.data_type())?;
        Ok(match array.data_type() {
            DataType::Boolean => Column::Truth(array.as_boolean().clone()),
            DataType::Date32 => {
                Column::Text(array.as_primitive::<Date32Type>().iter().map(|day| parquet_text::date(day?)).collect())
            }
            DataType::Timestamp(TimeUnit::Millisecond, _) => {
                let times = array.as_primitive::<TimestampMillisecondType>().iter();
                Column::Text(times.map(|time| parquet_text::milliseconds(time?)).collect())
            }
            DataType::Timestamp(TimeUnit::Microsecond, _) => {
                let times = array.as_primitive::<TimestampMicrosecondType>().iter();
                Column::Text(times.map(|time| parquet_text::microseconds(time?)).collect())
            }
            DataType::Decimal128(_, scale) => {
                let numbers = array.as_primitive::<Decimal128Type>().iter();
                Column::Text(numbers.map(|number| parquet_text::decimal(number?, i32::from(*scale))).collect())
            }
            kind if kind.is_numeric() => {
                Column::Number(cast(array, &DataType::Float64)?.as_primitive::<Float64Type>().clone())
            }
            _ => Column::Text(cast(array, &DataType::Utf8)?.as_string().clone()),
        })
    }

    fn value(&self, at: usize) -> Option<ColumnValue> {
        match self {
            Column::Number(numbers) => numbers.is_valid(at).then(|| ColumnValue::Number(numbers.value(at))),
            Column::Truth(truths) => truths.is_valid(at).then(|| ColumnValue::Truth(truths.value(at))),
            Column::Text(texts) => texts.is_valid(at).then(|| ColumnValue::Text(texts.value(at).to_owned())),
        }
    }
}

/// Checks the type of a column. Other types would have other values than in `cga-city`.
///
/// # Errors
/// A sentence with the types that a column may have.
pub(crate) fn check(name: &str, kind: &DataType) -> Result<()> {
    let is_known = match kind {
        DataType::Null | DataType::Boolean | DataType::Float32 | DataType::Float64 => true,
        DataType::Utf8 | DataType::LargeUtf8 | DataType::Utf8View | DataType::Date32 => true,
        DataType::Timestamp(unit, _) => matches!(unit, TimeUnit::Millisecond | TimeUnit::Microsecond),
        DataType::Decimal128(_, scale) => 0 <= *scale,
        DataType::Dictionary(_, values) => matches!(**values, DataType::Utf8 | DataType::LargeUtf8),
        other => other.is_integer(),
    };
    if is_known {
        return Ok(());
    }
    Err(DataFusionError::Plan(format!(
        "the column `{name}` has the type {kind}, which is not read; write it as numbers, texts, dates, decimal numbers, or times in \
         milliseconds or microseconds"
    )))
}

/// The columns of a field in SQL, each with its name in rules: members of a group have names with dots.
pub(crate) fn columns_of(field: &Field) -> Vec<(String, String)> {
    fn add(found: &mut Vec<(String, String)>, name: String, column: String, field: &Field) {
        let DataType::Struct(members) = field.data_type() else { return found.push((name, column)) };
        for member in members {
            let own = member.name();
            add(found, format!("{name}.{own}"), format!("{column}[{}]", sql::literal(own)), member);
        }
    }
    let (mut found, name) = (Vec::new(), field.name());
    add(&mut found, name.clone(), sql::name(name), field);
    found
}
