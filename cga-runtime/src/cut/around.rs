//! Which outline is directly around each loop, by one sweep from bottom to top: what is left of a loop's lowest corner tells.
//!
//! This holds for loops that do not cross, though solids may touch along edges. Comparisons are exact, and edges that come to
//! lie beside each other are held to their order, so loops that cross are found out.

use glam::DVec2;

use super::contour::Section;
use super::row::{Row, Spot};
use crate::exact::orient;

/// No outline.
const NONE: u32 = u32::MAX;
/// Of loops that the sweep has not reached.
const UNKNOWN: u32 = u32::MAX - 1;

/// Buffers.
#[derive(Default)]
pub(super) struct Sweep {
    /// For each loop the outline around it.
    around: Vec<u32>,
    edges: Vec<Edge>,
    events: Vec<Event>,
    row: Row,
}

/// The edge that leaves a corner.
#[derive(Clone, Copy)]
struct Edge {
    low: DVec2,
    high: DVec2,
    /// Whether what is right of it is on the solid's side: an outline's left edges, and the right ones of holes.
    enters: bool,
    owner: u32,
}

/// A corner.
#[derive(Clone, Copy)]
struct Event {
    at: DVec2,
    /// Whether both its edges are above it. Where several corners are at one place these come last.
    begins: bool,
    /// The edge that comes to it and the one that leaves it.
    edges: [u32; 2],
}

impl Sweep {
    /// The outline around a loop, when the sweep has found one.
    pub(super) fn around(&self, number: usize) -> Option<usize> {
        let outline = self.around[number];
        (outline < UNKNOWN).then_some(outline as usize)
    }

    /// Fills `around` for the loops that count; `false` when they cross. Of a section that is inside out, outlines run
    /// clockwise.
    pub(super) fn find(
        &mut self,
        section: &Section<'_>,
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

    /// Sorts the corners; `false` when two in a row are at one place, or one nowhere.
    fn start(&mut self, section: &Section<'_>, inverted: bool, counts: impl Fn(usize) -> bool) -> bool {
        let Sweep { around, edges, events, row } = self;
        around.clear();
        around.resize(section.ends.len(), UNKNOWN);
        edges.clear();
        events.clear();
        row.clear();
        let mut from = 0;
        for (owner, &end) in section.ends.iter().enumerate() {
            let ring = &section.corners[std::mem::replace(&mut from, end)..end];
            if !counts(owner) {
                continue;
            }
            let first = edges.len();
            for (i, &corner) in ring.iter().enumerate() {
                let [a, b] = [corner, ring[(i + 1) % ring.len()]].map(|c| section.flat[c as usize]);
                let down = is_below(b, a);
                let (low, high) = if down { (b, a) } else { (a, b) };
                edges.push(Edge { low, high, enters: down != inverted, owner: owner as u32 });
                let before = if i == 0 { ring.len() - 1 } else { i - 1 };
                events.push(Event { at: a, begins: false, edges: [first + before, first + i].map(|edge| edge as u32) });
            }
        }
        if !edges.iter().all(|edge| edge.low != edge.high && edge.low.is_finite()) {
            return false;
        }
        for event in events.iter_mut() {
            event.begins = event.edges.iter().all(|&edge| edges[edge as usize].low == event.at);
        }
        events.sort_unstable_by(|a, b| {
            let place = is_below(b.at, a.at).cmp(&is_below(a.at, b.at));
            place.then(a.begins.cmp(&b.begins)).then(a.edges.cmp(&b.edges))
        });
        true
    }

    /// Both edges of a corner start above it.
    fn begin(&mut self, event: &Event, is_outline: &impl Fn(usize) -> bool) -> bool {
        let [a, b] = event.edges.map(|edge| self.edges[edge as usize]);
        let turn = orient(event.at, a.high, b.high);
        let [left, right] = if turn < 0 { event.edges } else { [event.edges[1], event.edges[0]] };
        let spot = self.spot(left);
        let owner = a.owner as usize;
        if self.around[owner] == UNKNOWN {
            self.around[owner] = self.row.before(spot).map_or(NONE, |beside| {
                let Edge { enters, owner, .. } = self.edges[beside as usize];
                if enters && is_outline(owner as usize) { owner } else { self.around[owner as usize] }
            });
        }
        turn != 0 && self.insert(spot, left) && {
            let next = self.spot(right);
            self.insert(next, right)
        }
    }

    /// An edge of a corner ends at it, and the other goes on from it or ends too.
    fn go_on(&mut self, event: &Event) -> bool {
        let [a, b] = event.edges;
        match event.edges.map(|edge| self.edges[edge as usize].high == event.at) {
            [true, true] => self.remove(a) && self.remove(b),
            [true, false] => self.replace(a, b),
            [false, true] => self.replace(b, a),
            [false, false] => false,
        }
    }

    /// The place of an edge that begins.
    fn spot(&self, own: u32) -> Spot {
        let own = &self.edges[own as usize];
        self.row.spot(|edge| self.edges[edge as usize].is_left_of(own, own.low, own.high))
    }

    fn insert(&mut self, spot: Spot, edge: u32) -> bool {
        let fits =
            self.are_in_order(self.row.before(spot), Some(edge)) && self.are_in_order(Some(edge), self.row.at(spot));
        self.row.insert(spot, edge);
        fits
    }

    fn find_edge(&self, own: u32) -> Option<Spot> {
        let end = &self.edges[own as usize];
        let spot = self.row.spot(|edge| edge != own && self.edges[edge as usize].is_left_of(end, end.high, end.low));
        if self.row.at(spot) == Some(own) {
            return Some(spot);
        }
        // Edges that went on from the same point are in between: it is one of those that touch it.
        let touches = |edge: u32| self.edges[edge as usize].side(end.high) == 0;
        let mut spot = self.row.spot(|edge| self.edges[edge as usize].side(end.high) < 0);
        while let Some(edge) = self.row.at(spot).filter(|&edge| touches(edge)) {
            if edge == own {
                return Some(spot);
            }
            spot = self.row.next(spot);
        }
        None
    }

    fn replace(&mut self, old: u32, new: u32) -> bool {
        let Some(spot) = self.find_edge(old) else { return false };
        self.row.replace(spot, new);
        self.are_in_order(self.row.before(spot), Some(new)) && self.are_in_order(Some(new), self.row.after(spot))
    }

    fn remove(&mut self, edge: u32) -> bool {
        let Some(spot) = self.find_edge(edge) else { return false };
        self.row.remove(spot);
        self.are_in_order(self.row.before(spot), self.row.at(spot))
    }

    /// Whether two neighbours lie beside each other as far up and down as both reach.
    fn are_in_order(&self, left: Option<u32>, right: Option<u32>) -> bool {
        let (Some(left), Some(right)) = (left, right) else { return true };
        let [left, right] = [left, right].map(|edge| self.edges[edge as usize]);
        // One begins where the other ends, and that is about to go.
        if left.high == right.low || left.low == right.high {
            return true;
        }
        // How far apart they are at the upper of their low ends, and at the lower of their high ends.
        let low = if is_below(left.low, right.low) { -left.side(right.low) } else { right.side(left.low) };
        let high = if is_below(left.high, right.high) { right.side(left.high) } else { -left.side(right.high) };
        // Where two solids touch, one ends and the other begins.
        let touch = low == 0 && high == 0 && !left.enters && right.enters;
        low >= 0 && high >= 0 && (low + high > 0 || touch)
    }
}

impl Edge {
    /// 1 when a point is left of it, -1 when right, 0 on its line.
    #[inline]
    fn side(&self, p: DVec2) -> i32 {
        if self.low == p || self.high == p { 0 } else { orient(self.low, self.high, p) }
    }

    /// Whether it is left of one end of another edge, or goes through it and is left of the other end.
    #[inline]
    fn is_left_of(&self, other: &Edge, at: DVec2, end: DVec2) -> bool {
        match self.side(at) {
            0 => match orient(self.low, self.high, end) {
                0 => !self.enters && other.enters,
                side => side < 0,
            },
            side => side < 0,
        }
    }
}

/// The order of the sweep: up, and to the right where that is equal.
fn is_below(a: DVec2, b: DVec2) -> bool {
    a.y < b.y || (a.y == b.y && a.x < b.x)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What is around each loop; nothing when they cross. Counter-clockwise loops are outlines, or clockwise ones if there is
    /// more of those.
    fn around(loops: &[Vec<DVec2>]) -> Option<Vec<u32>> {
        let flat: Vec<DVec2> = loops.iter().flatten().copied().collect();
        let corners: Vec<u32> = (0..flat.len() as u32).collect();
        let ends: Vec<usize> =
            loops.iter().scan(0, |end, ring| Some(std::mem::replace(end, *end + ring.len()) + ring.len())).collect();
        let area =
            |ring: &[DVec2]| (1..ring.len()).map(|i| (ring[i - 1] - ring[0]).perp_dot(ring[i] - ring[0])).sum::<f64>();
        let mut sweep = Sweep::default();
        let section = Section { flat: &flat, corners: &corners, ends: &ends };
        let total: f64 = loops.iter().map(|ring| area(ring)).sum();
        let is_outline = |number: usize| (area(&loops[number]) > 0.0) == (total > 0.0);
        sweep.find(&section, total < 0.0, |_| true, is_outline).then_some(sweep.around)
    }

    /// A square turned by some degrees, clockwise for a negative size.
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
                // Outline, hole, island, hole …, the outermost first or last.
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
        // Holes that touch the outline with a corner, at a corner, and each other; one ends on the outline's bottom.
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
        // All of a side, part of it, and beyond it; to the right, above, and on both sides.
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
    fn loops_that_cross_or_lie_on_each_other_are_found_out() {
        let a = square(0.0, 0.0, 1.0, 0.0);
        let beside = |other: Vec<DVec2>| around(&[a.clone(), other]);
        assert_eq!(beside(square(1.5, 0.5, 1.0, 0.0)), None);
        assert_eq!(beside(square(0.0, 0.0, 1.2, 45.0)), None);
        assert_eq!(beside(a.clone()), None);
        assert_eq!(beside(square(2.5, 0.0, 1.0, 0.0)), Some(vec![NONE, NONE]));
        let twice = vec![DVec2::ZERO, DVec2::X, DVec2::X, DVec2::Y];
        assert_eq!(around(&[twice]), None);
        let bow = vec![DVec2::ZERO, DVec2::ONE, DVec2::X, DVec2::Y];
        assert_eq!(around(&[bow]), None);
    }
}
