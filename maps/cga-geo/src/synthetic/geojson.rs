//! Towns as GeoJSON.

use std::error::Error;
use std::fmt::Write as _;
use std::fs::File;
use std::io::{BufWriter, Write};
use std::path::Path;

use super::Town;

/// Writes a town. NaN is written as such, which is not JSON, as some programs do.
pub(super) fn write(town: &Town, path: &Path) -> Result<(), Box<dyn Error>> {
    let mut out = BufWriter::new(File::create(path)?);
    write!(out, "{{\"type\":\"FeatureCollection\",\"features\":[")?;
    for (number, row) in town.iter().enumerate() {
        let comma = if number == 0 { "" } else { "," };
        let mut coordinates = String::new();
        list(&mut coordinates, &row.polygons, |out, polygon| {
            list(out, polygon, |out, ring| {
                list(out, ring, |out, [x, y]| {
                    let _ = write!(out, "[{x},{y}]");
                });
            });
        });
        let (id, height, floors, kind) = (row.id, row.height, row.floors, row.kind);
        write!(
            out,
            "{comma}\n{{\"type\":\"Feature\",\"properties\":{{\"id\":{id},\"height\":{height},\"floors\":{floors},\"kind\":\"{kind}\"}},\
             \"geometry\":{{\"type\":\"MultiPolygon\",\"coordinates\":{coordinates}}}}}"
        )?;
    }
    out.write_all(b"\n]}\n")?;
    Ok(out.flush()?)
}

fn list<T>(out: &mut String, elements: &[T], each: impl Fn(&mut String, &T)) {
    out.push('[');
    for (at, element) in elements.iter().enumerate() {
        if at != 0 {
            out.push(',');
        }
        each(out, element);
    }
    out.push(']');
}
