//! Heights of the ground.

use std::io::BufRead;

use crate::outline::Corner;

/// The height of the ground. Lots stand at the lowest height of their corners, so that no wall ends above the ground.
pub trait Terrain: Send + Sync {
    /// The height in metres at a place, in the coordinates of the file of lots. `None` where it is not known.
    fn height(&self, place: Corner) -> Option<f64>;
}

/// A function is a terrain.
impl<F: Fn(Corner) -> Option<f64> + Send + Sync> Terrain for F {
    fn height(&self, place: Corner) -> Option<f64> {
        self(place)
    }
}

/// A grid of heights, as text: the ASCII grid of Esri, which most programs for maps write (`.asc`). Heights between the centres of its
/// cells are interpolated.
///
/// ```
/// use cga_geo::terrain::{AsciiGrid, Terrain as _};
///
/// let text = "ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 10\n100 110\n120 -9999\n";
/// let grid = AsciiGrid::read(text.as_bytes())?;
/// assert_eq!(grid.height([5.0, 15.0]), Some(100.0));
/// assert_eq!(grid.height([15.0, 5.0]), None);
/// # Ok::<(), String>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct AsciiGrid {
    columns: usize,
    rows: usize,
    /// The centre of the lowest cell to the left.
    first: Corner,
    cell: f64,
    /// Heights from the top row on; NaN where they are not known.
    heights: Vec<f32>,
}

/// The most cells of a grid: 400 MB.
const MOST_CELLS: usize = 100_000_000;

impl AsciiGrid {
    /// Reads a grid.
    ///
    /// # Errors
    /// A sentence about the text.
    pub fn read(mut input: impl BufRead) -> Result<Self, String> {
        let mut head = Head::default();
        let mut line = String::new();
        let mut heights: Vec<f32> = Vec::new();
        let mut count = None;
        loop {
            line.clear();
            if input.read_line(&mut line).map_err(|why| why.to_string())? == 0 {
                break;
            }
            let mut words = line.split_whitespace().peekable();
            if count.is_none() && words.peek().is_some_and(|word| word.starts_with(char::is_alphabetic)) {
                head.add(&line)?;
                continue;
            }
            let count = match count {
                Some(count) => count,
                None => *count.insert(head.count()?),
            };
            for word in words {
                let height: f64 = word.parse().map_err(|_| format!("`{word}` is not a height"))?;
                if count == heights.len() {
                    return Err(format!("it has more than {count} heights"));
                }
                let known = height.is_finite() && Some(height) != head.no_data;
                heights.push(if known { height as f32 } else { f32::NAN });
            }
        }
        let count = count.ok_or("it has no heights")?;
        if heights.len() != count {
            return Err(format!("it has {} heights of {count}", heights.len()));
        }
        Ok(AsciiGrid { columns: head.columns, rows: head.rows, first: head.first(), cell: head.cell, heights })
    }

    /// The height of a cell, from the lowest row on.
    fn cell(&self, column: usize, row: usize) -> Option<f64> {
        let height = *self.heights.get((self.rows - 1 - row) * self.columns + column)?;
        (!height.is_nan()).then_some(f64::from(height))
    }
}

impl Terrain for AsciiGrid {
    fn height(&self, [x, y]: Corner) -> Option<f64> {
        let place = [(x - self.first[0]) / self.cell, (y - self.first[1]) / self.cell];
        let counts = [self.columns, self.rows];
        // Half a cell beyond the outer centres belongs to the grid.
        let inside = |axis: usize| -0.5 <= place[axis] && place[axis] <= counts[axis] as f64 - 0.5;
        if !(inside(0) && inside(1)) {
            return None;
        }
        let low =
            |axis: usize| (place[axis].clamp(0.0, (counts[axis] - 1) as f64).floor() as usize).min(counts[axis] - 1);
        let (column, row) = (low(0), low(1));
        let next = [(column + 1).min(self.columns - 1), (row + 1).min(self.rows - 1)];
        let part = |at: f64, low: usize| (at - low as f64).clamp(0.0, 1.0);
        let (u, v) = (part(place[0], column), part(place[1], row));
        let below = [self.cell(column, row), self.cell(next[0], row)];
        let above = [self.cell(column, next[1]), self.cell(next[0], next[1])];
        // A corner that is not known counts only if the place is at it.
        let mix = |[a, b]: [Option<f64>; 2], part: f64| match (a, b) {
            (Some(a), _) if part == 0.0 => Some(a),
            (_, Some(b)) if part == 1.0 => Some(b),
            (Some(a), Some(b)) => Some(a + (b - a) * part),
            _ => None,
        };
        mix([mix(below, u), mix(above, u)], v)
    }
}

/// The lines before the heights.
#[derive(Default)]
struct Head {
    columns: usize,
    rows: usize,
    corner: [Option<f64>; 2],
    centre: [Option<f64>; 2],
    cell: f64,
    no_data: Option<f64>,
}

impl Head {
    fn add(&mut self, line: &str) -> Result<(), String> {
        let mut words = line.split_whitespace();
        let (name, value) = (words.next().unwrap_or_default(), words.next().unwrap_or_default());
        let number: f64 = value.parse().map_err(|_| format!("`{value}` is not a number of `{name}`"))?;
        match name.to_lowercase().as_str() {
            "ncols" => self.columns = number as usize,
            "nrows" => self.rows = number as usize,
            "xllcorner" => self.corner[0] = Some(number),
            "yllcorner" => self.corner[1] = Some(number),
            "xllcenter" => self.centre[0] = Some(number),
            "yllcenter" => self.centre[1] = Some(number),
            "cellsize" => self.cell = number,
            "nodata_value" => self.no_data = Some(number),
            _ => return Err(format!("`{name}` is not a line of an ASCII grid")),
        }
        Ok(())
    }

    /// The number of cells.
    fn count(&mut self) -> Result<usize, String> {
        self.no_data = self.no_data.or(Some(-9999.0));
        let has_place = (0..2).all(|axis| self.corner[axis].or(self.centre[axis]).is_some_and(f64::is_finite));
        let count = self.columns.checked_mul(self.rows).filter(|count| (1..=MOST_CELLS).contains(count));
        match count {
            Some(count) if has_place && 0.0 < self.cell && self.cell.is_finite() => Ok(count),
            _ => {
                Err("it needs the lines ncols, nrows, xllcorner, yllcorner and cellsize, and at most 10⁸ cells"
                    .to_owned())
            }
        }
    }

    fn first(&self) -> Corner {
        [0, 1].map(|axis| self.centre[axis].unwrap_or_else(|| self.corner[axis].unwrap_or_default() + self.cell / 2.0))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const GRID: &str = "ncols 3\nnrows 2\nxllcenter 10\nyllcenter 20\ncellsize 2\nNODATA_value -1\n 1 2 3\n 4 6 -1\n";

    #[test]
    fn heights_are_interpolated_between_centres() {
        let grid = AsciiGrid::read(GRID.as_bytes()).expect("a grid");
        assert_eq!(grid.height([10.0, 20.0]), Some(4.0));
        assert_eq!(grid.height([11.0, 20.0]), Some(5.0));
        assert_eq!(grid.height([10.0, 21.0]), Some(2.5));
        assert_eq!(grid.height([14.0, 22.0]), Some(3.0));
        // Beyond the outer centres, and beyond the grid.
        assert_eq!(grid.height([9.0, 19.0]), Some(4.0));
        assert_eq!(grid.height([8.9, 20.0]), None);
        assert_eq!(grid.height([14.0, 20.0]), None);
        assert_eq!(grid.height([f64::NAN, 20.0]), None);
    }

    #[test]
    fn broken_grids_are_named() {
        for (text, why) in [
            ("", "no heights"),
            ("1 2 3", "needs the lines"),
            ("ncols 2\nnrows 1\nxllcorner 0\nyllcorner 0\ncellsize 1\n1", "1 heights of 2"),
            ("ncols 1\nnrows 1\nxllcorner 0\nyllcorner 0\ncellsize 1\n1 2", "more than 1"),
            ("ncols 1e9\nnrows 1e9\nxllcorner 0\nyllcorner 0\ncellsize 1\n1", "10⁸ cells"),
            ("ncols 1\nnrows 1\nxllcorner 0\nyllcorner 0\ncellsize 1\nx 3", "`x` is not a line"),
            ("ncols 2\nnrows 1\nxllcorner 0\nyllcorner 0\ncellsize 1\n1 x", "`x` is not a height"),
        ] {
            let error = AsciiGrid::read(text.as_bytes()).expect_err("broken");
            assert!(error.contains(why), "{text}: {error}");
        }
    }
}
