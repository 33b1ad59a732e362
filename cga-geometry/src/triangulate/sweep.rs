//! Triangulates polygons with holes by one sweep from bottom to top.
//!
//! The interior of the polygon on the sweep line is a row of *regions*, each between a left edge, where the loop goes
//! down, and a right edge, where the loop goes up. Below the line each region is triangulated except for a *chain* of
//! points that leads from the lower end of its left edge to the lower end of its right edge. A point on one of the two edges
//! cuts off all triangles that it sees from that end of the chain and becomes the new end. A point with both edges
//! above it starts a region, or splits one at the latest point of the chain. A point with both edges below it ends a
//! region or merges two.
//!
//! Triangles are only ever cut off a chain. So for any geometry each edge of each loop is in exactly one triangle
//! (except edges that run back and forth): geometry only selects among the possible ways. Comparisons are exact.
//! Without crossings no triangle is reversed. Collinear corners are kept and make no triangle without area, unless the
//! whole polygon is flat.

mod begin;

use std::cmp::Ordering;

use glam::DVec2;

use crate::each::Each;
use crate::exact::orient;
use crate::small_sort::SmallSort;
use crate::status::{LEFT, RIGHT, Status, is_below};

const NONE: u32 = u32::MAX;

/// An interior part of the sweep line.
#[derive(Clone, Copy)]
struct SweepInterval {
    /// The left and the right edge. An edge is named by the corner where it begins: the left edge by its upper end, the
    /// right edge by its lower end.
    edges: [u32; 2],
    /// The left and the right end of its chain, and the latest link.
    ends: [u32; 2],
    latest: u32,
}

/// A point of a chain.
#[derive(Clone, Copy)]
struct ChainPoint {
    corner: u32,
    /// The links to the left and to the right.
    beside: [u32; 2],
}

/// A corner in the order of the sweep.
#[derive(Clone, Copy)]
struct SweepCorner {
    y: f64,
    x: f64,
    corner: u32,
}

/// Buffers, reused for the next polygon.
#[derive(Default)]
pub(super) struct MonotoneSweep {
    next: Vec<u32>,
    prev: Vec<u32>,
    order: Vec<SweepCorner>,
    /// For each corner the region that its edge bounds.
    region: Vec<u32>,
    regions: Vec<SweepInterval>,
    /// The regions from left to right.
    status: Status,
    links: Vec<ChainPoint>,
    /// The amount by which a triangle may be reversed, and a hole may begin outside.
    slack: f64,
}

impl MonotoneSweep {
    /// Appends the triangles of a polygon. If its loops cross by rounding errors, a triangle that is reversed by less
    /// than `slack` may have to be cut off, because otherwise a large triangle would be reversed.
    pub(super) fn triangulate(&mut self, points: &[DVec2], loop_ends: &[u32], slack: f64, out: &mut Vec<[u32; 3]>) {
        self.slack = slack;
        self.start(points, loop_ends, out);
        let order = std::mem::take(&mut self.order);
        for event in &order {
            self.meet(points, event.corner, out);
        }
        self.order = order;
    }

    /// Links the corners of the loops and sorts them.
    fn start(&mut self, points: &[DVec2], loop_ends: &[u32], out: &mut Vec<[u32; 3]>) {
        let count = points.len();
        self.next.clear();
        self.next.extend(1..=count as u32);
        self.prev.clear();
        self.prev.extend((0..count as u32).map(|i| i.wrapping_sub(1)));
        self.order.clear();
        self.region.clear();
        self.region.resize(count, NONE);
        self.regions.clear();
        self.status.clear();
        self.links.clear();
        let mut first = 0;
        for &end in loop_ends {
            if first < end {
                self.next[end as usize - 1] = first;
                self.prev[first as usize] = end - 1;
                self.close_gaps(points, first, end, out);
            }
            first = end;
        }
        // Loops consist of rising and falling runs, which this sort merges. Among corners at one place, those where
        // edges begin come last, because the edges that end there must be removed first.
        let late = |corner: u32| {
            let (a, b) = (self.prev[corner as usize], self.next[corner as usize]);
            below(points, corner, a) && below(points, corner, b)
        };
        self.order.small_sort_by(|a, b| {
            let order = if a.y != b.y { a.y < b.y } else { a.x < b.x };
            if a.y == b.y && a.x == b.x {
                (late(a.corner), a.corner).cmp(&(late(b.corner), b.corner))
            } else if order {
                Ordering::Less
            } else {
                Ordering::Greater
            }
        });
    }

    /// Cuts off corners equal to their predecessor, with triangles without area, and adds the other corners of the loop
    /// to the order.
    fn close_gaps(&mut self, points: &[DVec2], first: u32, end: u32, out: &mut Vec<[u32; 3]>) {
        let mut left = end - first;
        for corner in first..end {
            let (before, after) = (self.prev[corner as usize], self.next[corner as usize]);
            if points[before as usize] == points[corner as usize] && left > 2 {
                out.push([before, corner, after]);
                self.next[before as usize] = after;
                self.prev[after as usize] = before;
                self.next[corner as usize] = NONE;
                left -= 1;
            }
        }
        if left > 2 {
            let kept = (first..end).filter(|&corner| self.next[corner as usize] != NONE);
            self.order.extend(kept.map(|corner| {
                let DVec2 { x, y } = points[corner as usize];
                SweepCorner { y, x, corner }
            }));
        }
    }

    /// Processes a corner.
    fn meet(&mut self, points: &[DVec2], corner: u32, out: &mut Vec<[u32; 3]>) {
        let (a, b) = (self.prev[corner as usize], self.next[corner as usize]);
        match (below(points, a, corner), below(points, b, corner)) {
            (true, false) => {
                // Up the right edge.
                let region = self.region[a as usize];
                self.attach(points, region, RIGHT, corner, out);
                self.set_edge(region, RIGHT, corner);
            }
            (false, true) => {
                // The loop goes down the left edge, so the sweep climbs it against the loop's direction.
                let region = self.region[corner as usize];
                self.attach(points, region, LEFT, corner, out);
                self.set_edge(region, LEFT, a);
                self.status.set_edge(region, [corner, a].each(|c| points[c as usize]));
            }
            (false, false) => self.begin(points, corner, out),
            (true, true) => {
                let (left, right) = (self.region[a as usize], self.region[corner as usize]);
                if left == right {
                    self.end(left, corner, out);
                    self.status.remove(left);
                } else {
                    self.merge(points, left, right, corner, out);
                }
            }
        }
    }

    fn link(&mut self, corner: u32, beside: [u32; 2]) -> u32 {
        let link = self.links.len() as u32;
        self.links.push(ChainPoint { corner, beside });
        for side in [LEFT, RIGHT] {
            if beside[side] != NONE {
                self.links[beside[side] as usize].beside[1 - side] = link;
            }
        }
        link
    }

    fn set_edge(&mut self, region: u32, side: usize, edge: u32) {
        self.regions[region as usize].edges[side] = edge;
        self.region[edge as usize] = region;
    }

    /// Cuts off the part of the chain that a corner sees from one end, and puts the corner there.
    #[inline]
    fn attach(&mut self, points: &[DVec2], region: u32, side: usize, corner: u32, out: &mut Vec<[u32; 3]>) {
        let mut at = self.regions[region as usize].ends[side];
        loop {
            let ChainPoint { corner: here, beside } = self.links[at as usize];
            let next = beside[1 - side];
            if next == NONE {
                break;
            }
            let then = self.links[next as usize].corner;
            let edge = if side == LEFT { [here, then] } else { [then, here] };
            if !self.sees(points, edge, corner, then) {
                break;
            }
            out.push([edge[0], edge[1], corner]);
            at = next;
        }
        let link = self.link(corner, if side == LEFT { [NONE, at] } else { [at, NONE] });
        let region = &mut self.regions[region as usize];
        region.ends[side] = link;
        region.latest = link;
    }

    /// Returns true if a corner above sees an edge of a chain. `far` is the edge's end away from the corner's side. An
    /// edge without length blocks nothing, nor does an edge that ends at the corner's position.
    #[inline]
    fn sees(&self, points: &[DVec2], edge: [u32; 2], corner: u32, far: u32) -> bool {
        let [l, r, p] = [edge[0], edge[1], corner].each(|c| points[c as usize]);
        if orient(l, r, p) > 0 || l == r || points[far as usize] == p {
            return true;
        }
        let longest = (r - l).length().max((p - l).length()).max((p - r).length());
        0.0 < self.slack && -(r - l).perp_dot(p - l) <= self.slack * longest
    }

    /// Both edges of a region end: the rest of its chain is a fan.
    fn end(&mut self, region: u32, corner: u32, out: &mut Vec<[u32; 3]>) {
        let mut at = self.regions[region as usize].ends[LEFT];
        loop {
            let ChainPoint { corner: here, beside: [_, next] } = self.links[at as usize];
            if next == NONE {
                return;
            }
            out.push([here, self.links[next as usize].corner, corner]);
            at = next;
        }
    }

    /// The right edge of one region meets the left edge of another.
    fn merge(&mut self, points: &[DVec2], left: u32, right: u32, corner: u32, out: &mut Vec<[u32; 3]>) {
        self.attach(points, left, RIGHT, corner, out);
        self.attach(points, right, LEFT, corner, out);
        let (l, r) = (self.regions[left as usize], self.regions[right as usize]);
        // The corner ends one chain and starts the other; one link serves both.
        let shared = l.ends[RIGHT];
        let next = self.links[r.ends[LEFT] as usize].beside[RIGHT];
        self.links[shared as usize].beside[RIGHT] = next;
        let right_end = if next == NONE {
            shared
        } else {
            self.links[next as usize].beside[LEFT] = shared;
            r.ends[RIGHT]
        };
        let merged = &mut self.regions[left as usize];
        merged.ends[RIGHT] = right_end;
        merged.latest = shared;
        self.set_edge(left, RIGHT, r.edges[RIGHT]);
        self.status.remove(right);
    }
}

/// Returns true if one corner comes before another in the order of the sweep.
#[inline]
fn below(points: &[DVec2], a: u32, b: u32) -> bool {
    is_below(points[a as usize], points[b as usize])
}
