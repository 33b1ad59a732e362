//! Stores that list their files, for cities that are made in units.

use std::fs;
use std::io;

use crate::leftovers::{delete_below, is_part_of_file};
use crate::store::{Folder, Store};

/// A store that lists its files.
pub trait UnitStore: Store {
    /// Returns true if the store has no file.
    ///
    /// # Errors
    /// Errors of the store.
    fn is_empty(&self) -> io::Result<bool>;

    /// Reads several files, `None` for a file that does not exist. A store of a network reads some at a time.
    ///
    /// # Errors
    /// Errors of the store.
    fn read_all(&self, names: Vec<String>) -> io::Result<Vec<Option<Vec<u8>>>> {
        names.iter().map(|name| self.read(name)).collect()
    }

    /// Deletes the files of a folder that a function chooses by their names.
    ///
    /// # Errors
    /// Errors of the store.
    fn delete_where(&self, folder: &str, is_other: &dyn Fn(&str) -> bool) -> io::Result<()>;

    /// Deletes the parts of files that a machine left in a folder when it was lost. `is_own` returns true for the name of a file of a city.
    ///
    /// # Errors
    /// Errors of the store.
    fn delete_parts(&self, folder: &str, is_own: &dyn Fn(&str) -> bool) -> io::Result<()>;
}

impl UnitStore for Folder {
    fn is_empty(&self) -> io::Result<bool> {
        match fs::read_dir(&self.0) {
            Err(why) if why.kind() == io::ErrorKind::NotFound => Ok(true),
            entries => Ok(entries?.next().is_none()),
        }
    }

    fn delete_where(&self, folder: &str, is_other: &dyn Fn(&str) -> bool) -> io::Result<()> {
        delete_below(&self.0, folder, is_other)
    }

    fn delete_parts(&self, folder: &str, _: &dyn Fn(&str) -> bool) -> io::Result<()> {
        delete_below(&self.0, folder, &is_part_of_file)
    }
}
