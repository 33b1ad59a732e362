//! Cells of the square map: the world in the projection of web maps, divided into quarters again and again.

use std::fmt;
use std::ops::Range;

use cga_geo::outline::Corner;
use serde::{Deserialize, Serialize};

/// The depth of the smallest cells. On the equator they have a side of 15 cm.
pub const DEEPEST: u32 = 28;

/// A cell. Cells of one depth are ordered along a curve that visits the four quarters of a cell one after another, so the lots of
/// each cell are neighbours in the order of [`key`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
pub struct Cell {
    /// The number of divisions from the whole world.
    pub zoom: u32,
    /// The place on the curve among the cells of this depth.
    code: u64,
}

impl Cell {
    /// The whole world, up to latitudes of 85 degrees.
    pub const WORLD: Cell = Cell { zoom: 0, code: 0 };

    /// The depth from which a cell is one plane with its lots upright: at most 20 km wide. Two lots beside a meridian of the map may have no
    /// smaller cell around them than the world.
    pub const WIDEST_TILE: u32 = 11;

    /// The smallest cell with two keys.
    pub fn around(first: u64, last: u64) -> Self {
        let levels_up = (u64::BITS - (first ^ last).leading_zeros()).div_ceil(2);
        Cell { zoom: DEEPEST - levels_up, code: first >> (2 * levels_up) }
    }

    /// The cell of a depth with a key.
    pub fn with(key: u64, zoom: u32) -> Self {
        Cell { zoom, code: key >> (2 * (DEEPEST - zoom)) }
    }

    /// The cell of a depth at a column from the west and a row from the north.
    pub(crate) fn at(zoom: u32, place: [u64; 2]) -> Self {
        Cell { zoom, code: code(place) }
    }

    /// The four quarters, along the curve; `None` for the smallest cells.
    pub fn quarters(self) -> Option<[Cell; 4]> {
        let quarter = |number: u64| Cell { zoom: self.zoom + 1, code: self.code << 2 | number };
        (self.zoom < DEEPEST).then(|| [0, 1, 2, 3].map(quarter))
    }

    /// The keys of its places.
    pub fn keys(self) -> Range<u64> {
        let shift = 2 * (DEEPEST - self.zoom);
        self.code << shift..(self.code + 1) << shift
    }

    /// Its column from the west and its row from the north.
    pub fn place(self) -> [u64; 2] {
        [gathered(self.code), gathered(self.code >> 1)]
    }

    /// The longitude and latitude of its middle in degrees.
    pub fn middle(self) -> Corner {
        let count = (1u64 << self.zoom) as f64;
        let [x, y] = self.place().map(|number| (number as f64 + 0.5) / count);
        let latitude = libm::atan(libm::sinh(std::f64::consts::PI * (1.0 - 2.0 * y)));
        [x * 360.0 - 180.0, latitude.to_degrees()]
    }
}

/// Zoom, column and row, as in addresses of web maps.
impl fmt::Display for Cell {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [x, y] = self.place();
        write!(f, "{}/{x}/{y}", self.zoom)
    }
}

/// The number of the smallest cell at a longitude and latitude in degrees, along the curve.
pub fn key(place: Corner) -> u64 {
    let count = (1u64 << DEEPEST) as f64;
    code(self::place(place).map(|part| part.clamp(0.0, count - 1.0) as u64))
}

/// A longitude and latitude as column and row, with fractions, in sides of the smallest cells.
pub(crate) fn place([longitude, latitude]: Corner) -> [f64; 2] {
    let count = (1u64 << DEEPEST) as f64;
    let x = (longitude + 180.0) / 360.0;
    let y = (1.0 - libm::asinh(libm::tan(latitude.to_radians())) / std::f64::consts::PI) / 2.0;
    [x * count, y * count]
}

/// The number of a cell along the curve, by column and row.
fn code([x, y]: [u64; 2]) -> u64 {
    spread(x) | spread(y) << 1
}

/// The bits of a number at the even places.
fn spread(number: u64) -> u64 {
    (0..DEEPEST).fold(0, |out, bit| out | (number >> bit & 1) << (2 * bit))
}

/// The number of the bits at the even places.
fn gathered(code: u64) -> u64 {
    (0..DEEPEST).fold(0, |out, bit| out | (code >> (2 * bit) & 1) << bit)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cells_are_numbered_as_on_web_maps() {
        // The middle of Stuttgart, as addresses of web maps have it.
        let near = Cell::around(key([9.18, 48.775]), key([9.18, 48.775]));
        let at = |zoom: u32| near.place().map(|number| number >> (DEEPEST - zoom));
        assert_eq!(at(10), [538, 352]);
        assert_eq!(Cell::WORLD.to_string(), "0/0/0");
    }

    #[test]
    fn a_cell_has_the_keys_of_its_quarters() {
        let cell = Cell::around(key([9.0, 48.0]), key([9.3, 48.2]));
        let quarters = cell.quarters().expect("it is large");
        assert_eq!(cell.keys().start, quarters[0].keys().start);
        assert_eq!(cell.keys().end, quarters[3].keys().end);
        assert!(quarters.windows(2).all(|pair| pair[0].keys().end == pair[1].keys().start));
        assert!(cell.keys().contains(&key([9.0, 48.0])) && cell.keys().contains(&key([9.3, 48.2])));
        assert!(
            quarters
                .iter()
                .all(|quarter| !(quarter.keys().contains(&key([9.0, 48.0]))
                    && quarter.keys().contains(&key([9.3, 48.2]))))
        );
    }

    #[test]
    fn the_middle_of_a_cell_is_in_it() {
        for place in [[9.1, 48.7], [-179.99, -84.9], [179.99, 84.9], [0.0, 0.0]] {
            let cell = Cell::around(key(place), key([place[0], place[1] * 0.99]));
            assert!(cell.keys().contains(&key(cell.middle())), "{place:?}");
        }
    }
}
