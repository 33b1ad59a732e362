//! FlatGeobuf.

use std::io::{self, BufRead, Read, Seek};

use ::flatgeobuf::geozero::FeatureProperties as _;
use ::flatgeobuf::packed_r_tree::PackedRTree;
use ::flatgeobuf::{
    FallibleStreamingIterator as _, FeatureIter, FgbFeature, FgbReader, GeozeroGeometry as _, NotSeekable,
};

use super::collector::Collector;
use super::quiet::quiet;
use super::{FileCrs, MapFile};
use crate::row::Row;

/// Reads the features of a file.
///
/// # Errors
/// The file does not begin as FlatGeobuf does.
pub fn read(mut input: impl BufRead + Seek + 'static) -> Result<MapFile, String> {
    // The library takes memory for the length that a damaged feature says, up to 4 GB.
    let (whole, is_cut) = quiet(|| whole_features(&mut input)).unwrap_or_else(|| Err("it is damaged".to_owned()))?;
    input.rewind().map_err(|why| why.to_string())?;
    let reader = FgbReader::open(input).map_err(not_flatgeobuf)?;
    let crs = match reader.header().crs() {
        Some(crs) if 0 < crs.code() && crs.org().is_none_or(|org| org.eq_ignore_ascii_case("EPSG")) => {
            FileCrs::Epsg(crs.code() as u32)
        }
        Some(crs) => FileCrs::Unknown(crs.name().or(crs.wkt()).unwrap_or("without a name").to_owned()),
        None => FileCrs::None,
    };
    let columns = reader.header().columns().into_iter().flatten().map(|column| column.name().to_owned()).collect();
    let features = reader.select_all_seq().map_err(|why| format!("it cannot be read: {why}"))?;
    let count = features.features_count().map(|count| count as u64);
    Ok(MapFile::new(Rows { features, number: 0, count, whole, is_cut, is_over: false }, crs, Some(columns)))
}

fn not_flatgeobuf(why: ::flatgeobuf::Error) -> String {
    format!("it is not FlatGeobuf: {why}")
}

/// The number of features that are whole, and whether another one is longer than the rest of the file.
fn whole_features(mut input: &mut (impl BufRead + Seek)) -> Result<(u64, bool), String> {
    let reader = FgbReader::open(&mut input).map_err(not_flatgeobuf)?;
    let header = reader.header();
    let (count, node) = (header.features_count() as usize, header.index_node_size());
    let index = if 0 < node && 0 < count { PackedRTree::index_size(count, node) as u64 } else { 0 };
    let unread = |why: io::Error| why.to_string();
    if io::copy(&mut input.by_ref().take(index), &mut io::sink()).map_err(unread)? < index {
        return Ok((0, true));
    }
    let mut features = 0;
    loop {
        let mut length = [0; 4];
        match input.read_exact(&mut length) {
            Err(why) if why.kind() == io::ErrorKind::UnexpectedEof => return Ok((features, false)),
            read => read.map_err(unread)?,
        }
        let length = u64::from(u32::from_le_bytes(length));
        let read = io::copy(&mut input.by_ref().take(length), &mut io::sink()).map_err(unread)?;
        if read < length {
            return Ok((features, true));
        }
        features += 1;
    }
}

fn row(number: u64, feature: &FgbFeature) -> Row {
    let mut collector = Collector::default();
    let read = match feature.geometry() {
        Some(_) => feature.process_geom(&mut collector),
        None => Ok(()),
    };
    let mut outlines = collector.outlines(read);
    if let Err(why) = feature.process_properties(&mut collector) {
        outlines = Err(format!("its columns cannot be read: {why}"));
    }
    Row { columns: collector.columns, notes: collector.notes, ..Row::new(number, outlines) }
}

struct Rows<R> {
    features: FeatureIter<R, NotSeekable>,
    /// The number of rows so far.
    number: u64,
    /// The number of features that the file announces.
    count: Option<u64>,
    /// The number of features that are whole.
    whole: u64,
    /// True if another feature is longer than the rest of the file.
    is_cut: bool,
    is_over: bool,
}

impl<R: Read> Rows<R> {
    /// The last row, which says why the file ends early.
    fn end(&mut self, why: &str) -> Option<Row> {
        self.is_over = true;
        let announced = self.count.map_or(String::new(), |count| format!(" of {count} features"));
        let why = format!("the file ends after {}{announced}: {why}", self.number);
        Some(Row::damaged_end(self.number + 1, why))
    }
}

impl<R: Read> Iterator for Rows<R> {
    type Item = Row;

    fn next(&mut self) -> Option<Row> {
        if self.is_over {
            return None;
        }
        if self.is_cut && self.number == self.whole {
            return self.end("a feature is longer than the rest of the file");
        }
        match self.features.next() {
            Ok(Some(feature)) => {
                // The library panics where lengths in a feature are wrong.
                self.number += 1;
                let row = quiet(|| row(self.number, feature));
                Some(row.unwrap_or_else(|| Row::new(self.number, Err("it is damaged".to_owned()))))
            }
            Ok(None) => {
                self.is_over = true;
                match self.count {
                    Some(count) if self.number < count => self.end("further features are missing"),
                    _ => None,
                }
            }
            Err(why) => self.end(&why.to_string()),
        }
    }
}
