//! The points of an arrangement. No two of them are closer than its epsilon.

use crate::each::Each;
use std::collections::HashMap;

use glam::DVec3;

/// Points by number, and a grid to find them by place.
pub(super) struct PointSet {
    pub(super) at: Vec<DVec3>,
    pub(super) epsilon: f64,
    /// The last point in each cell of the grid.
    cells: HashMap<[i64; 3], u32>,
    /// For each point the point before it in the same cell, or [`NONE`].
    before: Vec<u32>,
}

const NONE: u32 = u32::MAX;

/// The size of a cell of the grid in epsilons. In larger cells, a place is rarely near several cells, but more points may be in
/// one.
const CELL_SIZE: f64 = 16.0;

impl PointSet {
    pub(super) fn new(epsilon: f64) -> Self {
        PointSet { at: Vec::new(), epsilon, cells: HashMap::new(), before: Vec::new() }
    }

    /// The nearest point within epsilon of a place; a new point if there is none.
    pub(super) fn number(&mut self, place: DVec3) -> u32 {
        let size = CELL_SIZE * self.epsilon;
        let cell = |place: DVec3| (place / size).floor().to_array().each(|steps| steps as i64);
        let [low, high] = [cell(place - self.epsilon), cell(place + self.epsilon)];
        let mut nearest = (self.epsilon * self.epsilon, NONE);
        for x in low[0]..=high[0] {
            for y in low[1]..=high[1] {
                for z in low[2]..=high[2] {
                    let mut point = self.cells.get(&[x, y, z]).copied().unwrap_or(NONE);
                    while point != NONE {
                        let found = (self.at[point as usize].distance_squared(place), point);
                        if found <= nearest {
                            nearest = found;
                        }
                        point = self.before[point as usize];
                    }
                }
            }
        }
        if nearest.1 != NONE {
            return nearest.1;
        }
        let new = self.at.len() as u32;
        self.at.push(place);
        self.before.push(self.cells.insert(cell(place), new).unwrap_or(NONE));
        new
    }

    /// The position on the segment of the nearest place to a point, as a distance from the start, if the point is on the
    /// segment and is none of its ends.
    pub(super) fn on_segment(&self, [a, b]: [u32; 2], point: u32) -> Option<f64> {
        if point == a || point == b {
            return None;
        }
        let [from, to, place] = [a, b, point].each(|number| self.at[number as usize]);
        let whole = to - from;
        let length = whole.length();
        let along = (place - from).dot(whole) / length;
        let is_between = 0.0 < along && along < length;
        let across = || (place - from - whole * (along / length)).length();
        (is_between && across() <= self.epsilon).then_some(along)
    }
}
