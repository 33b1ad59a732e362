//! Rows of map files.

use crate::column::ColumnValue;
use crate::outline::Outline;

/// The most corners of a row. Rows with more are reported: they are coast lines rather than buildings.
pub const MOST_CORNERS: usize = 20_000;

/// A row of a map file.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// Its number in the file, from 1.
    pub number: u64,
    /// The id that the format has beside its columns.
    pub id: Option<String>,
    /// The polygons, or the reason why the row has none.
    pub outlines: Result<Vec<Outline>, String>,
    /// The names and values of its columns, without missing values.
    pub columns: Vec<(String, ColumnValue)>,
    /// Faults of the row that were mended.
    pub notes: Vec<String>,
    /// True if the file is damaged and ends with this row: further rows may be missing.
    pub is_damaged_end: bool,
}

impl Row {
    /// A row without columns.
    pub fn new(number: u64, outlines: Result<Vec<Outline>, String>) -> Self {
        Row { number, id: None, outlines, columns: Vec::new(), notes: Vec::new(), is_damaged_end: false }
    }

    /// The last row of a damaged file, with the reason.
    pub fn damaged_end(number: u64, why: String) -> Self {
        Row { is_damaged_end: true, ..Row::new(number, Err(why)) }
    }

    /// The value of a column.
    pub fn column(&self, name: &str) -> Option<&ColumnValue> {
        self.columns.iter().find(|(known, _)| known == name).map(|(_, value)| value)
    }
}

/// The reason for a row with too many corners.
pub(crate) fn too_many_corners(count: usize) -> String {
    format!("it has {count} corners or more; at most {MOST_CORNERS} are used")
}
