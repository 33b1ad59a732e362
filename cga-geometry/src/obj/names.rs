//! Names with numbers, for the groups and materials of files.

use std::collections::HashMap;

/// Names in the order of their first use.
#[derive(Debug, Default)]
pub struct Names {
    list: Vec<String>,
    index: HashMap<String, u32>,
}

impl Names {
    /// The number of a name.
    pub fn number(&mut self, name: &str) -> u32 {
        *self.index.entry(name.to_owned()).or_insert_with(|| {
            self.list.push(name.to_owned());
            (self.list.len() - 1) as u32
        })
    }

    /// The names, by number.
    pub fn into_list(self) -> Vec<String> {
        self.list
    }
}
