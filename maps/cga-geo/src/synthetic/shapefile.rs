//! Towns as shapefiles.

use std::error::Error;
use std::path::Path;

use ::shapefile::dbase::{FieldName, FieldValue, Record, TableWriterBuilder};
use ::shapefile::{Point, Polygon, PolygonRing, Writer};

use super::Town;

/// The coordinate system, as the programs of Esri write it.
const WGS_84: &str = "GEOGCS[\"GCS_WGS_1984\",DATUM[\"D_WGS_1984\",SPHEROID[\"WGS_1984\",6378137.0,298.257223563]],\
    PRIMEM[\"Greenwich\",0.0],UNIT[\"Degree\",0.0174532925199433]]";

/// Writes a town with its four files. Outer rings become clockwise, as the format has them.
pub(super) fn write(town: &Town, path: &Path) -> Result<(), Box<dyn Error>> {
    let name = |name: &str| FieldName::try_from(name);
    let table = TableWriterBuilder::new()
        .add_numeric_field(name("id")?, 12, 0)
        .add_numeric_field(name("height")?, 10, 1)
        .add_numeric_field(name("floors")?, 4, 0)
        .add_character_field(name("kind")?, 10);
    let mut writer = Writer::from_path(path, table)?;
    for row in town.iter() {
        let mut rings = Vec::new();
        for polygon in &row.polygons {
            for (at, ring) in polygon.iter().enumerate() {
                let points = ring.iter().map(|[x, y]| Point::new(*x, *y)).collect();
                rings.push(if at == 0 { PolygonRing::Outer(points) } else { PolygonRing::Inner(points) });
            }
        }
        let mut record = Record::default();
        record.insert("id".to_owned(), FieldValue::Numeric(Some(row.id as f64)));
        record.insert("height".to_owned(), FieldValue::Numeric(Some(row.height)));
        record.insert("floors".to_owned(), FieldValue::Numeric(Some(row.floors as f64)));
        record.insert("kind".to_owned(), FieldValue::Character(Some(row.kind.to_owned())));
        writer.write_shape_and_record(&Polygon::with_rings(rings), &record)?;
    }
    Ok(std::fs::write(path.with_extension("prj"), WGS_84)?)
}
