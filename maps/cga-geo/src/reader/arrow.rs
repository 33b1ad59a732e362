//! Batches of Arrow: rows with geometries as WKB and with columns, for programs that read map files themselves.
//!
//! A column has the values that the reader of GeoParquet gives for the same file.

use arrow_array::cast::AsArray as _;
use arrow_array::types::{Date32Type, Decimal128Type, Float64Type, TimestampMicrosecondType, TimestampMillisecondType};
use arrow_array::{
    Array as _, ArrayRef, BooleanArray, Float64Array, LargeBinaryArray, RecordBatch, StringArray, StructArray,
};
use arrow_cast::cast;
use arrow_schema::{DataType, Field, Schema, TimeUnit};

use super::parquet_text;
use super::wkb::outlines;
use crate::column::ColumnValue;
use crate::missing;
use crate::row::Row;

/// A batch of rows: geometries as WKB, and the columns that rules use.
#[derive(Debug)]
pub struct Rows {
    geometries: LargeBinaryArray,
    columns: Vec<Column>,
}

/// A column.
#[derive(Debug)]
struct Column {
    name: String,
    values: Values,
    /// The groups around it. A row has no value where a group is null.
    groups: Vec<ArrayRef>,
}

/// The values of a column, with one of the types that map files have.
#[derive(Debug)]
enum Values {
    Number(Float64Array),
    Truth(BooleanArray),
    Text(StringArray),
}

impl Rows {
    /// The rows of a column of WKB and a group of other columns.
    ///
    /// # Errors
    /// A sentence about a column with a type that is not read.
    pub fn new(geometries: &ArrayRef, columns: &StructArray) -> Result<Self, String> {
        let names = columns.fields().iter().map(|field| field.name().clone());
        let column = |(name, array): (String, &ArrayRef)| Column::new(name, array, Vec::new());
        let columns = names.zip(columns.columns()).map(column).collect::<Result<_, _>>()?;
        Ok(Rows { geometries: binary(geometries)?, columns })
    }

    /// The rows of a batch with a column of WKB. Of the other columns, only those in `names` are read; the members of a group have names with
    /// dots, as in `names.primary`.
    ///
    /// # Errors
    /// A sentence about a column with a type that is not read, or the column of geometries does not exist.
    pub fn of_batch(batch: &RecordBatch, geometry: &str, names: &[String]) -> Result<Self, String> {
        let schema = batch.schema();
        let geometries = batch.column_by_name(geometry).ok_or_else(|| {
            let known = schema.fields().iter().map(|field| field.name().as_str());
            format!("the table has no column `{geometry}`; {}", missing::names(geometry, "the table", "columns", known))
        })?;
        if !is_binary(geometries.data_type()) {
            return Err(format!("the column `{geometry}` is {}, and not WKB", geometries.data_type()));
        }
        let mut columns = Vec::new();
        for (field, array) in schema.fields().iter().zip(batch.columns()).filter(|(field, _)| field.name() != geometry)
        {
            add(&mut columns, field.name().clone(), array, &[], names)?;
        }
        Ok(Rows { geometries: binary(geometries)?, columns })
    }

    /// The number of rows.
    pub fn len(&self) -> usize {
        self.geometries.len()
    }

    /// True without rows.
    pub fn is_empty(&self) -> bool {
        self.geometries.is_empty()
    }

    /// The geometry of a row as WKB; empty without one.
    pub fn wkb(&self, at: usize) -> &[u8] {
        if self.geometries.is_valid(at) { self.geometries.value(at) } else { &[] }
    }

    /// The rows, each after its geometry as WKB.
    pub fn iter(&self) -> impl Iterator<Item = (&[u8], Row)> {
        (0..self.len()).map(|at| (self.wkb(at), self.row(at)))
    }

    /// A row. Its number is unknown, as the order of a file is lost when many machines read it.
    pub fn row(&self, at: usize) -> Row {
        let mut notes = Vec::new();
        let outlines = if self.geometries.is_valid(at) {
            outlines(self.geometries.value(at), &mut notes)
        } else {
            Err("it has no geometry".to_owned())
        };
        let value = |column: &Column| Some((column.name.clone(), column.value(at)?));
        Row { columns: self.columns.iter().filter_map(value).collect(), notes, ..Row::new(0, outlines) }
    }
}

/// Adds a column, or the members of a group.
fn add(
    columns: &mut Vec<Column>,
    name: String,
    array: &ArrayRef,
    groups: &[ArrayRef],
    names: &[String],
) -> Result<(), String> {
    let Some(group) = array.as_struct_opt() else {
        if names.contains(&name) {
            columns.push(Column::new(name, array, groups.to_vec())?);
        }
        return Ok(());
    };
    let groups = [groups, std::slice::from_ref(array)].concat();
    let members = group.fields().iter().zip(group.columns());
    members
        .into_iter()
        .try_for_each(|(field, member)| add(columns, format!("{name}.{}", field.name()), member, &groups, names))
}

impl Column {
    /// The values that the reader of GeoParquet gives for the same file: dates, times and decimal numbers are texts.
    fn new(name: String, array: &ArrayRef, groups: Vec<ArrayRef>) -> Result<Self, String> {
        check(&name, array.data_type())?;
        let cast = |kind: &DataType| cast(array, kind).map_err(|why| why.to_string());
        let values = match array.data_type() {
            DataType::Boolean => Values::Truth(array.as_boolean().clone()),
            DataType::Date32 => {
                Values::Text(array.as_primitive::<Date32Type>().iter().map(|day| parquet_text::date(day?)).collect())
            }
            DataType::Timestamp(TimeUnit::Millisecond, _) => {
                let times = array.as_primitive::<TimestampMillisecondType>().iter();
                Values::Text(times.map(|time| parquet_text::milliseconds(time?)).collect())
            }
            DataType::Timestamp(TimeUnit::Microsecond, _) => {
                let times = array.as_primitive::<TimestampMicrosecondType>().iter();
                Values::Text(times.map(|time| parquet_text::microseconds(time?)).collect())
            }
            DataType::Decimal128(_, scale) => {
                let numbers = array.as_primitive::<Decimal128Type>().iter();
                Values::Text(numbers.map(|number| parquet_text::decimal(number?, i32::from(*scale))).collect())
            }
            kind if kind.is_numeric() => {
                Values::Number(cast(&DataType::Float64)?.as_primitive::<Float64Type>().clone())
            }
            _ => Values::Text(cast(&DataType::Utf8)?.as_string().clone()),
        };
        Ok(Column { name, values, groups })
    }

    fn value(&self, at: usize) -> Option<ColumnValue> {
        if self.groups.iter().any(|group| group.is_null(at)) {
            return None;
        }
        match &self.values {
            Values::Number(numbers) => numbers.is_valid(at).then(|| ColumnValue::Number(numbers.value(at))),
            Values::Truth(truths) => truths.is_valid(at).then(|| ColumnValue::Truth(truths.value(at))),
            Values::Text(texts) => texts.is_valid(at).then(|| ColumnValue::Text(texts.value(at).to_owned())),
        }
    }
}

fn binary(array: &ArrayRef) -> Result<LargeBinaryArray, String> {
    let array = cast(array, &DataType::LargeBinary).map_err(|why| why.to_string())?;
    Ok(array.as_binary().clone())
}

/// Returns true for the types of bytes, and for the type of a column that is null in each row.
pub fn is_binary(kind: &DataType) -> bool {
    matches!(
        kind,
        DataType::Binary | DataType::LargeBinary | DataType::BinaryView | DataType::FixedSizeBinary(_) | DataType::Null
    )
}

/// Checks the type of a column. Other types would have other values than in `cga-city`.
///
/// # Errors
/// A sentence with the types that a column may have.
pub fn check(name: &str, kind: &DataType) -> Result<(), String> {
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
    Err(format!(
        "the column `{name}` has the type {kind}, which is not read; write it as numbers, texts, dates, decimal numbers, or times in \
         milliseconds or microseconds"
    ))
}

/// The names of all columns of a table; the members of a group have names with dots.
pub fn names(schema: &Schema) -> Vec<String> {
    fn add(found: &mut Vec<String>, name: String, field: &Field) {
        match field.data_type() {
            DataType::Struct(members) => {
                members.iter().for_each(|member| add(found, format!("{name}.{}", member.name()), member));
            }
            _ => found.push(name),
        }
    }
    let mut found = Vec::new();
    schema.fields().iter().for_each(|field| add(&mut found, field.name().clone(), field));
    found
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use arrow_array::Int32Array;

    use super::*;

    #[test]
    fn rows_have_members_of_groups_and_no_values_where_a_group_is_null() {
        let field = |name: &str, kind: DataType| Field::new(name, kind, true);
        let fields = vec![field("primary", DataType::Utf8), field("other", DataType::Utf8)];
        let primary: ArrayRef = Arc::new(StringArray::from(vec![Some("mill"), None, Some("hidden")]));
        let other: ArrayRef = Arc::new(StringArray::from(vec!["a", "b", "c"]));
        let group = StructArray::try_new(fields.into(), vec![primary, other], Some(vec![true, true, false].into()));
        let group: ArrayRef = Arc::new(group.expect("a group"));
        let numbers: ArrayRef = Arc::new(Int32Array::from(vec![Some(7), None, Some(9)]));
        let geometry: ArrayRef = Arc::new(LargeBinaryArray::from_opt_vec(vec![Some(b"no WKB"), None, None]));
        let schema = Schema::new(vec![
            field("height", DataType::Int32),
            field("names", group.data_type().clone()),
            field("geometry", DataType::LargeBinary),
        ]);
        assert_eq!(names(&schema), ["height", "names.primary", "names.other", "geometry"]);
        let batch = RecordBatch::try_new(Arc::new(schema), vec![numbers, group, geometry]).expect("a batch");
        let wanted = ["height", "names.primary"].map(str::to_owned);
        let rows = Rows::of_batch(&batch, "geometry", &wanted).expect("rows");
        let columns: Vec<_> = (0..rows.len()).map(|at| rows.row(at).columns).collect();
        let mill = ("names.primary".to_owned(), ColumnValue::Text("mill".into()));
        let height = |number| ("height".to_owned(), ColumnValue::Number(number));
        assert_eq!(columns, [vec![height(7.0), mill], vec![], vec![height(9.0)]]);
        assert!(rows.row(0).outlines.expect_err("it is not WKB").contains("cannot be read"));
        assert_eq!(rows.row(1).outlines, Err("it has no geometry".to_owned()));
        let error = Rows::of_batch(&batch, "geom", &wanted).expect_err("unknown");
        assert!(error.contains("the table has no column `geom`; ") && error.contains("`geometry`"), "{error}");
        let error = Rows::of_batch(&batch, "height", &wanted).expect_err("numbers");
        assert!(error.contains("the column `height` is Int32, and not WKB"), "{error}");
    }
}
