//! The largest rectangle whose left and right sides are each in one slab.
//!
//! The sides are at `l` and `r`, the top at `t` and the bottom at `b`. Each limit of the top depends on `l`, on `r`, or on
//! neither, and is linear; so is each limit of the bottom. The area (r − l)(t − b) is a product of two linear functions. On a plane
//! within the limits it has no maximum of its own, so one maximum is on a line where three limits hold: one of the top, one of
//! the bottom and a third one. On each such line the area is a parabola.

use crate::each::Each;
use glam::DVec2;

use super::Found;
use crate::small_sort::SmallSort;

/// Areas that differ by less, relative to the larger one, are equal.
const EQUAL: f64 = 1e-12;

/// A limit: a linear function of `l` and `r`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Limit {
    pub(super) constant: f64,
    pub(super) by_left: f64,
    pub(super) by_right: f64,
}

impl Limit {
    pub(super) fn constant(constant: f64) -> Self {
        Limit { constant, by_left: 0.0, by_right: 0.0 }
    }

    fn at(&self, left: f64, right: f64) -> f64 {
        // A slope of zero must not meet an infinite place, nor an infinite constant anything.
        self.constant + self.by_left * left + self.by_right * right
    }

    fn minus(&self, other: &Limit) -> Limit {
        Limit {
            constant: self.constant - other.constant,
            by_left: self.by_left - other.by_left,
            by_right: self.by_right - other.by_right,
        }
    }
}

/// The limits of a rectangle. Its sides are measured from the left line of their slabs, because edges in a narrow slab may be
/// very steep.
#[derive(Clone, Debug)]
pub(super) struct CornerLimits {
    /// The top is below all of these, the bottom above all of those.
    pub(super) tops: Vec<Limit>,
    pub(super) bottoms: Vec<Limit>,
    /// The lines on the left of the slabs, and the widths of the slabs.
    pub(super) lines: [f64; 2],
    pub(super) widths: [f64; 2],
}

impl CornerLimits {
    /// The highest rectangle between two sides.
    fn between(&self, left: f64, right: f64) -> Found {
        let (left, right) = (left.clamp(0.0, self.widths[0]), right.clamp(0.0, self.widths[1]));
        let top = self.tops.iter().map(|top| top.at(left, right)).fold(f64::INFINITY, f64::min);
        let bottom = self.bottoms.iter().map(|bottom| bottom.at(left, right)).fold(f64::NEG_INFINITY, f64::max);
        let [left, right] = [self.lines[0] + left, self.lines[1] + right];
        let area = (right - left).max(0.0) * (top - bottom).max(0.0);
        Found { low: DVec2::new(left, bottom), high: DVec2::new(right, top), area }
    }

    /// The largest rectangle; of several, the one nearest to a point.
    pub(super) fn largest(&self, centre: DVec2) -> Option<Found> {
        let mut all: Vec<Found> = Vec::new();
        for (p, top) in self.tops.iter().enumerate() {
            for (q, bottom) in self.bottoms.iter().enumerate() {
                let mut thirds: Vec<Limit> = Vec::with_capacity(8);
                thirds.extend(self.tops.iter().enumerate().filter(|(k, _)| *k != p).map(|(_, other)| top.minus(other)));
                let others = self.bottoms.iter().enumerate().filter(|(k, _)| *k != q);
                thirds.extend(others.map(|(_, other)| bottom.minus(other)));
                thirds.extend(self.borders());
                let height = top.minus(bottom);
                thirds.iter().for_each(|third| self.along(&height, third, &mut all));
            }
        }
        let most = all.iter().map(|found| found.area).fold(0.0, f64::max);
        if most <= 0.0 {
            return None;
        }
        all.retain(|found| most * (1.0 - EQUAL) <= found.area);
        // Most are found many times, and all pairs are looked at.
        all.small_sort_unstable_by(|a, b| a.low.x.total_cmp(&b.low.x).then(a.high.x.total_cmp(&b.high.x)));
        all.dedup_by(|a, b| a.low.abs_diff_eq(b.low, EQUAL) && a.high.abs_diff_eq(b.high, EQUAL));
        let off = |found: &Found| found.middle().distance_squared(centre);
        let mut nearest = all.iter().copied().min_by(|a, b| off(a).total_cmp(&off(b)))?;
        // Rectangles between two that are equally large are as large, because the area has no other maximum.
        for a in &all {
            for b in &all {
                let way = b.middle() - a.middle();
                let share = (centre - a.middle()).dot(way) / way.length_squared();
                if 0.0 < share && share < 1.0 {
                    let (low, high) = (a.low.lerp(b.low, share), a.high.lerp(b.high, share));
                    let between = self.between(low.x - self.lines[0], high.x - self.lines[1]);
                    if most * (1.0 - EQUAL) <= between.area && off(&between) < off(&nearest) {
                        nearest = between;
                    }
                }
            }
        }
        Some(nearest)
    }

    /// The limits of the slabs: zero where a side is on a line between slabs.
    fn borders(&self) -> [Limit; 4] {
        let [left, right] = self.widths;
        let [by_left, by_right] =
            [1.0, 0.0].each(|by_left| move |at: f64| Limit { constant: -at, by_left, by_right: 1.0 - by_left });
        [by_left(0.0), by_left(left), by_right(0.0), by_right(right)]
    }

    /// Adds rectangles on a line of `l` and `r` where `third` is zero: where the line leaves the room for both sides, where
    /// another limit begins to count, and where the area with the given height is largest.
    fn along(&self, height: &Limit, third: &Limit, all: &mut Vec<Found>) {
        let Limit { constant, by_left, by_right } = *third;
        if !(constant.is_finite() && height.constant.is_finite()) || (by_left == 0.0 && by_right == 0.0) {
            return;
        }
        // The place on the line: `l` and `r` for a number.
        let line = |s: f64| match by_left.abs() < by_right.abs() {
            true => [s, -(constant + by_left * s) / by_right],
            false => [-(constant + by_right * s) / by_left, s],
        };
        let [from, to] = [0.0, if by_left.abs() < by_right.abs() { self.widths[0] } else { self.widths[1] }];
        // Both factors are linear along the line.
        let [start, end] = [line(from), line(to)];
        let between = self.lines[1] - self.lines[0];
        let width = [between + start[1] - start[0], between + end[1] - end[0]];
        let high = [height.at(start[0], start[1]), height.at(end[0], end[1])];
        let (dw, dh) = (width[1] - width[0], high[1] - high[0]);
        let mut add = |share: f64| {
            if (0.0..=1.0).contains(&share) {
                let [left, right] = line(from + (to - from) * share);
                // Beyond the slabs, this is another rectangle, which is possible too.
                all.push(self.between(left, right));
            }
        };
        add(0.0);
        add(1.0);
        if dw * dh < 0.0 {
            add(-(width[0] * dh + high[0] * dw) / (2.0 * dw * dh));
        }
        // Where another limit crosses the line, and where the line leaves the room.
        let mut cross = |limit: Limit| {
            let ends = [limit.at(start[0], start[1]), limit.at(end[0], end[1])];
            if ends[0] != ends[1] && ends[0].is_finite() && ends[1].is_finite() {
                add(ends[0] / (ends[0] - ends[1]));
            }
        };
        for list in [&self.tops, &self.bottoms] {
            for (k, limit) in list.iter().enumerate() {
                list[k + 1..].iter().for_each(|other| cross(limit.minus(other)));
            }
        }
        self.borders().into_iter().for_each(cross);
    }
}
