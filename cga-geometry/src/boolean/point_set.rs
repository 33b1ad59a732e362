//! The points of an arrangement. No two of them are closer than its epsilon.

use std::hash::{BuildHasher, RandomState};

use glam::DVec3;

use crate::each::Each;

/// Points by number, and a grid to find them by place.
pub(super) struct PointSet {
    pub(super) at: Vec<DVec3>,
    pub(super) epsilon: f64,
    /// The last point of the cells of the grid with a hash, or [`NONE`]. The number of hashes is a power of two.
    last: Vec<u32>,
    /// For each point the point before it with the same hash, or [`NONE`].
    before: Vec<u32>,
    /// Makes other hashes in each run, so that input cannot be made for equal ones. The order of hashes does not matter.
    seed: u64,
}

const NONE: u32 = u32::MAX;

/// The size of a cell of the grid in epsilons. In larger cells, a place is rarely near several cells, but more points may be in
/// one.
const CELL_SIZE: f64 = 16.0;

impl PointSet {
    pub(super) fn new(epsilon: f64) -> Self {
        let seed = RandomState::new().hash_one(0) | 1;
        PointSet { at: Vec::new(), epsilon, last: vec![NONE; 16], before: Vec::new(), seed }
    }

    /// The cell of a place.
    fn cell(&self, place: DVec3) -> [i64; 3] {
        (place / (CELL_SIZE * self.epsilon)).floor().to_array().each(|steps| steps as i64)
    }

    /// The hash of a cell.
    fn hash(&self, cell: [i64; 3]) -> usize {
        let mixed = cell.into_iter().fold(0, |mixed: u64, steps| {
            let product = u128::from(mixed ^ steps as u64) * u128::from(self.seed);
            mixed.rotate_left(32) ^ product as u64 ^ (product >> 64) as u64
        });
        mixed as usize & (self.last.len() - 1)
    }

    /// Makes a point the last one with its hash. Points are listed in their order.
    fn list(&mut self, point: u32) {
        let hash = self.hash(self.cell(self.at[point as usize]));
        self.before.push(std::mem::replace(&mut self.last[hash], point));
    }

    /// The nearest point within epsilon of a place; a new point if there is none.
    pub(super) fn number(&mut self, place: DVec3) -> u32 {
        let [low, high] = [self.cell(place - self.epsilon), self.cell(place + self.epsilon)];
        let mut nearest = (self.epsilon * self.epsilon, NONE);
        for x in low[0]..=high[0] {
            for y in low[1]..=high[1] {
                for z in low[2]..=high[2] {
                    let mut point = self.last[self.hash([x, y, z])];
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
        self.list(new);
        if self.last.len() == self.at.len() {
            self.last = vec![NONE; 2 * self.at.len()];
            self.before.clear();
            (0..=new).for_each(|point| self.list(point));
        }
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
