//! GeoParquet 1.0 and 1.1 with geometries as WKB.

use std::fs::File;
use std::path::Path;
use std::sync::Arc;

use geozero::wkb::process_wkb_geom;
use parquet::basic::ConvertedType;
use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::record::reader::RowIter;
use parquet::record::{Field, Row as Record};
use parquet::schema::types::Type;
use serde_json::Value as Json;

use super::collector::Collector;
use super::quiet::quiet;
use super::{FileCrs, MapFile, parquet_text};
use crate::column::ColumnValue;
use crate::outline::Outline;
use crate::row::Row;

/// The column of geometries of a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Geometry {
    /// Its name.
    pub column: String,
    /// Its coordinate system.
    pub crs: FileCrs,
}

impl Geometry {
    /// The column that the member `geo` of the file's metadata names. Without the member it is `geometry`.
    ///
    /// # Errors
    /// The member is not JSON, or the geometries are not WKB.
    pub fn of(geo: Option<&str>) -> Result<Self, String> {
        let geo: Json =
            geo.map_or(Ok(Json::Null), serde_json::from_str).map_err(|why| format!("its member `geo`: {why}"))?;
        let column = geo["primary_column"].as_str().unwrap_or("geometry").to_owned();
        let about = &geo["columns"][&column];
        if let Some(encoding) = about["encoding"].as_str().filter(|encoding| *encoding != "WKB") {
            return Err(format!("its geometries are encoded as {encoding}; write them as WKB"));
        }
        Ok(Geometry { crs: crs(about), column })
    }
}

/// The polygons of a geometry as WKB. Parts of a collection that are left out are added to the notes.
///
/// # Errors
/// A sentence: the bytes are not WKB, or the geometry has no polygon that can be used.
pub fn outlines(wkb: &[u8], notes: &mut Vec<String>) -> Result<Vec<Outline>, String> {
    let mut collector = Collector::default();
    let read = quiet(|| process_wkb_geom(&mut &*wkb, &mut collector));
    let outlines = collector.outlines(read.ok_or("its geometry is damaged")?);
    notes.append(&mut collector.notes);
    outlines
}

/// Reads the rows of a file. Of its columns, only those in `columns` are read, for all rows; a column of a group is written with dots, as in
/// `names.primary`.
///
/// # Errors
/// The file is not Parquet, or its geometries are not WKB.
pub fn open(path: &Path, columns: &[String]) -> Result<MapFile, String> {
    let file = File::open(path).map_err(|why| why.to_string())?;
    let reader = SerializedFileReader::new(file).map_err(|why| format!("it is not Parquet: {why}"))?;
    let metadata = reader.metadata().file_metadata();
    let geo = metadata.key_value_metadata().into_iter().flatten().find(|entry| entry.key == "geo");
    let geo = geo.and_then(|entry| entry.value.as_deref());
    let Geometry { column: geometry, crs } = Geometry::of(geo)?;
    let schema = metadata.schema();
    let mut known = Vec::new();
    let others = schema.get_fields().iter().filter(|field| field.name() != geometry);
    others.for_each(|field| add_names(&mut known, String::new(), field));
    let wanted = |name: &str| {
        name == geometry || columns.iter().any(|column| column == name || column.starts_with(&format!("{name}.")))
    };
    let fields: Vec<_> = schema.get_fields().iter().filter(|field| wanted(field.name())).cloned().collect();
    if !fields.iter().any(|field| field.name() == geometry) {
        return Err(format!("it has no column `{geometry}`"));
    }
    let projection = Type::group_type_builder(schema.name()).with_fields(fields).build();
    let projection = projection.map_err(|why| why.to_string())?;
    let count = u64::try_from(metadata.num_rows()).unwrap_or_default();
    let rows = RowIter::from_file_into(Box::new(reader)).project(Some(projection)).map_err(|why| why.to_string())?;
    Ok(MapFile::new(Rows { rows, geometry: geometry.into(), number: 0, count, is_over: false }, crs, Some(known)))
}

/// Adds the names of the columns of a field. The members of a group have names with dots.
fn add_names(names: &mut Vec<String>, outer: String, field: &Type) {
    let name = outer + field.name();
    let is_list = field.get_basic_info().converted_type() != ConvertedType::NONE;
    if field.is_group() && !is_list {
        field.get_fields().iter().for_each(|inner| add_names(names, format!("{name}."), inner));
    } else {
        names.push(name);
    }
}

/// The coordinate system of a geometry column, in PROJJSON. Without one it is longitude and latitude.
fn crs(about: &Json) -> FileCrs {
    match about.get("crs") {
        None => FileCrs::Epsg(4326),
        Some(Json::Null) => FileCrs::None,
        Some(crs) => match (crs["id"]["authority"].as_str(), &crs["id"]["code"]) {
            (Some("EPSG"), code) if code.is_u64() => FileCrs::Epsg(code.as_u64().unwrap_or_default() as u32),
            (Some("OGC"), code) if code == "CRS84" => FileCrs::Epsg(4326),
            _ => FileCrs::Unknown(crs["name"].as_str().unwrap_or("without a name").to_owned()),
        },
    }
}

struct Rows {
    rows: RowIter<'static>,
    geometry: Arc<str>,
    /// The number of rows so far.
    number: u64,
    /// The number of rows that the file announces.
    count: u64,
    is_over: bool,
}

impl Iterator for Rows {
    type Item = Row;

    fn next(&mut self) -> Option<Row> {
        if self.is_over || self.count <= self.number {
            return None;
        }
        let before = self.number;
        self.number += 1;
        match self.rows.next() {
            Some(Ok(record)) => Some(row(self.number, &self.geometry, record)),
            Some(Err(why)) => Some(self.end(before, &why.to_string())),
            None => Some(self.end(before, "further rows are missing")),
        }
    }
}

impl Rows {
    /// The last row, which says why the file ends early.
    fn end(&mut self, before: u64, why: &str) -> Row {
        self.is_over = true;
        Row::damaged_end(before + 1, format!("the file ends after {before} of {} rows: {why}", self.count))
    }
}

fn row(number: u64, geometry: &str, record: Record) -> Row {
    let (mut outlines, mut columns, mut notes) = (Err("it has no geometry".to_owned()), Vec::new(), Vec::new());
    for (name, field) in record.into_columns() {
        if name == geometry {
            outlines = polygons(&field, &mut notes);
        } else {
            add(&mut columns, name, field);
        }
    }
    Row { columns, notes, ..Row::new(number, outlines) }
}

fn polygons(field: &Field, notes: &mut Vec<String>) -> Result<Vec<Outline>, String> {
    let bytes = match field {
        Field::Bytes(bytes) => bytes.data(),
        Field::Null => return Err("it has no geometry".to_owned()),
        _ => return Err("its geometry is not WKB".to_owned()),
    };
    outlines(bytes, notes)
}

/// Adds the value of a column; the members of a group have names with dots.
fn add(columns: &mut Vec<(String, ColumnValue)>, name: String, field: Field) {
    let value = match field {
        Field::Null => return,
        Field::Group(group) => {
            return group
                .into_columns()
                .into_iter()
                .for_each(|(own, field)| add(columns, format!("{name}.{own}"), field));
        }
        Field::Bool(truth) => ColumnValue::Truth(truth),
        Field::Byte(number) => ColumnValue::Number(f64::from(number)),
        Field::Short(number) => ColumnValue::Number(f64::from(number)),
        Field::Int(number) => ColumnValue::Number(f64::from(number)),
        Field::Long(number) => ColumnValue::Number(number as f64),
        Field::UByte(number) => ColumnValue::Number(f64::from(number)),
        Field::UShort(number) => ColumnValue::Number(f64::from(number)),
        Field::UInt(number) => ColumnValue::Number(f64::from(number)),
        Field::ULong(number) => ColumnValue::Number(number as f64),
        Field::Float(number) => ColumnValue::Number(f64::from(number)),
        Field::Double(number) => ColumnValue::Number(number),
        Field::Str(text) => ColumnValue::Text(text),
        // Dates, decimal numbers: as text that is read as a number where an attribute is one.
        other => match parquet_text::of_field(&other) {
            Some(text) => ColumnValue::Text(text),
            None => return,
        },
    };
    columns.push((name, value));
}
