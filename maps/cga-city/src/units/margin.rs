//! The lots around units: a unit whose rules ask about neighbours reads the lots of other units near its own.
//!
//! `cga-city` compares the lots of a tile with all lots whose middle is near the box around the tile. A tile has the lots of one cell of the
//! depth [`Cell::WIDEST_TILE`] at most, so the boxes of such cells, each around the lots of a unit, have all that a tile of the unit may find.

use std::collections::HashMap;

use crate::area::Area;
use crate::cell::Cell;

/// Classes of footprints above this one touch many cells, and are compared with all boxes.
const MOST_CLASS: u8 = 20;

/// The boxes of units by the cells that they touch.
#[derive(Debug, Default)]
pub struct Margins {
    boxes: Vec<(usize, Area)>,
    of_cell: HashMap<Cell, Vec<u32>>,
}

impl Margins {
    /// The boxes of units, each with the boxes around its lots.
    pub fn new<'u>(units: impl IntoIterator<Item = &'u [Area]>) -> Self {
        let mut margins = Margins::default();
        for (number, areas) in units.into_iter().enumerate() {
            for area in areas {
                for cell in area.cells(Cell::WIDEST_TILE) {
                    margins.of_cell.entry(cell).or_default().push(margins.boxes.len() as u32);
                }
                margins.boxes.push((number, *area));
            }
        }
        margins
    }

    /// The units that may find a lot with a key and a class of sizes (see [`Area::class`]), in ascending order, each once.
    pub fn units(&self, key: u64, class: u8) -> Vec<usize> {
        let has = |(_, area): &&(usize, Area)| area.of_class(class).has(key);
        let mut units: Vec<usize> = if class <= MOST_CLASS && !self.boxes.is_empty() {
            // The box of a unit is within this distance of the middle of the lot.
            let near = Area::of_key(key).of_class(class).cells(Cell::WIDEST_TILE);
            let boxes = near.iter().filter_map(|cell| self.of_cell.get(cell)).flatten();
            boxes.map(|at| &self.boxes[*at as usize]).filter(has).map(|(unit, _)| *unit).collect()
        } else {
            self.boxes.iter().filter(has).map(|(unit, _)| *unit).collect()
        };
        units.sort_unstable();
        units.dedup();
        units
    }
}

/// The boxes around the counted cells of a unit, joined within each cell of the widest tiles. Rules find lots up to some metres away.
pub fn areas(cells: impl Iterator<Item = (u64, Option<Area>)>, metres: f64) -> Vec<Area> {
    let mut areas: Vec<(Cell, Area)> = Vec::new();
    for (key, area) in cells {
        let (cell, Some(area)) = (Cell::with(key, Cell::WIDEST_TILE), area) else { continue };
        match areas.last_mut() {
            Some((last, joined)) if *last == cell => *joined = joined.join(area),
            _ => areas.push((cell, area)),
        }
    }
    // One metre more than a tile reads.
    areas.into_iter().map(|(_, area)| area.around(metres + 1.0)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cell::{DEEPEST, key};
    use crate::units::plan::{COUNTED, Count, Plan, Unit};

    /// The box of some smallest cells around a place.
    fn around(place: [f64; 2], sides: f64) -> Area {
        let Area { low, high } = Area::of_key(key(place));
        Area { low: low.map(|part| part - sides), high: high.map(|part| part + sides) }
    }

    #[test]
    fn units_near_a_lot_are_found_as_a_search_of_all_finds_them() {
        let mut random = 3u64;
        let mut number = || {
            random = random.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (random >> 11) as f64 / (1u64 << 53) as f64
        };
        // On both sides of the meridian of 180 degrees, and near a corner of four large cells.
        let mut place = |at: usize| {
            let [x, y] = [0, 1].map(|_| 0.4 * number() - 0.2);
            if at.is_multiple_of(2) {
                [if x < 0.0 { 180.0 + x } else { x - 180.0 }, 66.0 + y]
            } else {
                [9.140625 + x, 48.0 + y]
            }
        };
        let mut cells: HashMap<u64, Count> = HashMap::new();
        for at in 0..400 {
            let place = place(at);
            let (key, area) = (key(place), around(place, 60.0));
            let cell = cells.entry(key >> (2 * (DEEPEST - COUNTED))).or_insert(Count {
                lots: 0,
                bytes: 0,
                keys: [key; 2],
                sums: [0; 2],
                area: None,
            });
            cell.lots += 1;
            cell.keys = [cell.keys[0].min(key), cell.keys[1].max(key)];
            cell.area = Some(cell.area.map_or(area, |own| own.join(area)));
        }
        let plan = Plan::new("w".into(), "d", cells.into_values().collect(), 3, 200, 100.0);
        assert!(20 < plan.units.len());
        let margins = Margins::new(plan.units.iter().map(|unit| &unit.areas[..]));
        let mut found = 0;
        for at in 0..4000 {
            let (key, class) = (key(place(at)), [10, 12, 14, 16, 18, 20, 22, 28][at % 8]);
            let is_near = |unit: &Unit| unit.areas.iter().any(|area| area.of_class(class).has(key));
            let expected: Vec<usize> = (0..plan.units.len()).filter(|at| is_near(&plan.units[*at])).collect();
            assert_eq!(margins.units(key, class), expected, "class {class}");
            found += expected.len();
        }
        assert!(2000 < found);
    }
}
