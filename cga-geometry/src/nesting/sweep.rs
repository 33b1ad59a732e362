//! Finds the outline directly around each loop by one sweep from bottom to top, from the edge left of the loop's lowest
//! corner.
//!
//! This is valid for loops that do not cross, though solids may touch along edges. Comparisons are exact. The order of
//! edges is checked when they become neighbours, so crossing loops are detected.

use std::cmp::Ordering;

use glam::DVec2;

use super::contour::FlatLoops;
use crate::each::Each;
use crate::exact::orient;
use crate::small_sort::SmallSort;
use crate::status::{LEFT, RIGHT, Status, is_below};

/// No outline.
const NONE: u32 = u32::MAX;
/// The value for a loop that the sweep has not reached.
const UNKNOWN: u32 = u32::MAX - 1;

/// Buffers.
#[derive(Default)]
pub(crate) struct LoopSweep {
    /// For each loop the outline around it.
    around: Vec<u32>,
    /// The corners of a loop.
    places: Vec<DVec2>,
    edges: Vec<SweepEdge>,
    events: Vec<SweepEvent>,
    status: Status,
    /// The edge of each entry of the status, and the entry of each edge.
    edge_of: Vec<u32>,
    entry_of: Vec<u32>,
}

/// The edge that begins at a corner.
#[derive(Clone, Copy)]
struct SweepEdge {
    low: DVec2,
    high: DVec2,
    /// True if the solid is right of the edge: true for left edges of outlines and right edges of holes.
    enters: bool,
    owner: u32,
}

/// A corner.
#[derive(Clone, Copy)]
struct SweepEvent {
    at: DVec2,
    /// True if both its edges are above it. Among corners at one place these come last.
    begins: bool,
    /// The edge that ends at the corner and the edge that begins there.
    edges: [u32; 2],
}

impl LoopSweep {
    /// The outline around a loop, if the sweep has found one.
    pub(crate) fn around(&self, number: usize) -> Option<usize> {
        let outline = self.around[number];
        (outline < UNKNOWN).then_some(outline as usize)
    }

    /// Fills `around` for the loops that `counts` accepts. Returns `false` if they cross. In a section that is inside
    /// out, outlines are clockwise.
    pub(crate) fn find(
        &mut self,
        section: &FlatLoops<'_>,
        inverted: bool,
        counts: impl Fn(usize) -> bool,
        is_outline: impl Fn(usize) -> bool,
    ) -> bool {
        if !self.start(section, inverted, counts) {
            return false;
        }
        let events = std::mem::take(&mut self.events);
        let sound =
            events.iter().all(|event| if event.begins { self.begin(event, &is_outline) } else { self.go_on(event) });
        self.events = events;
        sound
    }

    /// Sorts the corners. Returns `false` if a coordinate is not finite.
    fn start(&mut self, section: &FlatLoops<'_>, inverted: bool, counts: impl Fn(usize) -> bool) -> bool {
        let LoopSweep { around, places, edges, events, .. } = self;
        around.clear();
        around.resize(section.ends.len(), UNKNOWN);
        edges.clear();
        events.clear();
        let mut from = 0;
        for (owner, &end) in section.ends.iter().enumerate() {
            let ring = &section.corners[std::mem::replace(&mut from, end)..end];
            if !counts(owner) {
                continue;
            }
            without_spikes(ring.iter().map(|&corner| section.flat[corner as usize]), places);
            let first = edges.len() as u32;
            let count = places.len() as u32;
            for (i, &at) in (0..).zip(&*places) {
                let next = places[if i + 1 == count { 0 } else { i as usize + 1 }];
                let down = is_below(next, at);
                let (low, high) = if down { (next, at) } else { (at, next) };
                let own = first + i;
                edges.push(SweepEdge { low, high, enters: down != inverted, owner: owner as u32 });
                let arriving = if i == 0 { first + count - 1 } else { own - 1 };
                events.push(SweepEvent { at, begins: false, edges: [arriving, own] });
            }
        }
        if !edges.iter().all(|edge| edge.low.is_finite()) {
            return false;
        }
        self.status.clear();
        self.edge_of.clear();
        self.entry_of.clear();
        self.entry_of.resize(edges.len(), NONE);
        for event in events.iter_mut() {
            event.begins = event.edges.iter().all(|&edge| edges[edge as usize].low == event.at);
        }
        events.small_sort_unstable_by(|a, b| {
            let place = is_below(b.at, a.at).cmp(&is_below(a.at, b.at));
            place.then(a.begins.cmp(&b.begins)).then(a.edges.cmp(&b.edges))
        });
        for together in events.chunk_by_mut(|a, b| a.begins && b.begins && a.at == b.at) {
            together.small_sort_by(|a, b| which_is_around(a, b, edges));
        }
        true
    }

    /// Processes a corner with both edges above it. The area between them is beside the edge that they lie on, if any.
    fn begin(&mut self, event: &SweepEvent, is_outline: &impl Fn(usize) -> bool) -> bool {
        let [a, b] = event.edges.each(|edge| self.edges[edge as usize]);
        let turn = orient(event.at, a.high, b.high);
        let [left, right] = if turn < 0 { event.edges } else { [event.edges[1], event.edges[0]] };
        let neighbours = self.neighbours(left, true);
        let owner = a.owner as usize;
        if self.around[owner] == UNKNOWN {
            self.around[owner] = neighbours[LEFT].map_or(NONE, |beside| {
                let SweepEdge { enters, owner, .. } = self.edges[beside as usize];
                if enters && is_outline(owner as usize) { owner } else { self.around[owner as usize] }
            });
        }
        turn != 0 && self.insert(neighbours, left) && self.insert(self.neighbours(right, false), right)
    }

    /// Processes a corner where an edge ends. The other edge continues or ends too.
    fn go_on(&mut self, event: &SweepEvent) -> bool {
        let [a, b] = event.edges;
        match event.edges.each(|edge| self.edges[edge as usize].high == event.at) {
            [true, true] => self.remove(a) && self.remove(b),
            [true, false] => self.replace(a, b),
            [false, true] => self.replace(b, a),
            [false, false] => false,
        }
    }

    /// The edges beside an edge that begins, to the right or left of edges that it lies on.
    fn neighbours(&self, own: u32, right_of_equal: bool) -> [Option<u32>; 2] {
        let own = &self.edges[own as usize];
        let is_left = |[low, high]: [DVec2; 2]| is_left_of(low, high, own).unwrap_or(right_of_equal);
        self.status.around(is_left).each(|entry| self.edge(entry))
    }

    /// The edge of an entry of the status.
    fn edge(&self, entry: Option<u32>) -> Option<u32> {
        entry.map(|entry| self.edge_of[entry as usize])
    }

    fn insert(&mut self, [left, right]: [Option<u32>; 2], edge: u32) -> bool {
        let SweepEdge { low, high, .. } = self.edges[edge as usize];
        let after = left.map(|left| self.entry_of[left as usize]);
        self.entry_of[edge as usize] = self.status.insert_after(after, [low, high]);
        self.edge_of.push(edge);
        self.are_in_order(left, Some(edge)) && self.are_in_order(Some(edge), right)
    }

    fn replace(&mut self, old: u32, new: u32) -> bool {
        let Some((entry, [left, right])) = self.take(old) else { return false };
        let SweepEdge { low, high, .. } = self.edges[new as usize];
        self.status.set_edge(entry, [low, high]);
        self.edge_of[entry as usize] = new;
        self.entry_of[new as usize] = entry;
        self.are_in_order(left, Some(new)) && self.are_in_order(Some(new), right)
    }

    fn remove(&mut self, edge: u32) -> bool {
        let Some((entry, [left, right])) = self.take(edge) else { return false };
        self.status.remove(entry);
        // Edges that end at the same point will be removed too.
        let end = self.edges[edge as usize].high;
        [left, right].iter().flatten().all(|&beside| self.edges[beside as usize].high == end)
            || self.are_in_order(left, right)
    }

    /// Ends an edge. Returns its entry and the edges beside it; `None` if the edge is not in the status.
    fn take(&mut self, edge: u32) -> Option<(u32, [Option<u32>; 2])> {
        let entry = std::mem::replace(&mut self.entry_of[edge as usize], NONE);
        (entry != NONE).then(|| (entry, [LEFT, RIGHT].each(|side| self.edge(self.status.beside(entry, side)))))
    }

    /// Returns true if two neighbours are beside each other over their common range of heights.
    fn are_in_order(&self, left: Option<u32>, right: Option<u32>) -> bool {
        let (Some(left), Some(right)) = (left, right) else { return true };
        let [left, right] = [left, right].each(|edge| self.edges[edge as usize]);
        // One begins where the other ends, and the other will be removed.
        if left.high == right.low || left.low == right.high {
            return true;
        }
        // The distances of the two edges at the higher of their low ends and at the lower of their high ends.
        let side = |edge: SweepEdge, p: DVec2| side(edge.low, edge.high, p);
        let low = if is_below(left.low, right.low) { -side(left, right.low) } else { side(right, left.low) };
        let high = if is_below(left.high, right.high) { side(right, left.high) } else { -side(left, right.high) };
        // If two solids touch, one ends and the other begins. If the area between a hole and its outline has no width,
        // it begins and ends.
        let touch = low == 0 && high == 0 && left.enters != right.enters;
        low >= 0 && high >= 0 && (low + high > 0 || touch)
    }
}

/// 1 if a point is left of an edge, -1 if it is right, 0 on its line.
#[inline]
fn side(low: DVec2, high: DVec2, p: DVec2) -> i32 {
    if low == p || high == p { 0 } else { orient(low, high, p) }
}

/// Returns true if an edge is left of the low end of another edge, or contains that end and is left of the high end.
/// `None` if the two edges are collinear there.
#[inline]
fn is_left_of(low: DVec2, high: DVec2, other: &SweepEdge) -> Option<bool> {
    let side = match side(low, high, other.low) {
        0 => orient(low, high, other.high),
        side => side,
    };
    (side != 0).then_some(side < 0)
}

/// The order of two corners at one place with their edges above: a corner comes before the corners that it contains.
fn which_is_around(a: &SweepEvent, b: &SweepEvent, edges: &[SweepEdge]) -> Ordering {
    let sides = |event: &SweepEvent| {
        let [p, q] = event.edges.each(|edge| &edges[edge as usize]);
        if orient(event.at, p.high, q.high) < 0 { [p, q] } else { [q, p] }
    };
    let ([left, right], [other_left, other_right]) = (sides(a), sides(b));
    let turn = |from: &SweepEdge, to: &SweepEdge| orient(a.at, from.high, to.high);
    let by_left = turn(left, other_left).cmp(&0);
    let by_right = 0.cmp(&turn(right, other_right));
    let longer = |a: &SweepEdge, b: &SweepEdge| is_below(a.high, b.high).cmp(&is_below(b.high, a.high));
    let by_length = longer(left, other_left).then(longer(right, other_right));
    by_left.then(by_right).then(by_length).then(other_left.enters.cmp(&left.enters))
}

/// The corners of a ring without repeated corners and without corners where it turns back on itself, which enclose no
/// area. Empty for a ring that encloses no area.
fn without_spikes(ring: impl Iterator<Item = DVec2>, places: &mut Vec<DVec2>) {
    let is_spike =
        |a: DVec2, b: DVec2, c: DVec2| a == b || b == c || (is_below(a, b) != is_below(b, c) && orient(a, b, c) == 0);
    places.clear();
    for next in ring {
        while let [.., before, tip] = places[..]
            && is_spike(before, tip, next)
        {
            places.pop();
        }
        if places.last() != Some(&next) {
            places.push(next);
        }
    }
    // There may be more where the ring closes.
    let mut start = 0;
    while let [first, second, .., before, last] = places[start..] {
        if is_spike(before, last, first) {
            places.pop();
        } else if is_spike(last, first, second) {
            start += 1;
        } else {
            break;
        }
    }
    places.drain(..start);
    if places.len() < 3 || matches!(places[..], [a, b, c] if orient(a, b, c) == 0) {
        places.clear();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The result for each loop; `None` if loops cross. Counter-clockwise loops are outlines, or clockwise ones if they
    /// have more area.
    fn around(loops: &[Vec<DVec2>]) -> Option<Vec<u32>> {
        let flat: Vec<DVec2> = loops.iter().flatten().copied().collect();
        let corners: Vec<u32> = (0..flat.len() as u32).collect();
        let ends: Vec<usize> =
            loops.iter().scan(0, |end, ring| Some(std::mem::replace(end, *end + ring.len()) + ring.len())).collect();
        let area =
            |ring: &[DVec2]| (1..ring.len()).map(|i| (ring[i - 1] - ring[0]).perp_dot(ring[i] - ring[0])).sum::<f64>();
        let mut sweep = LoopSweep::default();
        let section = FlatLoops { flat: &flat, corners: &corners, ends: &ends };
        let total: f64 = loops.iter().map(|ring| area(ring)).sum();
        let is_outline = |number: usize| (area(&loops[number]) > 0.0) == (total > 0.0);
        sweep.find(&section, total < 0.0, |_| true, is_outline).then_some(sweep.around)
    }

    /// A square rotated by some degrees, clockwise for a negative size.
    fn square(x: f64, y: f64, size: f64, degrees: f64) -> Vec<DVec2> {
        let (sin, cos) = libm::sincos(degrees.to_radians());
        let corner = |a: f64, b: f64| DVec2::new(x, y) + DVec2::new(a * cos - b * sin, a * sin + b * cos) * size.abs();
        let mut ring = vec![corner(-1.0, -1.0), corner(1.0, -1.0), corner(1.0, 1.0), corner(-1.0, 1.0)];
        if size < 0.0 {
            ring.reverse();
        }
        ring
    }

    #[test]
    fn rings_in_rings_know_each_other_however_turned() {
        for degrees in [0.0, 10.0, 30.0, 45.0, 90.0] {
            for reversed in [false, true] {
                // Outline, hole, island, hole, and so on, with the outermost first or last.
                let count = 40;
                let mut loops: Vec<_> = (0..count)
                    .map(|i| square(3.0, -2.0, f64::from(count - i) * if i % 2 == 0 { 1.0 } else { -1.0 }, degrees))
                    .collect();
                let mut expected: Vec<u32> =
                    (0..count as u32).map(|i| if i == 0 { NONE } else { (i - 1) & !1 }).collect();
                if reversed {
                    loops.reverse();
                    expected.reverse();
                    expected
                        .iter_mut()
                        .filter(|number| **number != NONE)
                        .for_each(|number| *number = count as u32 - 1 - *number);
                }
                assert_eq!(around(&loops), Some(expected.clone()), "{degrees}");
                loops.iter_mut().for_each(|ring| ring.reverse());
                assert_eq!(around(&loops), Some(expected), "inside out, {degrees}");
            }
        }
    }

    #[test]
    fn many_neighbours_keep_their_holes() {
        // More than a block of the row, and rows of equal corners.
        let side = 40;
        for degrees in [0.0, 20.0, 45.0] {
            let mut loops = Vec::new();
            for i in 0..side * side {
                let (x, y) = (f64::from(i % side) * 4.0, f64::from(i / side) * 4.0);
                loops.push(square(x, y, 1.0, degrees));
                loops.push(square(x, y, -0.5, degrees + 10.0));
            }
            let expected = (0..loops.len() as u32).map(|i| if i % 2 == 0 { NONE } else { i - 1 }).collect();
            assert_eq!(around(&loops), Some(expected));
        }
    }

    #[test]
    fn loops_may_touch_at_corners_and_along_the_way() {
        let outline = square(0.0, 0.0, 4.0, 0.0);
        let at = |x: f64, y: f64| DVec2::new(x, y);
        // Holes that touch the outline with a corner, at a corner, and each other. One ends on the bottom of the
        // outline.
        let holes = [
            vec![at(-4.0, -4.0), at(-2.0, -1.0), at(-1.0, -2.0)],
            vec![at(-2.0, -1.0), at(-3.0, 3.0), at(0.0, 3.0)],
            vec![at(2.0, -4.0), at(1.0, 0.0), at(3.0, 0.0)],
            vec![at(4.0, 2.0), at(2.0, 1.0), at(2.0, 3.0)],
        ];
        let loops: Vec<_> = std::iter::once(outline).chain(holes).collect();
        assert_eq!(around(&loops), Some(vec![NONE, 0, 0, 0, 0]));
    }

    #[test]
    fn solids_may_touch_along_their_sides() {
        let a = square(0.0, 0.0, 1.0, 0.0);
        let hole = square(2.0, 0.0, -0.5, 0.0);
        // The whole side, a part of it, and beyond it; to the right, above, and on both sides.
        for other in
            [(2.0, 0.0, 1.0), (1.5, 0.0, 0.5), (3.0, 0.5, 2.0), (0.0, 2.0, 1.0), (-1.5, 0.25, 0.5), (0.3, -1.75, 0.75)]
        {
            for degrees in [0.0, 90.0] {
                let turn = |ring: Vec<DVec2>| -> Vec<DVec2> {
                    ring.into_iter().map(|p| if degrees == 0.0 { p } else { DVec2::new(-p.y, p.x) }).collect()
                };
                let other = square(other.0, other.1, other.2, 0.0);
                let loops = [a.clone(), other].map(turn);
                assert_eq!(around(&loops), Some(vec![NONE, NONE]), "{loops:?}");
            }
        }
        let right = square(2.0, 0.0, 1.0, 0.0);
        assert_eq!(around(&[hole, a, right]), Some(vec![2, NONE, NONE]));
    }

    #[test]
    fn corners_that_enclose_nothing_do_no_harm() {
        let at = |x: f64, y: f64| DVec2::new(x, y);
        let clean = |ring: &[DVec2]| {
            let mut places = Vec::new();
            without_spikes(ring.iter().copied(), &mut places);
            places
        };
        let square = [at(0.0, 0.0), at(2.0, 0.0), at(2.0, 2.0), at(0.0, 2.0)];
        let spikes =
            [at(0.0, 0.0), at(3.0, 0.0), at(2.0, 0.0), at(2.0, 2.0), at(2.0, 2.0), at(0.0, 2.0), at(0.0, -1.0)];
        // A spike on a spike, for every start of the ring.
        let long = [square[0], square[1], at(5.0, 0.0), at(5.0, 3.0), at(5.0, 0.0), square[1], square[2], square[3]];
        for ring in [&spikes[..], &long] {
            for start in 0..ring.len() {
                let turned: Vec<DVec2> = ring[start..].iter().chain(&ring[..start]).copied().collect();
                let mut left = clean(&turned);
                let first = left.iter().position(|&p| p == square[0]).unwrap();
                left.rotate_left(first);
                assert_eq!(left, square);
            }
        }
        assert_eq!(clean(&[at(0.0, 0.0), at(1.0, 1.0), at(2.0, 2.0), at(1.0, 1.0)]), []);
        assert_eq!(clean(&[at(0.0, 0.0), at(1.0, 1.0), at(2.0, 2.0)]), []);
        let hole = [at(0.5, 0.5), at(0.5, 1.5), at(0.5, 1.0), at(1.0, 1.0)];
        assert_eq!(around(&[hole.to_vec(), long.to_vec()]), Some(vec![1, NONE]));
    }

    #[test]
    fn many_loops_that_touch_in_a_point_take_no_longer() {
        // Each inside the one before, with the point to the left, below, right and above, and the same rotated.
        let count = 3000;
        for (cos, sin) in [(1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0), (0.6, 0.8)] {
            let turn = |x: f64, y: f64| DVec2::new(cos * x - sin * y, sin * x + cos * y);
            let nested = (0..count).map(|i| {
                let angle = 0.7 * (1.0 - f64::from(i) / f64::from(2 * count));
                let (y, x) = libm::sincos(angle);
                let mut ring = vec![DVec2::ZERO, turn(x, -y), turn(5.0 - f64::from(i) / 1e4, 0.0), turn(x, y)];
                if i % 2 == 1 {
                    ring.reverse();
                }
                ring
            });
            let expected = (0..count as u32).map(|i| if i == 0 { NONE } else { (i - 1) & !1 });
            assert!(around(&nested.collect::<Vec<_>>()) == Some(expected.collect()), "{cos} {sin}");
        }
    }

    #[test]
    fn what_is_between_a_hole_and_its_outline_may_have_no_width() {
        // Triangles with a common corner and two common directions, in all positions and in any order.
        let count = 60;
        for (cos, sin) in [(1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0), (3.0, 4.0), (-4.0, 3.0), (1.0, 1.0)] {
            for shuffle in [1, 7, 59] {
                let nested = |number: u32| {
                    let (size, at) =
                        (f64::from(200 - number), |x: f64, y: f64| DVec2::new(cos * x - sin * y, sin * x + cos * y));
                    let mut ring = vec![DVec2::ZERO, at(size, -size), at(size, size)];
                    if number % 2 == 1 {
                        ring.reverse();
                    }
                    ring
                };
                let loops: Vec<_> = (0..count).map(|i| nested(i * shuffle % count)).collect();
                let place = |number: u32| (0..count).find(|i| i * shuffle % count == number).unwrap();
                let expected = (0..count).map(|i| match i * shuffle % count {
                    0 => NONE,
                    number => place((number - 1) & !1),
                });
                assert!(around(&loops) == Some(expected.collect()), "{cos} {sin} {shuffle}");
            }
        }
        // A hole that covers the whole outline, in both orders.
        let (outline, mut hole) = (square(0.0, 0.0, 2.0, 20.0), square(0.0, 0.0, 2.0, 20.0));
        hole.reverse();
        let island = square(0.0, 0.0, 1.0, 45.0);
        assert_eq!(around(&[outline.clone(), hole.clone(), island.clone()]), Some(vec![NONE, 0, 0]));
        assert_eq!(around(&[hole, island, outline]), Some(vec![2, 2, NONE]));
    }

    #[test]
    fn loops_that_cross_or_lie_on_each_other_are_found_out() {
        let a = square(0.0, 0.0, 1.0, 0.0);
        let beside = |other: Vec<DVec2>| around(&[a.clone(), other]);
        assert_eq!(beside(square(1.5, 0.5, 1.0, 0.0)), None);
        assert_eq!(beside(square(0.0, 0.0, 1.2, 45.0)), None);
        assert_eq!(beside(a.clone()), None);
        assert_eq!(beside(square(2.5, 0.0, 1.0, 0.0)), Some(vec![NONE, NONE]));
        let bow = vec![DVec2::ZERO, DVec2::ONE, DVec2::X, DVec2::Y];
        assert_eq!(around(&[bow]), None);
    }
}
