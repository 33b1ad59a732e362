//! The points of an initial shape that lie inside its edges.

use std::collections::HashMap;

use glam::DVec3;

use crate::fixed_hash::FixedState;
use crate::geometry::each::Each;

/// Points at this share of the largest coordinate from an edge are in it: some steps of a 32-bit float.
const IN_EDGE: f64 = 5e-7;

/// The most cells along the longest side of the grid.
const MOST_CELLS: f64 = 1024.0;

/// A place as sinks write it: in 32 bits, by its bits.
type Key = [u32; 3];

/// The distinct points and edges of an initial shape. Tables are only for look-ups, never iterated.
pub(super) struct Points {
    origin: DVec3,
    numbers: HashMap<Key, u32, FixedState>,
    points: Vec<DVec3>,
    edges: Vec<[u32; 2]>,
}

/// The points inside of each edge.
pub(super) struct EdgePoints {
    origin: DVec3,
    numbers: HashMap<Key, u32, FixedState>,
    points: Vec<DVec3>,
    /// The points inside of an edge, from its lower number to its higher one, as a range of `inside`.
    ranges: HashMap<[u32; 2], [u32; 2], FixedState>,
    inside: Vec<u32>,
}

fn key(origin: DVec3, point: DVec3) -> Key {
    // −0 and 0 are one place.
    (point - origin).as_vec3().to_array().each(|c| (c + 0.0).to_bits())
}

impl Points {
    /// No points. Sinks write coordinates relative to `origin`.
    pub(super) fn new(origin: DVec3) -> Self {
        Points { origin, numbers: HashMap::default(), points: Vec::new(), edges: Vec::new() }
    }

    /// Adds the points and edges of a loop.
    pub(super) fn add(&mut self, ring: &[DVec3]) {
        let Some(&last) = ring.last() else { return };
        let mut from = self.number(last);
        for &point in ring {
            let to = self.number(point);
            if from != to {
                self.edges.push([from.min(to), from.max(to)]);
            }
            from = to;
        }
    }

    fn number(&mut self, point: DVec3) -> u32 {
        let next = self.points.len() as u32;
        let number = *self.numbers.entry(key(self.origin, point)).or_insert(next);
        if number == next {
            self.points.push(point);
        }
        number
    }

    /// Finds the points inside of each edge.
    pub(super) fn edges(mut self) -> EdgePoints {
        self.edges.sort_unstable();
        self.edges.dedup();
        let grid = Grid::new(&self.points, self.origin);
        let (mut ranges, mut inside) = (HashMap::default(), Vec::new());
        let mut found = Vec::new();
        for &edge in &self.edges {
            grid.inside(edge, &mut found);
            if !found.is_empty() {
                let start = inside.len() as u32;
                inside.extend(found.iter().map(|(_, point)| *point));
                ranges.insert(edge, [start, inside.len() as u32]);
            }
        }
        EdgePoints { origin: self.origin, numbers: self.numbers, points: self.points, ranges, inside }
    }
}

impl EdgePoints {
    /// The points inside of an edge, from its start to its end.
    pub(super) fn inside(&self, [from, to]: [DVec3; 2]) -> impl Iterator<Item = DVec3> + '_ {
        let ends = [from, to].each(|end| self.numbers.get(&key(self.origin, end)).copied().unwrap_or_default());
        let [low, high] = [ends[0].min(ends[1]), ends[0].max(ends[1])];
        let [start, end] = self.ranges.get(&[low, high]).copied().unwrap_or_default();
        let (count, is_turned) = ((end - start) as usize, ends[0] != low);
        (0..count).map(move |at| {
            let at = if is_turned { count - 1 - at } else { at };
            self.points[self.inside[start as usize + at] as usize]
        })
    }

    /// Returns true if a point is inside of an edge of a loop.
    pub(super) fn divides(&self, ring: &[DVec3]) -> bool {
        let ends = ring.iter().zip(ring.iter().cycle().skip(1));
        !self.inside.is_empty() && ends.into_iter().any(|(from, to)| self.inside([*from, *to]).next().is_some())
    }
}

/// Points by the cell of a grid that they are in.
struct Grid<'p> {
    points: &'p [DVec3],
    low: DVec3,
    /// Cells in a metre.
    scale: f64,
    /// The distance from an edge in metres, below which a point is in it.
    near: f64,
    /// The number of the first point in each cell, and of the next point in the cell of each point, plus one; 0 ends a list.
    first: HashMap<[i32; 3], u32, FixedState>,
    next: Vec<u32>,
}

impl<'p> Grid<'p> {
    fn new(points: &'p [DVec3], origin: DVec3) -> Self {
        let (low, high) = points
            .iter()
            .fold((DVec3::INFINITY, DVec3::NEG_INFINITY), |(low, high), point| (low.min(*point), high.max(*point)));
        let side = (high - low).max_element().max(f64::MIN_POSITIVE);
        // Most points are on surfaces.
        let scale = (points.len() as f64).sqrt().clamp(1.0, MOST_CELLS) / side;
        let reach = (low - origin).abs().max((high - origin).abs()).max_element();
        let mut grid =
            Grid { points, low, scale, near: IN_EDGE * reach, first: HashMap::default(), next: vec![0; points.len()] };
        for (number, point) in (0..).zip(points) {
            let cell = grid.place(*point).each(|c| c.floor() as i32);
            let first = grid.first.entry(cell).or_insert(0);
            grid.next[number as usize] = std::mem::replace(first, number + 1);
        }
        grid
    }

    /// A place in cells.
    fn place(&self, point: DVec3) -> [f64; 3] {
        ((point - self.low) * self.scale).to_array()
    }

    /// The points inside of an edge with their distances from its start, in this order.
    fn inside(&self, edge: [u32; 2], found: &mut Vec<(f64, u32)>) {
        found.clear();
        let [from, to] = edge.each(|end| self.points[end as usize]);
        let length = (to - from).length();
        let along = (to - from) / length;
        if !along.is_finite() {
            return;
        }
        self.cells([from, to], &mut |cell| {
            let mut at = self.first.get(&cell).copied().unwrap_or(0);
            while let Some(number) = at.checked_sub(1) {
                let offset = self.points[number as usize] - from;
                let distance = offset.dot(along);
                let is_between = self.near < distance && distance < length - self.near;
                if is_between && (offset - along * distance).length_squared() <= self.near * self.near {
                    found.push((distance, number));
                }
                at = self.next[number as usize];
            }
        });
        found.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
    }

    /// Calls `each` with each cell at a segment, once.
    fn cells(&self, segment: [DVec3; 2], each: &mut dyn FnMut([i32; 3])) {
        let [a, b] = segment.each(|end| self.place(end));
        let longest = (0..3)
            .fold(0, |most, axis| if (b[most] - a[most]).abs() < (b[axis] - a[axis]).abs() { axis } else { most });
        let (a, b) = if a[longest] <= b[longest] { (a, b) } else { (b, a) };
        let slack = self.near * self.scale;
        let run = (b[longest] - a[longest]).max(f64::MIN_POSITIVE);
        let ends = [a[longest] - slack, b[longest] + slack].each(|c| c.floor() as i32);
        for slab in ends[0]..=ends[1] {
            // The part of the segment in this slab of cells, in shares of the segment.
            let shares = [0, 1].each(|side| ((f64::from(slab + side) - a[longest]) / run).clamp(0.0, 1.0));
            let range = |axis: usize| {
                let [p, q] = shares.each(|share| a[axis] + (b[axis] - a[axis]) * share);
                [p.min(q) - slack, p.max(q) + slack].each(|c| c.floor() as i32)
            };
            let [u, v] = [(longest + 1) % 3, (longest + 2) % 3];
            let [us, vs] = [u, v].each(range);
            for at_u in us[0]..=us[1] {
                for at_v in vs[0]..=vs[1] {
                    let mut cell = [slab; 3];
                    (cell[u], cell[v]) = (at_u, at_v);
                    each(cell);
                }
            }
        }
    }
}
