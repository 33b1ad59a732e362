//! The units of a city: the parts of a city that are made by one call on one machine.
//!
//! `cga-city` cuts the curve of all lots into blocks by their numbers alone. A unit is a piece of that tree with one block or several whole ones,
//! so a unit, made from its lots alone, has the same blocks.

use serde::{Deserialize, Serialize};

use super::lot::{Sums, UnitLot};
use super::margin::{Margins, areas};
use crate::area::Area;
use crate::cell::{Cell, DEEPEST};

/// The depth of the cells whose lots are counted: 2.4 km wide on the equator. A unit has at least one of them.
pub const COUNTED: u32 = 14;

/// The number of the counted cell with a key.
pub fn counted(key: u64) -> u64 {
    key >> (2 * (DEEPEST - COUNTED))
}

/// The lots of a counted cell, or of several neighbours.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Count {
    /// The number of lots.
    pub lots: u64,
    /// The bytes of their footprints.
    pub bytes: u64,
    /// The first and the last key.
    pub keys: [u64; 2],
    /// The sums of the lower and of the upper halves of 64 bits of their digests.
    pub sums: [u64; 2],
    /// The box around the lots whose rules ask about neighbours.
    pub area: Option<Area>,
}

impl Count {
    /// A lot.
    pub fn of(lot: &UnitLot) -> Self {
        let Sums { lots, bytes, digests } = lot.sums;
        Count { lots, bytes, keys: [lot.key; 2], sums: digests, area: lot.area }
    }

    /// Adds other lots of the same cell.
    pub fn add(&mut self, other: Count) {
        let mut sums = self.sums();
        sums.add(other.sums());
        (self.lots, self.bytes, self.sums) = (sums.lots, sums.bytes, sums.digests);
        self.keys = [self.keys[0].min(other.keys[0]), self.keys[1].max(other.keys[1])];
        self.area = match (self.area, other.area) {
            (Some(own), Some(other)) => Some(own.join(other)),
            (own, other) => own.or(other),
        };
    }

    /// Its lots in numbers.
    pub fn sums(&self) -> Sums {
        Sums { lots: self.lots, bytes: self.bytes, digests: self.sums }
    }
}

/// A unit.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Unit {
    /// Its lots.
    pub count: Count,
    /// The boxes around its lots whose rules ask about neighbours, with the distance to those.
    pub areas: Vec<Area>,
    /// The number of lots that it reads: its own, and the lots of other units around them.
    pub read_lots: u64,
    /// The bytes of their footprints.
    pub read_bytes: u64,
    /// The digest of all that its tiles depend on.
    pub digest: String,
}

impl Unit {
    /// The smallest cell around its lots.
    pub fn cell(&self) -> Cell {
        let [first, last] = self.count.keys;
        Cell::around(first, last)
    }

    /// The name of its file in the store.
    pub fn name(&self) -> String {
        format!("units/{}.json", self.cell())
    }

    /// Sets the lots that it reads.
    pub fn set_read(&mut self, read: Sums) {
        let Sums { lots, bytes, digests: [low, high] } = read;
        (self.read_lots, self.read_bytes) = (lots, bytes);
        let mut hasher = blake3::Hasher::new();
        hasher.update(self.digest.as_bytes());
        [lots, bytes, low, high].iter().for_each(|number| {
            hasher.update(&number.to_le_bytes());
        });
        self.digest = hasher.finalize().to_hex().to_string();
    }
}

/// The units of a city along the curve.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Plan {
    /// The name of the work in the store.
    pub work: String,
    /// The digest of the work on the client, with its assets.
    pub digest: String,
    /// The units.
    pub units: Vec<Unit>,
}

impl Plan {
    /// The units of counted cells. A unit has at most `most` lots, unless it is a single block or a single cell. Rules find lots up to some metres
    /// away.
    pub fn new(work: String, digest: &str, mut cells: Vec<Count>, most: u64, block_lots: u64, metres: f64) -> Self {
        cells.sort_by_key(|cell| cell.keys);
        let mut units = Vec::new();
        cut(&cells, most, block_lots, &mut |cells| {
            let count = sum(cells);
            let mut hasher = blake3::Hasher::new();
            hasher.update(digest.as_bytes());
            let numbers = cells.iter().flat_map(|cell| [[cell.lots, cell.bytes], cell.keys, cell.sums]);
            numbers.flatten().for_each(|number| {
                hasher.update(&number.to_le_bytes());
            });
            let areas = areas(cells.iter().map(|cell| (cell.keys[0], cell.area)), metres);
            let digest = hasher.finalize().to_hex().to_string();
            units.push(Unit { count, areas, read_lots: count.lots, read_bytes: count.bytes, digest });
        });
        Plan { work, digest: digest.to_owned(), units }
    }

    /// Returns true if units read lots of others.
    pub fn has_margins(&self) -> bool {
        self.units.iter().any(|unit| !unit.areas.is_empty())
    }

    /// The number of the unit with a key; `None` if the lots have changed since they were counted.
    pub fn unit(&self, key: u64) -> Option<usize> {
        let after = self.units.partition_point(|unit| unit.count.keys[0] <= key);
        let at = after.checked_sub(1)?;
        (key <= self.units[at].count.keys[1]).then_some(at)
    }
}

/// Cuts as `Trees::cut` does, down to counted cells.
fn cut(cells: &[Count], most: u64, block_lots: u64, unit: &mut impl FnMut(&[Count])) {
    if cells.is_empty() {
        return;
    }
    let Count { lots, keys: [first, last], .. } = sum(cells);
    let cell = Cell::around(first, last);
    let is_block = lots <= block_lots && Cell::WIDEST_TILE <= cell.zoom;
    let quarters = cell.quarters().filter(|_| cell.zoom < COUNTED);
    let (Some(quarters), false) = (quarters, lots <= most || is_block) else { return unit(cells) };
    let mut rest = cells;
    for quarter in quarters {
        let (part, others) = rest.split_at(rest.partition_point(|cell| cell.keys[0] < quarter.keys().end));
        cut(part, most, block_lots, unit);
        rest = others;
    }
}

fn sum(cells: &[Count]) -> Count {
    let mut all = Count { lots: 0, bytes: 0, keys: [u64::MAX, 0], sums: [0; 2], area: None };
    cells.iter().for_each(|cell| all.add(Count { area: None, ..*cell }));
    all
}

/// A plan that finds the units of lots.
#[derive(Debug)]
pub struct PlanIndex {
    /// The plan.
    pub plan: Plan,
    margins: Margins,
}

impl PlanIndex {
    /// An index of a plan.
    pub fn new(plan: Plan) -> Self {
        PlanIndex { margins: Margins::new(plan.units.iter().map(|unit| &unit.areas[..])), plan }
    }

    /// The units that read a lot with a key and a class of sizes (see [`Area::class`]): its own one, and others whose rules may find it.
    pub fn units(&self, key: u64, class: u8) -> Vec<usize> {
        let mut units = self.margins.units(key, class);
        if let Some(own) = self.plan.unit(key)
            && !units.contains(&own)
        {
            units.push(own);
        }
        units
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Counted cells with some lots each, at places of the curve.
    fn cells(places: &[(u64, u64)]) -> Vec<Count> {
        let cell = |&(place, lots): &(u64, u64)| {
            let first = place << (2 * (DEEPEST - COUNTED));
            Count { lots, bytes: 300 * lots, keys: [first + 5, first + 70_000_000], sums: [lots, 1], area: None }
        };
        places.iter().map(cell).collect()
    }

    #[test]
    fn units_have_all_lots_once_and_are_small() {
        let places: Vec<(u64, u64)> = (0..500).map(|at| (at * at * 37 % 100_003, 1 + at % 90)).collect();
        let all = cells(&places);
        for most in [1, 100, 1000, 1 << 40] {
            let plan = Plan::new("w".into(), "d", all.clone(), most, 200, 0.0);
            let lots: u64 = plan.units.iter().map(|unit| unit.count.lots).sum();
            assert_eq!(lots, all.iter().map(|cell| cell.lots).sum::<u64>());
            assert!(plan.units.windows(2).all(|pair| pair[0].count.keys[1] < pair[1].count.keys[0]));
            for unit in &plan.units {
                let is_block = unit.count.lots <= 200 && Cell::WIDEST_TILE <= unit.cell().zoom;
                assert!(unit.count.lots <= most || is_block, "{unit:?}");
            }
            for cell in &all {
                let unit = plan.unit(cell.keys[0]).expect("a unit");
                assert_eq!(plan.unit(cell.keys[1]), Some(unit));
                assert!(plan.units[unit].cell().keys().contains(&cell.keys[0]));
            }
        }
    }

    #[test]
    fn the_order_of_counts_does_not_matter_and_each_count_does() {
        let mut all = cells(&[(9, 5), (700, 6), (80_000, 7)]);
        let plan = |cells: &[Count]| Plan::new("w".into(), "d", cells.to_vec(), 10, 200, 0.0);
        let first = plan(&all);
        all.reverse();
        assert_eq!(plan(&all), first);
        all[1].sums[0] += 1;
        assert_ne!(plan(&all), first);
        assert_eq!(first.unit(1), None);
    }
}
