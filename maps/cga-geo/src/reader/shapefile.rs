//! Shapefiles: `.shp` with `.shx` and `.dbf` beside it, and the encoding in `.cpg` and the coordinate system in `.prj`, if they exist.

use std::fs::File;
use std::io::{self, BufReader, Read as _};
use std::path::Path;

use ::shapefile::dbase::encoding::DynEncoding;
use ::shapefile::dbase::{self, FieldValue};
use ::shapefile::record::polygon::GenericPolygon;
use ::shapefile::{PolygonRing, Shape, ShapeReader};

use super::{FileCrs, MapFile};
use crate::column::ColumnValue;
use crate::outline::{Corner, Outline, contains, twice_area};
use crate::row::{MOST_CORNERS, Row, too_many_corners};

/// Each shape is found by its place in the index, so large buffers would be filled in vain.
const BUFFER: usize = 1 << 10;

/// Reads the shapes of a file.
///
/// # Errors
/// One of the three files is missing, or does not begin as such a file does.
pub fn open(path: &Path) -> Result<MapFile, String> {
    let beside = |ending: &str| {
        let path = path.with_extension(ending);
        File::open(&path).map(|file| BufReader::with_capacity(BUFFER, file)).map_err(|why| match why.kind() {
            io::ErrorKind::NotFound => {
                format!("`{}` is missing; a shapefile is `.shp`, `.shx` and `.dbf` in one folder", path.display())
            }
            _ => format!("cannot read `{}`: {why}", path.display()),
        })
    };
    let index = path.with_extension("shx");
    if let Some(why) = cut_short(&index, &mut beside("shx")?)? {
        return Err(why);
    }
    let shapes = ShapeReader::with_shx(beside("shp")?, beside("shx")?);
    let shapes = shapes.map_err(|why| format!("it is not a shapefile: {why}"))?;
    let shapes_cut = cut_short(path, &mut beside("shp")?)?;
    let encoding = std::fs::read_to_string(path.with_extension("cpg")).ok();
    let encoding = encoding.and_then(|name| DynEncoding::from_name(name.trim().trim_start_matches('\u{feff}')));
    let table = match encoding {
        Some(encoding) => dbase::File::open_with_encoding(beside("dbf")?, encoding),
        None => dbase::File::open(beside("dbf")?),
    };
    let table_path = path.with_extension("dbf");
    let table = table.map_err(|why| format!("`{}` is not a table: {}", table_path.display(), why.kind()))?;
    let columns = table.fields().iter().map(|field| field.name().to_owned()).collect();
    let in_table = rows_in(&mut beside("dbf")?, &table).map_err(|why| why.to_string())?.min(table.num_records());
    let crs = std::fs::read_to_string(path.with_extension("prj")).map_or(FileCrs::None, |text| crs(&text));
    let in_index = shapes.shape_count().map_err(|why| why.to_string())?;
    let end = (in_index != in_table || in_table != table.num_records()).then(|| {
        let (name, announced) = (table_path.display(), table.num_records());
        format!("the index has {in_index} shapes; `{name}` announces {announced} rows and has {in_table}")
    });
    let count = in_index.min(in_table);
    Ok(MapFile::new(Rows { shapes, shapes_cut, table, count, number: 0, end }, crs, Some(columns)))
}

/// A sentence if a `.shp` or `.shx` file is shorter than its header announces.
fn cut_short(path: &Path, input: &mut BufReader<File>) -> Result<Option<String>, String> {
    let unread = |why: io::Error| format!("cannot read `{}`: {why}", path.display());
    let length = input.get_ref().metadata().map_err(unread)?.len();
    let mut head = [0; 28];
    input
        .read_exact(&mut head)
        .map_err(|_| format!("`{}` is not part of a shapefile: it is too short", path.display()))?;
    let announced = 2 * u64::from(u32::from_be_bytes([head[24], head[25], head[26], head[27]]));
    Ok((length < announced).then(|| format!("`{}` is cut short: it has {length} of {announced} bytes", path.display())))
}

/// The number of rows for which a table has bytes. A damaged head may announce four billion.
fn rows_in(input: &mut BufReader<File>, table: &dbase::File<BufReader<File>>) -> io::Result<usize> {
    let length = input.get_ref().metadata()?.len();
    let mut head = [0; 10];
    input.read_exact(&mut head)?;
    let begin = u64::from(u16::from_le_bytes([head[8], head[9]]));
    // A mark for deleted rows comes before the fields.
    let row = 1 + table.fields().iter().map(|field| u64::from(field.length())).sum::<u64>();
    Ok(usize::try_from(length.saturating_sub(begin) / row).unwrap_or(usize::MAX))
}

/// The coordinate system of a `.prj` file. Programs of Esri write no code.
fn crs(text: &str) -> FileCrs {
    let code = text.rsplit_once("AUTHORITY[\"EPSG\",").or_else(|| text.rsplit_once("ID[\"EPSG\","));
    let digits = code.map(|(_, rest)| rest.trim_start_matches('"').chars().take_while(char::is_ascii_digit).collect());
    match digits.and_then(|digits: String| digits.parse().ok()) {
        Some(code) => FileCrs::Epsg(code),
        None if text.trim_start().starts_with("GEOGCS[") && text.contains("D_WGS_1984") => FileCrs::Epsg(4326),
        None => FileCrs::Unknown(text.split('"').nth(1).unwrap_or("without a name").to_owned()),
    }
}

struct Rows {
    shapes: ShapeReader<BufReader<File>>,
    /// A sentence if the file of shapes is cut short.
    shapes_cut: Option<String>,
    table: dbase::File<BufReader<File>>,
    /// The number of rows that have a shape and a row of the table.
    count: usize,
    /// The number of rows so far.
    number: usize,
    /// The reason why further rows are missing.
    end: Option<String>,
}

impl Iterator for Rows {
    type Item = Row;

    fn next(&mut self) -> Option<Row> {
        while self.number < self.count {
            let at = self.number;
            self.number += 1;
            let record = self.record(at);
            // A deleted row is kept in the files until they are packed.
            if let Ok(None) = record {
                continue;
            }
            let shape = self.shapes.read_nth_shape(at);
            let mut row = Row::new(self.number as u64, Ok(Vec::new()));
            match (shape, record) {
                (_, Err(why)) => row.outlines = Err(why),
                (Some(Ok(shape)), Ok(columns)) => {
                    row.columns = columns.unwrap_or_default();
                    row.outlines = outlines(&shape, &mut row.notes);
                }
                (None | Some(Err(_)), _) if self.shapes_cut.is_some() => {
                    let why = format!("the file ends after {at} of {} rows: {}", self.count, self.shapes_cut.take()?);
                    (self.number, self.end) = (self.count, None);
                    return Some(Row::damaged_end(at as u64 + 1, why));
                }
                (None, _) => row.outlines = Err("the index has no place of its shape".to_owned()),
                (Some(Err(why)), Ok(columns)) => {
                    row.columns = columns.unwrap_or_default();
                    row.outlines = Err(format!("its shape cannot be read: {why}"));
                }
            }
            return Some(row);
        }
        let why = format!("the file ends after {} rows: {}", self.count, self.end.take()?);
        Some(Row::damaged_end(self.count as u64 + 1, why))
    }
}

impl Rows {
    /// The columns of a row, by their names; `None` for a deleted row.
    fn record(&mut self, at: usize) -> Result<Option<Vec<(String, ColumnValue)>>, String> {
        let mut record = self.table.record(at).ok_or("the table has no row for this shape")?;
        let unreadable = |why: dbase::Error| format!("its columns cannot be read: {}", why.kind());
        if record.is_deleted().map_err(unreadable)? {
            return Ok(None);
        }
        let record = record.read().map_err(unreadable)?;
        let columns = record.into_iter().filter_map(|(name, value)| Some((name, column(value)?)));
        let mut columns: Vec<(String, ColumnValue)> = columns.collect();
        columns.sort_by(|(a, _), (b, _)| a.cmp(b));
        Ok(Some(columns))
    }
}

fn column(value: FieldValue) -> Option<ColumnValue> {
    match value {
        FieldValue::Character(text) => text.map(ColumnValue::Text),
        FieldValue::Memo(text) => Some(ColumnValue::Text(text)),
        FieldValue::Numeric(number) => number.map(ColumnValue::Number),
        FieldValue::Float(number) => number.map(|number| ColumnValue::Number(f64::from(number))),
        FieldValue::Logical(truth) => truth.map(ColumnValue::Truth),
        FieldValue::Integer(number) => Some(ColumnValue::Number(f64::from(number))),
        FieldValue::Currency(number) | FieldValue::Double(number) => Some(ColumnValue::Number(number)),
        FieldValue::Date(date) => date.map(|date| ColumnValue::Text(date.to_string())),
        FieldValue::DateTime(_) => None,
    }
}

/// A ring with its heights.
struct Ring {
    is_outer: bool,
    corners: Vec<Corner>,
    heights: Vec<f64>,
}

fn outlines(shape: &Shape, notes: &mut Vec<String>) -> Result<Vec<Outline>, String> {
    let rings = match shape {
        Shape::NullShape => return Ok(Vec::new()),
        Shape::Polygon(polygon) => rings(polygon, |point| ([point.x, point.y], None)),
        Shape::PolygonM(polygon) => rings(polygon, |point| ([point.x, point.y], None)),
        Shape::PolygonZ(polygon) => rings(polygon, |point| ([point.x, point.y], Some(point.z))),
        other => return Err(format!("a {} is not a polygon", other.shapetype())),
    }?;
    Ok(joined(rings, notes))
}

fn rings<P>(polygon: &GenericPolygon<P>, corner: impl Fn(&P) -> (Corner, Option<f64>)) -> Result<Vec<Ring>, String> {
    let count: usize = polygon.rings().iter().map(PolygonRing::len).sum();
    if MOST_CORNERS < count {
        return Err(too_many_corners(count));
    }
    let ring = |ring: &PolygonRing<P>| {
        let points = match ring {
            PolygonRing::Outer(points) | PolygonRing::Inner(points) => points,
        };
        Ring {
            is_outer: matches!(ring, PolygonRing::Outer(_)),
            corners: points.iter().map(|point| corner(point).0).collect(),
            heights: points.iter().filter_map(|point| corner(point).1).collect(),
        }
    };
    Ok(polygon.rings().iter().map(ring).collect())
}

/// Polygons of rings: each hole joins the smallest outer ring around its first corner. Holes are told from outer rings by their winding.
fn joined(rings: Vec<Ring>, notes: &mut Vec<String>) -> Vec<Outline> {
    let has_outer = rings.iter().any(|ring| ring.is_outer);
    if !has_outer && !rings.is_empty() {
        notes.push("its outline runs counter-clockwise, as a hole of a shapefile does; it was turned".to_owned());
    }
    let (outer, holes): (Vec<Ring>, Vec<Ring>) = rings.into_iter().partition(|ring| ring.is_outer || !has_outer);
    let outline = |ring: Ring| {
        let mut outline = Outline::new(vec![ring.corners]);
        ring.heights.iter().for_each(|height| outline.lower_to(*height));
        outline
    };
    let mut outlines: Vec<Outline> = outer.into_iter().map(outline).collect();
    let areas: Vec<f64> = outlines.iter().map(|outline| twice_area(&outline.rings[0]).abs()).collect();
    for hole in holes {
        let Some(&first) = hole.corners.first() else { continue };
        let around = |at: &usize| areas.len() == 1 || contains(&outlines[*at].rings[0], first);
        match (0..areas.len()).filter(around).min_by(|a, b| areas[*a].total_cmp(&areas[*b])) {
            Some(at) => outlines[at].rings.push(hole.corners),
            None => notes.push("a hole outside of its outlines was left out".to_owned()),
        }
    }
    outlines
}

#[cfg(test)]
mod tests {
    use super::*;

    fn square(low: f64, high: f64, is_outer: bool) -> Ring {
        let mut corners = vec![[low, low], [low, high], [high, high], [high, low], [low, low]];
        if !is_outer {
            corners.reverse();
        }
        Ring { is_outer, corners, heights: Vec::new() }
    }

    #[test]
    fn holes_join_the_smallest_outline_around_them() {
        let mut notes = Vec::new();
        let rings =
            vec![square(0.0, 9.0, true), square(2.0, 7.0, false), square(3.0, 6.0, true), square(4.0, 5.0, false)];
        let outlines = joined(rings, &mut notes);
        let holes: Vec<f64> = outlines.iter().map(|outline| outline.rings[1][0][0]).collect();
        assert_eq!((holes, notes.len()), (vec![2.0, 4.0], 0));
    }

    #[test]
    fn an_outline_that_is_wound_as_a_hole_is_an_outline() {
        let mut notes = Vec::new();
        assert_eq!(joined(vec![square(0.0, 9.0, false)], &mut notes).len(), 1);
        assert!(notes[0].contains("counter-clockwise"));
    }

    #[test]
    fn coordinate_systems_have_their_code() {
        let text = "PROJCS[\"ETRS89 / UTM zone 32N\",GEOGCS[\"ETRS89\",AUTHORITY[\"EPSG\",\"4258\"]],AUTHORITY[\"EPSG\",\"25832\"]]";
        assert_eq!(crs(text), FileCrs::Epsg(25832));
        assert_eq!(crs("GEOGCS[\"GCS_WGS_1984\",DATUM[\"D_WGS_1984\",SPHEROID[]]]"), FileCrs::Epsg(4326));
        assert_eq!(crs("PROJCS[\"Gauss\",GEOGCS[]]"), FileCrs::Unknown("Gauss".to_owned()));
    }
}
