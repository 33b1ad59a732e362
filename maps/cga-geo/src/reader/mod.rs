//! Readers of map files: one row after another, in the order of the file and with little memory.
//!
//! Rows count from 1. A row that cannot be read is a row with a reason. A damaged file ends with such a row, so none is lost silently:
//! [`Row::is_damaged_end`].

#[cfg(feature = "arrow")]
pub mod arrow;
#[cfg(any(feature = "flatgeobuf", feature = "wkb"))]
mod collector;
#[cfg(feature = "flatgeobuf")]
pub mod flatgeobuf;
#[cfg(feature = "geojson")]
pub mod geojson;
#[cfg(feature = "geoparquet")]
pub mod geoparquet;
#[cfg(feature = "geojson")]
mod json_objects;
#[cfg(feature = "geojson")]
mod json_records;
#[cfg(feature = "geoparquet")]
mod parquet_native;
#[cfg(any(feature = "geoparquet", feature = "arrow"))]
pub mod parquet_text;
mod quiet;
#[cfg(feature = "shapefile")]
pub mod shapefile;
#[cfg(feature = "wkb")]
pub mod wkb;

use std::io::Read as _;
use std::path::Path;

use self::quiet::quiet;
use crate::missing;
use crate::row::Row;

/// The rows of a file.
pub struct MapFile {
    /// The rows in the order of the file.
    pub rows: Box<dyn Iterator<Item = Row>>,
    /// The coordinate system that the file names.
    pub crs: FileCrs,
    /// The names of all columns without the geometry; `None` for GeoJSON, whose rows may all have other ones.
    pub columns: Option<Vec<String>>,
}

impl MapFile {
    /// A file whose rows end with a reason if the library of its format panics, as some do for damaged files.
    fn new(rows: impl Iterator<Item = Row> + 'static, crs: FileCrs, columns: Option<Vec<String>>) -> Self {
        MapFile { rows: Box::new(Guarded { rows, number: 1, is_over: false }), crs, columns }
    }
}

/// Rows of a library that may panic.
struct Guarded<I> {
    rows: I,
    /// The number of the next row.
    number: u64,
    is_over: bool,
}

impl<I: Iterator<Item = Row>> Iterator for Guarded<I> {
    type Item = Row;

    fn next(&mut self) -> Option<Row> {
        if self.is_over {
            return None;
        }
        let row = quiet(|| self.rows.next()).unwrap_or_else(|| {
            self.is_over = true;
            Some(Row::damaged_end(self.number, "the file is damaged, and ends here".to_owned()))
        })?;
        self.number = row.number + 1;
        Some(row)
    }
}

/// The coordinate system of a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum FileCrs {
    /// The format or the file has a code of EPSG. Longitude and latitude on WGS 84 are 4326.
    Epsg(u32),
    /// The file has a coordinate system without a code.
    Unknown(String),
    /// The file has none.
    None,
}

/// The endings of files that [`open`] reads.
pub const ENDINGS: &str = ".geojson, .json, .geojsonl, .fgb, .shp and .parquet";

/// All of these endings, and their variants.
const ALL_ENDINGS: [&str; 9] =
    ["geojson", "json", "geojsonl", "geojsons", "ndjson", "fgb", "shp", "parquet", "geoparquet"];

/// Opens a file by its ending. `columns` are the names of the columns that the caller needs: GeoParquet reads no others.
///
/// # Errors
/// A sentence: the ending is another one, or the file cannot be read.
pub fn open(path: &Path, columns: &[String]) -> Result<MapFile, String> {
    path.metadata().map_err(|error| missing::unopened(path, &error, &ALL_ENDINGS))?;
    if let Some(kind) = packed(path) {
        return Err(format!("it is {kind}; unpack it first"));
    }
    quiet(|| open_unguarded(path, columns)).unwrap_or_else(|| Err("it is damaged".to_owned()))
}

/// The kind of a file that is packed, as many maps are.
fn packed(path: &Path) -> Option<&'static str> {
    if !path.is_file() {
        return None;
    }
    let mut head = [0; 6];
    let mut file = std::fs::File::open(path).ok()?;
    file.read_exact(&mut head).ok()?;
    Some(match head {
        [b'P', b'K', 3 | 5, ..] => "a ZIP archive",
        [0x1f, 0x8b, ..] => "a gzip file",
        [0xfd, b'7', b'z', b'X', b'Z', 0] => "an xz file",
        [b'7', b'z', 0xbc, 0xaf, ..] => "a 7z archive",
        [0x28, 0xb5, 0x2f, 0xfd, ..] => "a Zstandard file",
        _ => return None,
    })
}

fn open_unguarded(path: &Path, columns: &[String]) -> Result<MapFile, String> {
    let _ = columns;
    let ending = path.extension().map(|ending| ending.to_string_lossy().to_lowercase()).unwrap_or_default();
    match ending.as_str() {
        #[cfg(feature = "geojson")]
        "geojson" | "json" => geojson::read(file(path)?),
        #[cfg(feature = "geojson")]
        "geojsonl" | "geojsons" | "ndjson" => geojson::read_lines(file(path)?),
        #[cfg(feature = "flatgeobuf")]
        "fgb" => flatgeobuf::read(file(path)?),
        #[cfg(feature = "shapefile")]
        "shp" => shapefile::open(path),
        #[cfg(feature = "geoparquet")]
        "parquet" | "geoparquet" => geoparquet::open(path, columns),
        _ => Err(format!("its name ends in none of {ENDINGS}")),
    }
}

/// The note about a geometry of a collection that is not a polygon.
#[cfg(any(feature = "flatgeobuf", feature = "wkb", feature = "geojson"))]
fn left_out(kind: &str) -> String {
    format!("a {kind} of its collection was left out")
}

/// A file to read. A device may never end.
#[cfg(any(feature = "geojson", feature = "flatgeobuf"))]
fn file(path: &Path) -> Result<std::io::BufReader<std::fs::File>, String> {
    let file = std::fs::File::open(path).map_err(|why| why.to_string())?;
    if !file.metadata().map_err(|why| why.to_string())?.is_file() {
        return Err("it is not a regular file".to_owned());
    }
    Ok(std::io::BufReader::with_capacity(1 << 16, file))
}
