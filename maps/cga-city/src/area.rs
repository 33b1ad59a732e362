//! Boxes on the square map, in sides of its smallest cells.

use cga_geo::footprint::Footprint;
use cga_geo::outline::Corner;
use serde::{Deserialize, Serialize};

use crate::cell::{self, Cell, DEEPEST};

/// The sides of the smallest cells around the world.
const SIDES: f64 = (1u64 << DEEPEST) as f64;

/// The side of a smallest cell on the equator, in metres.
const SIDE_METRES: f64 = 40_075_016.7 / SIDES;

/// The most parts of an area along an axis. More of them fit it closer.
const PARTS: f64 = 2.0;

/// The part of a cell in a box.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Part {
    /// No place of the cell.
    Nothing,
    /// Some places, perhaps.
    Some,
    /// All places.
    All,
}

/// A box on the map: columns from the west and rows from the north. Beside the meridian of 180 degrees it goes on beyond the map.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Area {
    /// The smallest column and row.
    pub low: [f64; 2],
    /// The largest column and row.
    pub high: [f64; 2],
}

impl Area {
    /// The box around a footprint, with its middle on the map.
    pub fn of(footprint: &Footprint) -> Self {
        let (middle, turn) = (footprint.middle()[0], longitude_of(footprint));
        let mut area = Area { low: [f64::INFINITY; 2], high: [f64::NEG_INFINITY; 2] };
        for &[longitude, latitude] in &footprint.rings[0] {
            area.add(cell::place([longitude + (middle - turn), latitude]));
        }
        area
    }

    fn add(&mut self, point: [f64; 2]) {
        for axis in [0, 1] {
            self.low[axis] = self.low[axis].min(point[axis]);
            self.high[axis] = self.high[axis].max(point[axis]);
        }
    }

    /// The box around this one and another one, which may be on the other side of the meridian of 180 degrees.
    pub fn join(mut self, other: Area) -> Area {
        let other = other.beside(&self);
        self.add(other.low);
        self.add(other.high);
        self
    }

    /// This box, moved around the world so that it is nearest to another one.
    fn beside(mut self, other: &Area) -> Area {
        let away = (self.low[0] + self.high[0] - other.low[0] - other.high[0]) / 2.0;
        let by = SIDES * (away / SIDES).round();
        self.low[0] -= by;
        self.high[0] -= by;
        self
    }

    /// The box with all places that are at most some metres away, and a little more: lots are compared as boxes of a plane that is turned
    /// against the map.
    pub fn around(mut self, metres: f64) -> Area {
        let metres = 1.05 * metres + 2.0;
        let side = self.low[1].min(SIDES - self.high[1]).clamp(0.0, SIDES / 2.0);
        // The side of a cell in metres shrinks towards the poles as 1 / cosh.
        let narrow = SIDE_METRES / libm::cosh(std::f64::consts::PI * (1.0 - 2.0 * side / SIDES));
        let wide = (self.high[0] - self.low[0]).max(self.high[1] - self.low[1]);
        self.grow(metres / narrow + 0.005 * wide);
        self
    }

    fn grow(&mut self, by: f64) {
        for axis in [0, 1] {
            self.low[axis] -= by;
            self.high[axis] += by;
        }
    }

    /// Returns true if the box has a place of another one.
    pub fn touches(&self, other: &Area) -> bool {
        let other = other.beside(self);
        [0, 1].into_iter().all(|axis| self.low[axis] <= other.high[axis] && other.low[axis] <= self.high[axis])
    }

    /// The class of a footprint by its size: at most 2 to this power of sides from its middle to its box.
    pub fn class(&self, middle: Corner) -> u8 {
        let middle = cell::place(middle);
        let reach = [0, 1].map(|axis| (middle[axis] - self.low[axis]).max(self.high[axis] - middle[axis]));
        let reach = reach[0].max(reach[1]);
        CLASSES.into_iter().find(|class| reach <= side_of(*class)).unwrap_or(DEEPEST as u8)
    }

    /// The box in which the middles of footprints of a class are that may touch this box.
    pub fn of_class(mut self, class: u8) -> Area {
        self.grow(side_of(class));
        self
    }

    /// Cells with all places of the box, along the curve. They have places around the box, too.
    pub(crate) fn cover(&self) -> Vec<Cell> {
        let wide = (self.high[0] - self.low[0]).max(self.high[1] - self.low[1]);
        let depth = (0..DEEPEST).find(|bits| wide <= PARTS * side_of(*bits as u8)).unwrap_or(DEEPEST);
        self.cells(DEEPEST - depth)
    }

    /// The cells of a depth that have places of the box, along the curve.
    pub fn cells(&self, zoom: u32) -> Vec<Cell> {
        let (count, side) = (1i64 << zoom, side_of((DEEPEST - zoom) as u8));
        let part = |number: f64| (number / side).floor() as i64;
        let [columns, rows] = [0, 1].map(|axis| part(self.low[axis])..=part(self.high[axis]));
        let mut cells = Vec::new();
        for column in columns.take(count as usize) {
            for row in rows.clone().filter(|row| (0..count).contains(row)) {
                cells.push(Cell::at(zoom, [column.rem_euclid(count) as u64, row as u64]));
            }
        }
        cells.sort_unstable();
        cells
    }

    /// The box of a cell.
    fn of_cell(cell: Cell) -> Self {
        let side = side_of((DEEPEST - cell.zoom) as u8);
        let low = cell.place().map(|part| part as f64 * side);
        Area { low, high: low.map(|part| part + side) }
    }

    /// The part of a cell in the box. Places on a border are in the box.
    pub(crate) fn part_of(&self, cell: Cell) -> Part {
        let other = Area::of_cell(cell).beside(self);
        if !self.touches(&other) {
            return Part::Nothing;
        }
        let is_inside =
            [0, 1].into_iter().all(|axis| self.low[axis] <= other.low[axis] && other.high[axis] <= self.high[axis]);
        // The smallest cells are not divided.
        if is_inside || cell.zoom == DEEPEST { Part::All } else { Part::Some }
    }

    /// The box of the smallest cell with a key.
    pub fn of_key(key: u64) -> Self {
        Area::of_cell(Cell::with(key, DEEPEST))
    }

    /// Returns true if the box has a place of the smallest cell with a key.
    pub fn has(&self, key: u64) -> bool {
        self.touches(&Area::of_key(key))
    }
}

/// The classes of footprints by size. The first one has buildings up to 300 m on the equator, the last one all.
pub(crate) const CLASSES: [u8; 8] = [10, 12, 14, 16, 18, 20, 22, DEEPEST as u8];

fn side_of(class: u8) -> f64 {
    (1u64 << class) as f64
}

/// The longitude of the middle of a footprint, before it is turned to the map.
fn longitude_of(footprint: &Footprint) -> f64 {
    cga_geo::outline::centroid(&footprint.rings[0])[0]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn square([longitude, latitude]: Corner, metres: f64) -> Footprint {
        let [east, north] = cga_geo::frame::metres_a_degree(latitude).map(|degree| metres / degree);
        let ring = vec![
            [longitude, latitude],
            [longitude + east, latitude],
            [longitude + east, latitude + north],
            [longitude, latitude + north],
        ];
        Footprint {
            id: String::new(),
            seed: 0,
            grammar: None,
            start: None,
            values: Vec::new(),
            rings: vec![ring],
            base: 0.0,
        }
    }

    #[test]
    fn areas_have_the_places_within_their_distance() {
        for place in [[9.1, 48.7], [179.9999, -30.0], [-179.99995, 70.0], [0.0, 84.9], [20.0, -84.9]] {
            let own = Area::of(&square(place, 10.0));
            let [east, north] = cga_geo::frame::metres_a_degree(place[1]);
            for [x, y] in [[59.0, 0.0], [-59.0, 0.0], [0.0, 59.0], [0.0, -59.0], [59.0, 59.0]] {
                let beside = |times: f64| {
                    let longitude = place[0] + times * x / east;
                    let turned = longitude - 360.0 * (longitude / 360.0).round();
                    square([turned, place[1] + times * y / north], 10.0)
                };
                let (near, far) = (Area::of(&beside(1.0)), Area::of(&beside(3.0)));
                let around = own.around(50.0);
                assert!(around.touches(&near) && near.touches(&around), "{place:?} {x} {y}");
                assert!(!around.touches(&far), "{place:?} {x} {y}");
                // Keys of the middles are in the ranges.
                let key = cell::key(beside(1.0).middle());
                let wide = around.of_class(near.class(beside(1.0).middle()));
                assert!(
                    wide.has(key) && wide.cover().iter().any(|cell| cell.keys().contains(&key)),
                    "{place:?} {x} {y}"
                );
            }
        }
    }

    #[test]
    fn classes_follow_sizes_and_ranges_are_few() {
        let class = |metres| Area::of(&square([9.0, 48.0], metres)).class(square([9.0, 48.0], metres).middle());
        assert_eq!([class(10.0), class(150.0), class(500.0), class(19_000.0)], [10, 10, 12, 18]);
        let area = Area::of(&square([9.0, 48.0], 10.0)).around(100.0).of_class(10);
        assert!(area.cover().len() <= 9);
        let world = area.of_class(DEEPEST as u8);
        assert_eq!(world.cover(), [Cell::WORLD]);
    }
}
