//! The buildings of a file, while leaves come.

use crate::run::building::Building;

/// Numbers for leaves inside and outside of buildings, in the order of the leaves.
#[derive(Debug, Default)]
pub(super) struct BuildingList {
    /// The number that the next leaf gets.
    next: u32,
    /// The buildings with the numbers of their leaves.
    list: Vec<(u32, Building)>,
    /// The building whose leaves come now; it has its name and its seed alone.
    open: Option<Building>,
}

impl BuildingList {
    /// The number that the next leaf gets.
    #[inline]
    pub(super) fn next(&self) -> u32 {
        self.next
    }

    /// Returns true before the first building.
    pub(super) fn is_empty(&self) -> bool {
        self.list.is_empty() && self.open.is_none()
    }

    /// The leaves that follow belong to another building.
    pub(super) fn begin(&mut self, name: &str, seed: u64) {
        self.close();
        self.next += 1;
        self.open = Some(Building::new(name, seed));
    }

    /// The building is complete; leaves that follow belong to none.
    pub(super) fn end(&mut self, building: Building) {
        self.open = Some(building);
        self.close();
    }

    fn close(&mut self) {
        if let Some(open) = self.open.take() {
            self.list.push((self.next, open));
            self.next += 1;
        }
    }

    /// The rows of the table, and the row of each number. The rows are the buildings in order, and a row without data for the leaves
    /// between two buildings, if the file has such leaves. `used` are the numbers of all leaves. A file without buildings has no rows.
    pub(super) fn into_rows(mut self, used: &[u32]) -> (Vec<Building>, Vec<u32>) {
        self.close();
        let mut row_of = vec![0; self.next as usize + 1];
        if self.list.is_empty() {
            return (Vec::new(), row_of);
        }
        let mut data: Vec<Option<Building>> = vec![None; row_of.len()];
        used.iter().for_each(|number| data[*number as usize] = Some(Building::default()));
        self.list.into_iter().for_each(|(number, building)| data[number as usize] = Some(building));
        let mut rows = Vec::new();
        for (row, building) in row_of.iter_mut().zip(data) {
            *row = rows.len() as u32;
            rows.extend(building);
        }
        (rows, row_of)
    }
}
