//! Columns that the command names, and the columns of the lots.

use std::collections::BTreeSet;

use cga_geo::row::Row;
use cga_geo::survey::Columns;
use cga_geo::{missing, plain};

/// The most names of columns that are kept for a message. Each feature of GeoJSON may have other ones.
const MOST: usize = 1000;

/// Finds columns that are named by an option and are in no file: probably their names are misspelt.
#[derive(Debug)]
pub(crate) struct NamedColumns {
    /// An option and the column that it names.
    named: Vec<(&'static str, String)>,
    found: BTreeSet<String>,
    rows: u64,
    /// The number of files whose columns are known only from their rows.
    without_schema: usize,
}

impl NamedColumns {
    pub(crate) fn new(columns: &Columns) -> Self {
        let named = columns.named().map(|(option, column)| (option, column.to_owned())).collect();
        NamedColumns { named, found: BTreeSet::new(), rows: 0, without_schema: 0 }
    }

    /// Adds the columns of a file.
    pub(crate) fn add_file(&mut self, columns: Option<&[String]>) {
        match columns {
            Some(names) => names.iter().for_each(|name| self.add(name)),
            None => self.without_schema += 1,
        }
    }

    /// Adds the columns of a row.
    pub(crate) fn add_row(&mut self, row: &Row) {
        self.rows += 1;
        row.columns.iter().for_each(|(name, _)| self.add(name));
    }

    fn add(&mut self, name: &str) {
        let is_kept = self.found.len() < MOST || self.named.iter().any(|(_, known)| known == name);
        if is_kept && !self.found.contains(name) {
            self.found.insert(name.to_owned());
        }
    }

    /// # Errors
    /// A sentence about a column that no file has, if all files have a list of their columns.
    pub(crate) fn check_files(&self) -> Result<(), String> {
        if self.without_schema == 0 { self.check("no file has it") } else { Ok(()) }
    }

    /// # Errors
    /// A sentence about a column that no row has. A city without rows has another fault.
    pub(crate) fn check_rows(&self) -> Result<(), String> {
        if self.rows == 0 { Ok(()) } else { self.check("no row has a value in it") }
    }

    fn check(&self, why: &str) -> Result<(), String> {
        let Some((option, name)) = self.named.iter().find(|(_, name)| !self.found.contains(name)) else {
            return Ok(());
        };
        let known = missing::names(name, "the lots", "columns", self.found.iter().map(String::as_str));
        Err(format!("{option}: the column `{}` is unknown, as {why}; {known}", plain::plain(name, 60)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn many_columns_take_little_memory() {
        let columns = Columns { id: Some("z".into()), ..Columns::default() };
        let mut named = NamedColumns::new(&columns);
        named.add_file(None);
        let mut row = Row::new(1, Ok(Vec::new()));
        row.columns = (0..5000).map(|number| (number.to_string(), cga_geo::column::ColumnValue::Truth(true))).collect();
        named.add_row(&row);
        assert_eq!((named.found.len(), named.check_files().is_ok(), named.check_rows().is_err()), (MOST, true, true));
        row.columns[0].0 = "z".to_owned();
        named.add_row(&row);
        assert!(named.check_rows().is_ok());
    }
}
