//! Towns as GeoParquet 1.1.

use std::error::Error;
use std::fs::File;
use std::path::Path;
use std::sync::Arc;

use parquet::basic::Compression;
use parquet::data_type::{ByteArray, ByteArrayType, DataType, DoubleType, Int32Type, Int64Type};
use parquet::file::metadata::KeyValue;
use parquet::file::properties::WriterProperties;
use parquet::file::writer::{SerializedFileWriter, SerializedRowGroupWriter};
use parquet::schema::parser::parse_message_type;

use super::{MadeRow, Town};

const SCHEMA: &str = "message town {
    required int64 id;
    required double height;
    required int32 floors;
    required binary kind (string);
    required binary geometry;
}";

const GEO: &str = r#"{"version":"1.1.0","primary_column":"geometry","columns":{"geometry":{"encoding":"WKB","geometry_types":["MultiPolygon"]}}}"#;

/// The rows of a group.
const GROUP: usize = 20_000;

/// Writes a town.
pub(super) fn write(town: &Town, path: &Path) -> Result<(), Box<dyn Error>> {
    let geo = KeyValue::new("geo".to_owned(), Some(GEO.to_owned()));
    let properties =
        WriterProperties::builder().set_key_value_metadata(Some(vec![geo])).set_compression(Compression::SNAPPY);
    let schema = Arc::new(parse_message_type(SCHEMA)?);
    let mut writer = SerializedFileWriter::new(File::create(path)?, schema, Arc::new(properties.build()))?;
    let mut rows = town.iter();
    loop {
        let group: Vec<MadeRow> = rows.by_ref().take(GROUP).collect();
        if group.is_empty() {
            break;
        }
        let mut out = writer.next_row_group()?;
        column::<Int64Type>(&mut out, group.iter().map(|row| row.id))?;
        column::<DoubleType>(&mut out, group.iter().map(|row| row.height))?;
        column::<Int32Type>(&mut out, group.iter().map(|row| row.floors as i32))?;
        column::<ByteArrayType>(&mut out, group.iter().map(|row| ByteArray::from(row.kind)))?;
        column::<ByteArrayType>(&mut out, group.iter().map(|row| ByteArray::from(wkb(row))))?;
        out.close()?;
    }
    writer.close()?;
    Ok(())
}

fn column<T: DataType>(
    out: &mut SerializedRowGroupWriter<'_, File>,
    values: impl Iterator<Item = T::T>,
) -> Result<(), Box<dyn Error>> {
    let mut column = out.next_column()?.ok_or("the schema has fewer columns")?;
    column.typed::<T>().write_batch(&values.collect::<Vec<_>>(), None, None)?;
    Ok(column.close()?)
}

/// The polygons as well-known binary, little-endian.
fn wkb(row: &MadeRow) -> Vec<u8> {
    let mut out = Vec::new();
    let head = |out: &mut Vec<u8>, kind: u32, count: usize| {
        out.push(1);
        out.extend(kind.to_le_bytes());
        out.extend((count as u32).to_le_bytes());
    };
    head(&mut out, 6, row.polygons.len());
    for polygon in &row.polygons {
        head(&mut out, 3, polygon.len());
        for ring in polygon {
            out.extend((ring.len() as u32).to_le_bytes());
            ring.iter().flatten().for_each(|number| out.extend(number.to_le_bytes()));
        }
    }
    out
}
