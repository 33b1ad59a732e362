//! The points, edges and movements of an operand.

use std::collections::{BTreeMap, HashMap};
use std::ops::Bound;

use glam::DVec3;

use crate::each::Each;
use crate::mesh::pair_table::PairTable;
use crate::trace::UNTRACED;

/// The distance below which two points of an edge are one, as a share of the edge.
const SAME: f64 = 1e-9;

/// Not on an edge.
pub(super) const NO_EDGE: u32 = u32::MAX;

/// The points of an operand, by number.
#[derive(Debug, Default)]
pub struct Origins {
    pub(super) points: Vec<OriginPoint>,
    pub(super) edges: Vec<DividedEdge>,
    edge_numbers: PairTable,
    /// Further divisions in which a point was made, besides the first one.
    pub(super) births: HashMap<u32, Vec<u32>>,
    /// The division that made the shape that a division divides. Division 0 is its own.
    pub(super) divisions: Vec<u32>,
    pub(super) movements: Vec<Movement>,
    /// True for each point that a leaf has.
    pub(super) used: Vec<bool>,
}

/// A point: of the shape that the operand begins with, or on an edge.
#[derive(Clone, Copy, Debug)]
pub(super) struct OriginPoint {
    /// The place before all movements, in the world.
    pub(super) place: DVec3,
    /// The edge, or [`NO_EDGE`].
    pub(super) edge: u32,
    /// The place on the edge.
    pub(super) share: f64,
    /// The first division in which it was made.
    pub(super) birth: u32,
}

/// An edge between two points, and the points on it.
#[derive(Clone, Debug)]
pub(super) struct DividedEdge {
    /// The smaller number first.
    pub(super) ends: [u32; 2],
    /// The points on it, by the bits of their shares. Bits of positive numbers have their order.
    inner: BTreeMap<u64, u32>,
}

impl DividedEdge {
    /// The points on it from its start to its end, with their shares.
    pub(super) fn inner(&self) -> impl Iterator<Item = (f64, u32)> + '_ {
        self.inner.iter().map(|(share, point)| (f64::from_bits(*share), *point))
    }
}

/// The movement of a part at a point.
#[derive(Clone, Copy, Debug)]
pub(super) struct Movement {
    pub(super) point: u32,
    /// The division that made the part.
    pub(super) division: u32,
    pub(super) by: DVec3,
}

/// A stretch of an edge.
#[derive(Clone, Copy)]
struct EdgeStretch {
    edge: u32,
    /// The shares of its start and its end.
    shares: [f64; 2],
}

impl Origins {
    /// Origins with one division, to which the whole shape belongs.
    pub fn new() -> Self {
        Origins { divisions: vec![0], ..Origins::default() }
    }

    /// The number of a new point at that place.
    pub fn point(&mut self, place: DVec3) -> u32 {
        self.points.push(OriginPoint { place, edge: NO_EDGE, share: 0.0, birth: 0 });
        self.points.len() as u32 - 1
    }

    /// The number of a new division of a part that division `of` has made.
    ///
    /// # Panics
    /// Panics if division `of` does not exist.
    pub fn divide(&mut self, of: u32) -> u32 {
        self.assert_division(of);
        self.divisions.push(of);
        self.divisions.len() as u32 - 1
    }

    /// The point at a share of the edge between two points, which a division makes. Points at the same share are one. The share
    /// is from 0 at the first point to 1 at the second; others, and NaN, give one of the ends.
    ///
    /// # Panics
    /// Panics if a point or the division does not exist. An end without an origin ([`UNTRACED`]) gives a point without one.
    pub fn on_edge(&mut self, ends: [u32; 2], share: f64, division: u32) -> u32 {
        let [a, b] = ends;
        if a == UNTRACED || b == UNTRACED {
            return UNTRACED;
        }
        self.assert_point(a);
        self.assert_point(b);
        self.assert_division(division);
        if a == b {
            return a;
        }
        let stretch = self.stretch(ends).unwrap_or_else(|| {
            let key = [a.min(b), a.max(b)];
            self.edges.push(DividedEdge { ends: key, inner: BTreeMap::new() });
            let edge = self.edges.len() as u32 - 1;
            *self.edge_numbers.entry(key[0], key[1], edge).0 = edge;
            EdgeStretch { edge, shares: if a < b { [0.0, 1.0] } else { [1.0, 0.0] } }
        });
        let [from, to] = stretch.shares;
        let at = from + (to - from) * share;
        let edge = &mut self.edges[stretch.edge as usize];
        let [first, last] = edge.ends;
        // Also for a share that is not a number.
        if at.is_nan() || at <= SAME {
            return first;
        }
        if 1.0 - SAME <= at {
            return last;
        }
        let near = edge.inner.range((at - SAME).to_bits()..=(at + SAME).to_bits()).next();
        if let Some((_, &known)) = near {
            let birth = self.points[known as usize].birth;
            if birth != division {
                let more = self.births.entry(known).or_default();
                if more.last() != Some(&division) {
                    more.push(division);
                }
            }
            return known;
        }
        let number = self.points.len() as u32;
        edge.inner.insert(at.to_bits(), number);
        let [low, high] = [first, last].each(|end| self.points[end as usize].place);
        let place = low + (high - low) * at;
        self.points.push(OriginPoint { place, edge: stretch.edge, share: at, birth: division });
        number
    }

    /// The stretch between two points, if it is on an edge that is divided.
    fn stretch(&self, [a, b]: [u32; 2]) -> Option<EdgeStretch> {
        let [p, q] = [a, b].each(|point| self.points[point as usize]);
        let end = |edge: u32, point: u32| {
            let ends = self.edges.get(edge as usize)?.ends;
            ends.iter().position(|end| *end == point).map(|end| end as f64)
        };
        if p.edge != NO_EDGE && p.edge == q.edge {
            return Some(EdgeStretch { edge: p.edge, shares: [p.share, q.share] });
        }
        if let Some(share) = end(q.edge, a) {
            return Some(EdgeStretch { edge: q.edge, shares: [share, q.share] });
        }
        if let Some(share) = end(p.edge, b) {
            return Some(EdgeStretch { edge: p.edge, shares: [p.share, share] });
        }
        let edge = self.edge_numbers.get(a.min(b), a.max(b))?;
        Some(EdgeStretch { edge, shares: if a < b { [0.0, 1.0] } else { [1.0, 0.0] } })
    }

    /// Calls `visit` with the used points between two points that are neighbours in a face, from the first to the second,
    /// each with its place between them from 0 to 1.
    pub(super) fn between(&self, ends: [u32; 2], mut visit: impl FnMut(u32, f64)) {
        if self.edges.is_empty() || ends[0] == ends[1] {
            return;
        }
        let Some(EdgeStretch { edge, shares: [from, to] }) = self.stretch(ends) else { return };
        let (low, high) = (from.min(to), from.max(to));
        if high <= low {
            return;
        }
        let inner =
            self.edges[edge as usize].inner.range((Bound::Excluded(low.to_bits()), Bound::Excluded(high.to_bits())));
        let used = inner.filter(|(_, point)| self.used.get(**point as usize) == Some(&true));
        let mut pass = |(share, point): (&u64, &u32)| visit(*point, (f64::from_bits(*share) - from) / (to - from));
        if from < to { used.for_each(&mut pass) } else { used.rev().for_each(&mut pass) }
    }

    /// Records that a part that a division has made has moved by some vector at a point. A vector that is not finite counts as
    /// no movement.
    ///
    /// # Panics
    /// Panics if the point or the division does not exist.
    pub fn moved(&mut self, point: u32, division: u32, by: DVec3) {
        if by != DVec3::ZERO && by.is_finite() {
            self.assert_point(point);
            self.assert_division(division);
            self.movements.push(Movement { point, division, by });
        }
    }

    /// Marks points as points of the result.
    ///
    /// # Panics
    /// Panics if a point does not exist.
    pub fn mark(&mut self, points: &[u32]) {
        points.iter().for_each(|&point| self.assert_point(point));
        self.used.resize(self.points.len(), false);
        points.iter().for_each(|point| self.used[*point as usize] = true);
    }

    fn assert_point(&self, point: u32) {
        assert!((point as usize) < self.points.len(), "point {point} of {}", self.points.len());
    }

    fn assert_division(&self, division: u32) {
        assert!((division as usize) < self.divisions.len(), "division {division} of {}", self.divisions.len());
    }

    /// The number of points.
    pub fn point_count(&self) -> usize {
        self.points.len()
    }
}
