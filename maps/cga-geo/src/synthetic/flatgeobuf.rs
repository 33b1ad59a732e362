//! Towns as FlatGeobuf.

use std::error::Error;
use std::fs::File;
use std::io::BufWriter;
use std::path::Path;

use ::flatgeobuf::geozero::error::Result as GeoResult;
use ::flatgeobuf::geozero::{ColumnValue, GeomProcessor, GeozeroGeometry, PropertyProcessor as _};
use ::flatgeobuf::{ColumnType, FgbCrs, FgbWriter, FgbWriterOptions, GeometryType};

use super::{MadeRow, Town};

/// Writes a town. The writer puts the rows into the order of its index.
pub(super) fn write(town: &Town, path: &Path) -> Result<(), Box<dyn Error>> {
    let options = FgbWriterOptions { crs: FgbCrs { code: 4326, ..FgbCrs::default() }, ..FgbWriterOptions::default() };
    let mut writer = FgbWriter::create_with_options("town", GeometryType::MultiPolygon, options)?;
    for (name, ty) in [
        ("id", ColumnType::Long),
        ("height", ColumnType::Double),
        ("floors", ColumnType::Int),
        ("kind", ColumnType::String),
    ] {
        writer.add_column(name, ty, |_, _| {});
    }
    for row in town.iter() {
        writer.add_feature_geom(Geometry(&row), |feature| {
            // Values in memory cannot fail to be written.
            let _ = feature.property(0, "id", &ColumnValue::Long(row.id));
            let _ = feature.property(1, "height", &ColumnValue::Double(row.height));
            let _ = feature.property(2, "floors", &ColumnValue::Int(row.floors as i32));
            let _ = feature.property(3, "kind", &ColumnValue::String(row.kind));
        })?;
    }
    Ok(writer.write(BufWriter::new(File::create(path)?))?)
}

/// The polygons of a row.
struct Geometry<'r>(&'r MadeRow);

impl GeozeroGeometry for Geometry<'_> {
    fn process_geom<P: GeomProcessor>(&self, out: &mut P) -> GeoResult<()> {
        let polygons = &self.0.polygons;
        out.multipolygon_begin(polygons.len(), 0)?;
        for (number, polygon) in polygons.iter().enumerate() {
            out.polygon_begin(false, polygon.len(), number)?;
            for (at, ring) in polygon.iter().enumerate() {
                out.linestring_begin(false, ring.len(), at)?;
                for (at, [x, y]) in ring.iter().enumerate() {
                    out.xy(*x, *y, at)?;
                }
                out.linestring_end(false, at)?;
            }
            out.polygon_end(false, number)?;
        }
        out.multipolygon_end(0)
    }
}
