//! Rows of a map, from the columns of a batch.

use cga_geo::column::ColumnValue;
use cga_geo::reader::geoparquet::outlines;
use cga_geo::row::Row;
use datafusion::arrow::array::{
    Array, ArrayRef, AsArray, BooleanArray, Float64Array, LargeBinaryArray, StringArray, StructArray,
};
use datafusion::arrow::compute::cast;
use datafusion::arrow::datatypes::{DataType, Field, Float64Type};
use datafusion::error::Result;

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
        let column = |(array, name): (&ArrayRef, &String)| Ok((name.clone(), Column::new(array)?));
        let names: Vec<String> = columns.fields().iter().map(|field| field.name().clone()).collect();
        Ok(Rows {
            geometries: cast(geometries, &DataType::LargeBinary)?.as_binary().clone(),
            columns: columns.columns().iter().zip(&names).map(column).collect::<Result<_>>()?,
        })
    }

    pub(crate) fn len(&self) -> usize {
        self.geometries.len()
    }

    /// A row. Its number is unknown, as the order of a file is lost when many machines read it.
    pub(crate) fn row(&self, at: usize) -> Row {
        let mut notes = Vec::new();
        let outlines = match self.geometries.is_null(at) {
            true => Err("it has no geometry".to_owned()),
            false => outlines(self.geometries.value(at), &mut notes),
        };
        let value = |(name, column): &(String, Column)| Some((name.clone(), column.value(at)?));
        Row { columns: self.columns.iter().filter_map(value).collect(), notes, ..Row::new(0, outlines) }
    }
}

impl Column {
    /// Types without a counterpart, such as dates and decimal numbers, are texts.
    fn new(array: &ArrayRef) -> Result<Self> {
        Ok(match array.data_type() {
            DataType::Boolean => Column::Truth(array.as_boolean().clone()),
            kind if kind.is_integer() || kind.is_floating() => {
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

/// The columns of a field in SQL, each with its name in rules: members of a group have names with dots.
pub(crate) fn columns_of(field: &Field) -> Vec<(String, String)> {
    fn add(found: &mut Vec<(String, String)>, name: String, sql: String, field: &Field) {
        let DataType::Struct(members) = field.data_type() else { return found.push((name, sql)) };
        for member in members {
            let own = member.name();
            add(found, format!("{name}.{own}"), format!("{sql}['{}']", own.replace('\'', "''")), member);
        }
    }
    let (mut found, name) = (Vec::new(), field.name());
    add(&mut found, name.clone(), format!("\"{}\"", name.replace('"', "\"\"")), field);
    found
}
