//! GeoParquet 1.0 and 1.1, with geometries as WKB or in lists of coordinates.

use std::fs::File;
use std::path::Path;
use std::sync::Arc;

use parquet::basic::{ConvertedType, LogicalType};
use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::record::reader::RowIter;
use parquet::record::{Field, Row as Record};
use parquet::schema::types::Type;
use serde_json::{Value as Json, json};

use super::parquet_native::NativePolygons;
use super::wkb::outlines;
use super::{FileCrs, MapFile, parquet_text};
use crate::column::ColumnValue;
use crate::crs::WGS_84;
use crate::outline::Outline;
use crate::plain::plain;
use crate::row::Row;

/// The column of geometries of a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Geometry {
    /// Its name.
    pub column: String,
    /// Its coordinate system.
    pub crs: FileCrs,
    /// Its encoding.
    pub encoding: Encoding,
}

/// The encoding of the geometries of a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Encoding {
    /// Well-known binary.
    Wkb,
    /// Lists of rings of corners.
    Polygon,
    /// Lists of polygons.
    MultiPolygon,
    /// Geometries that are not polygons, by the name of their type.
    Other(&'static str),
}

impl Encoding {
    fn of(name: &str) -> Option<Self> {
        Some(match name {
            "WKB" => Encoding::Wkb,
            "polygon" => Encoding::Polygon,
            "multipolygon" => Encoding::MultiPolygon,
            "point" => Encoding::Other("Point"),
            "multipoint" => Encoding::Other("MultiPoint"),
            "linestring" => Encoding::Other("LineString"),
            "multilinestring" => Encoding::Other("MultiLineString"),
            _ => return None,
        })
    }
}

impl Geometry {
    /// The column that the member `geo` of the file's metadata names. Without the member it is `geometry`.
    ///
    /// # Errors
    /// The member is not JSON, or the encoding of the geometries is not known.
    pub fn of(geo: Option<&str>) -> Result<Self, String> {
        let geo: Json =
            geo.map_or(Ok(Json::Null), serde_json::from_str).map_err(|why| format!("its member `geo`: {why}"))?;
        let column = geo["primary_column"].as_str().unwrap_or("geometry").to_owned();
        let about = &geo["columns"][&column];
        let name = about["encoding"].as_str().unwrap_or("WKB");
        let Some(encoding) = Encoding::of(name) else {
            return Err(format!("its geometries are encoded as {}; write them as WKB", plain(name, 60)));
        };
        Ok(Geometry { crs: crs(about), column, encoding })
    }

    /// The first column whose type is a geometry of Parquet itself, for files without the member `geo`.
    fn of_type(schema: &Type) -> Option<Self> {
        let geometry = |field: &Arc<Type>| {
            let crs = match field.get_basic_info().logical_type_ref()? {
                LogicalType::Geometry(geometry) => &geometry.crs,
                LogicalType::Geography(geography) => &geography.crs,
                _ => return None,
            };
            let crs = crs.as_deref().map_or(FileCrs::Epsg(WGS_84), crs_of_type);
            Some(Geometry { column: field.name().to_owned(), crs, encoding: Encoding::Wkb })
        };
        schema.get_fields().iter().find_map(geometry)
    }

    /// Checks that geometries are WKB, for readers that know nothing else.
    ///
    /// # Errors
    /// A sentence with the encoding.
    pub fn check_wkb(&self) -> Result<(), String> {
        let is_wkb = self.encoding == Encoding::Wkb;
        is_wkb
            .then_some(())
            .ok_or_else(|| format!("its geometries are encoded as {:?}; write them as WKB", self.encoding))
    }
}

/// Reads the rows of a file. Of its columns, only those in `columns` are read, for all rows; a column of a group is written with dots, as in
/// `names.primary`.
///
/// # Errors
/// The file is not Parquet, or the encoding of its geometries is not known.
pub fn open(path: &Path, columns: &[String]) -> Result<MapFile, String> {
    let file = File::open(path).map_err(|why| why.to_string())?;
    let reader = SerializedFileReader::new(file).map_err(|why| format!("it is not Parquet: {why}"))?;
    let metadata = reader.metadata().file_metadata();
    let geo = metadata.key_value_metadata().into_iter().flatten().find(|entry| entry.key == "geo");
    let geo = geo.and_then(|entry| entry.value.as_deref());
    let schema = metadata.schema();
    let typed = geo.is_none().then(|| Geometry::of_type(schema)).flatten();
    let Geometry { column: geometry, crs, encoding } = typed.map_or_else(|| Geometry::of(geo), Ok)?;
    let mut known = Vec::new();
    let others = schema.get_fields().iter().filter(|field| field.name() != geometry);
    others.for_each(|field| add_names(&mut known, String::new(), field));
    let is_wkb = encoding == Encoding::Wkb;
    let wanted = |name: &str| {
        (name == geometry && is_wkb)
            || columns.iter().any(|column| column == name || column.starts_with(&format!("{name}.")))
    };
    let fields: Vec<_> = schema.get_fields().iter().filter(|field| wanted(field.name())).cloned().collect();
    if !schema.get_fields().iter().any(|field| field.name() == geometry) {
        return Err(format!("it has no column `{geometry}`"));
    }
    let projection = Type::group_type_builder(schema.name()).with_fields(fields).build();
    let projection = projection.map_err(|why| why.to_string())?;
    let count = u64::try_from(metadata.num_rows()).unwrap_or_default();
    let polygons = match encoding {
        Encoding::Wkb => Polygons::Wkb,
        Encoding::Polygon => Polygons::Native(Box::new(NativePolygons::open(path, &geometry, 2)?)),
        Encoding::MultiPolygon => Polygons::Native(Box::new(NativePolygons::open(path, &geometry, 3)?)),
        Encoding::Other(kind) => Polygons::Other(kind),
    };
    // A file without a column for the rules has no records to read.
    let has_records = is_wkb || !projection.get_fields().is_empty();
    let rows = RowIter::from_file_into(Box::new(reader)).project(Some(projection)).map_err(|why| why.to_string())?;
    let rows = has_records.then_some(rows);
    let geometry = geometry.into();
    Ok(MapFile::new(Rows { rows, geometry, polygons, number: 0, count, is_over: false }, crs, Some(known)))
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
        None => FileCrs::Epsg(WGS_84),
        Some(Json::Null) => FileCrs::None,
        Some(crs) => match (crs["id"]["authority"].as_str(), &crs["id"]["code"]) {
            (Some("EPSG"), code) if code.is_u64() => FileCrs::Epsg(code.as_u64().unwrap_or_default() as u32),
            (Some("OGC"), code) if code == "CRS84" => FileCrs::Epsg(WGS_84),
            _ => FileCrs::Unknown(crs["name"].as_str().unwrap_or("without a name").to_owned()),
        },
    }
}

/// The polygons of rows.
enum Polygons {
    /// A value of the record.
    Wkb,
    Native(Box<NativePolygons>),
    /// Geometries of another type.
    Other(&'static str),
}

/// The coordinate system of a type of Parquet: `OGC:CRS84`, `EPSG:25832`, `srid:25832`, or PROJJSON.
fn crs_of_type(text: &str) -> FileCrs {
    if let Ok(json) = serde_json::from_str::<Json>(text)
        && json.is_object()
    {
        return crs(&json!({ "crs": json }));
    }
    match text.split_once(':').map(|(authority, code)| (authority.to_lowercase(), code)) {
        Some((authority, "CRS84")) if authority == "ogc" => FileCrs::Epsg(WGS_84),
        Some((authority, code)) if ["epsg", "srid"].contains(&authority.as_str()) => {
            code.parse().map_or_else(|_| FileCrs::Unknown(text.to_owned()), FileCrs::Epsg)
        }
        _ => FileCrs::Unknown(text.to_owned()),
    }
}

struct Rows {
    /// The columns of the rows, if some are read.
    rows: Option<RowIter<'static>>,
    polygons: Polygons,
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
        let record = match self.rows.as_mut().map(Iterator::next) {
            None => None,
            Some(Some(Ok(record))) => Some(record),
            Some(Some(Err(why))) => return Some(self.end(before, &why.to_string())),
            Some(None) => return Some(self.end(before, "further rows are missing")),
        };
        let mut row = row(self.number, &self.geometry, record);
        match &mut self.polygons {
            Polygons::Wkb => {}
            Polygons::Native(polygons) => match polygons.next_row() {
                Ok(outlines) => row.outlines = outlines,
                Err(why) => return Some(self.end(before, &why)),
            },
            Polygons::Other(kind) => row.outlines = Err(format!("a {kind} is not a polygon")),
        }
        Some(row)
    }
}

impl Rows {
    /// The last row, which says why the file ends early.
    fn end(&mut self, before: u64, why: &str) -> Row {
        self.is_over = true;
        Row::damaged_end(before + 1, format!("the file ends after {before} of {} rows: {why}", self.count))
    }
}

fn row(number: u64, geometry: &str, record: Option<Record>) -> Row {
    let (mut outlines, mut columns, mut notes) = (Err("it has no geometry".to_owned()), Vec::new(), Vec::new());
    for (name, field) in record.into_iter().flat_map(Record::into_columns) {
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
