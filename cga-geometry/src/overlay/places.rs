//! Distinct places of the grid, by number.

use std::collections::HashMap;

use super::grid::GridPoint;

/// The number of tables. A table that grows moves its own places alone, so that no step takes long.
const TABLES: usize = 64;

/// Places by number. Given points may be at one place, which then has the number of the first one.
pub(super) struct Places {
    pub(super) list: Vec<GridPoint>,
    numbers: Vec<HashMap<GridPoint, u32>>,
}

impl Places {
    /// The places of given points.
    pub(super) fn of(list: Vec<GridPoint>) -> Self {
        let mut places = Places { numbers: vec![HashMap::new(); TABLES], list };
        for (number, place) in (0..).zip(&places.list) {
            places.numbers[table(*place)].entry(*place).or_insert(number);
        }
        places
    }

    /// The place with a number.
    pub(super) fn at(&self, number: u32) -> GridPoint {
        self.list[number as usize]
    }

    /// The number of a place, which is added if it is new.
    pub(super) fn number(&mut self, place: GridPoint) -> u32 {
        let next = self.list.len() as u32;
        let number = *self.numbers[table(place)].entry(place).or_insert(next);
        if number == next {
            self.list.push(place);
        }
        number
    }
}

/// The table of a place.
fn table(place: GridPoint) -> usize {
    const FACTOR: u64 = 0x9E37_79B9_7F4A_7C15;
    let hash = (place.x as u64).wrapping_mul(FACTOR).rotate_left(32) ^ place.y as u64;
    (hash.wrapping_mul(FACTOR) >> (u64::BITS - TABLES.ilog2())) as usize
}
