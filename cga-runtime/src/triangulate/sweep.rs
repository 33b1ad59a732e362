//! Polygons with holes into triangles by one sweep from bottom to top.
//!
//! The inside of the polygon on the sweep line is a row of *regions*, each between a left edge, which the loop runs down,
//! and a right edge, which it runs up. Below the line each region is triangulated but for a *chain* of points that leads
//! from the lower end of its left edge to that of its right edge. A point on one of the two edges cuts off from that end
//! of the chain all triangles it sees and becomes the new end. A point with both edges above it starts a region or splits
//! one, at the point of the chain that came last; a point with both edges below it ends a region or merges two.
//!
//! Triangles are cut off a chain and nothing else, so whatever the geometry each edge of each loop is in one triangle
//! (less those that run back and forth): geometry only chooses among the ways to do so. Comparisons are exact. Without
//! crossings no triangle is turned over; collinear corners are kept and make no triangle without area, unless all is flat.

use std::cmp::Ordering;

use glam::DVec2;

use crate::exact::orient;

const NONE: u32 = u32::MAX;

/// A part of the sweep line that is inside.
#[derive(Clone, Copy)]
struct Region {
    /// Edges are named by the corner they leave: the left edge by its upper, the right one by its lower end.
    left: u32,
    right: u32,
    /// Ends of its chain, and the link that came last.
    left_end: u32,
    right_end: u32,
    latest: u32,
}

/// A point of a chain.
#[derive(Clone, Copy)]
struct Link {
    corner: u32,
    prev: u32,
    next: u32,
}

/// Buffers, kept from one polygon to the next.
#[derive(Default)]
pub(super) struct Sweep {
    next: Vec<u32>,
    prev: Vec<u32>,
    order: Vec<u32>,
    /// For each corner the region its edge bounds.
    region: Vec<u32>,
    regions: Vec<Region>,
    /// Regions from left to right.
    status: Vec<u32>,
    links: Vec<Link>,
}

impl Sweep {
    /// Appends the triangles of a polygon.
    pub(super) fn triangulate(&mut self, points: &[DVec2], loop_ends: &[u32], out: &mut Vec<[u32; 3]>) {
        self.start(points, loop_ends, out);
        let order = std::mem::take(&mut self.order);
        for &corner in &order {
            self.meet(points, corner, out);
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
        // At one place, points that begin edges come last: edges that end there are gone by then.
        let late = |corner: u32| {
            let (a, b) = (self.prev[corner as usize], self.next[corner as usize]);
            below(points, corner, a) && below(points, corner, b)
        };
        self.order.sort_unstable_by(|&a, &b| {
            let (p, q) = (points[a as usize], points[b as usize]);
            let order = p.y.partial_cmp(&q.y).and_then(|y| Some(y.then(p.x.partial_cmp(&q.x)?)));
            match order.unwrap_or(Ordering::Equal) {
                Ordering::Equal => (late(a), a).cmp(&(late(b), b)),
                other => other,
            }
        });
    }

    /// Cuts off corners at the same place as the one before them, with triangles without area, and takes the rest of the
    /// loop into the order.
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
            self.order.extend((first..end).filter(|&corner| self.next[corner as usize] != NONE));
        }
    }

    /// The sweep line reaches a corner.
    fn meet(&mut self, points: &[DVec2], corner: u32, out: &mut Vec<[u32; 3]>) {
        let (a, b) = (self.prev[corner as usize], self.next[corner as usize]);
        match (below(points, a, corner), below(points, b, corner)) {
            (true, false) => {
                // Up the right edge.
                let region = self.region[a as usize];
                self.attach_right(points, region, corner, out);
                self.set_right(region, corner);
            }
            (false, true) => {
                // Down the left edge, which the sweep climbs.
                let region = self.region[corner as usize];
                self.attach_left(points, region, corner, out);
                self.set_left(region, a);
            }
            (false, false) => self.begin(points, corner, out),
            (true, true) => {
                let (left, right) = (self.region[a as usize], self.region[corner as usize]);
                if left == right {
                    self.end(left, corner, out);
                    self.remove(points, left, corner);
                } else {
                    self.merge(points, left, right, corner, out);
                }
            }
        }
    }

    fn link(&mut self, corner: u32, prev: u32, next: u32) -> u32 {
        let link = self.links.len() as u32;
        self.links.push(Link { corner, prev, next });
        if prev != NONE {
            self.links[prev as usize].next = link;
        }
        if next != NONE {
            self.links[next as usize].prev = link;
        }
        link
    }

    fn set_left(&mut self, region: u32, edge: u32) {
        self.regions[region as usize].left = edge;
        self.region[edge as usize] = region;
    }

    fn set_right(&mut self, region: u32, edge: u32) {
        self.regions[region as usize].right = edge;
        self.region[edge as usize] = region;
    }

    /// Cuts off what a corner sees from the left end of a chain, and puts it there.
    fn attach_left(&mut self, points: &[DVec2], region: u32, corner: u32, out: &mut Vec<[u32; 3]>) {
        let mut at = self.regions[region as usize].left_end;
        loop {
            let Link { corner: here, next, .. } = self.links[at as usize];
            if next == NONE {
                break;
            }
            let then = self.links[next as usize].corner;
            if !sees(points, here, then, corner, [here, then]) {
                break;
            }
            out.push([here, then, corner]);
            at = next;
        }
        let link = self.link(corner, NONE, at);
        let region = &mut self.regions[region as usize];
        region.left_end = link;
        region.latest = link;
    }

    /// The same from the right end.
    fn attach_right(&mut self, points: &[DVec2], region: u32, corner: u32, out: &mut Vec<[u32; 3]>) {
        let mut at = self.regions[region as usize].right_end;
        loop {
            let Link { corner: here, prev, .. } = self.links[at as usize];
            if prev == NONE {
                break;
            }
            let then = self.links[prev as usize].corner;
            if !sees(points, then, here, corner, [here, then]) {
                break;
            }
            out.push([then, here, corner]);
            at = prev;
        }
        let link = self.link(corner, at, NONE);
        let region = &mut self.regions[region as usize];
        region.right_end = link;
        region.latest = link;
    }

    /// A corner with both edges above it: the start of a region, or of a hole in one.
    fn begin(&mut self, points: &[DVec2], corner: u32, out: &mut Vec<[u32; 3]>) {
        let (a, b) = (self.prev[corner as usize], self.next[corner as usize]);
        let turn = orient(points[a as usize], points[corner as usize], points[b as usize]);
        let right_of = |from: u32, to: u32| -> i32 {
            // On the line it is the corner's own edges that tell.
            let [from, to] = [from, to].map(|c| points[c as usize]);
            let sides = [corner, a, b].map(|c| orient(from, to, points[c as usize]));
            -sides.into_iter().find(|&side| side != 0).unwrap_or(0)
        };
        let at = self.status.partition_point(|&region| {
            let left = self.regions[region as usize].left;
            right_of(self.next[left as usize], left) > 0
        });
        let around = at.checked_sub(1).map(|at| self.status[at]).filter(|&region| {
            let right = self.regions[region as usize].right;
            turn <= 0 && right_of(right, self.next[right as usize]) < 0
        });
        let new = self.regions.len() as u32;
        self.status.insert(at, new);
        if let Some(region) = around {
            // The chain parts at the point that came last; the corner sees it, and goes on from it both ways.
            let old = self.regions[region as usize];
            let Link { corner: last, next, .. } = self.links[old.latest as usize];
            self.links[old.latest as usize].next = NONE;
            let twin = self.link(last, NONE, next);
            let right_end = if old.right_end == old.latest { twin } else { old.right_end };
            self.regions.push(Region { left: a, right: old.right, left_end: twin, right_end, latest: twin });
            self.region[old.right as usize] = new;
            self.region[a as usize] = new;
            self.regions[region as usize].right_end = old.latest;
            self.set_right(region, corner);
            self.attach_right(points, region, corner, out);
            self.attach_left(points, new, corner, out);
        } else {
            let link = self.link(corner, NONE, NONE);
            self.regions.push(Region { left: a, right: corner, left_end: link, right_end: link, latest: link });
            self.region[a as usize] = new;
            self.region[corner as usize] = new;
        }
    }

    /// Both edges of a region end: all that is left of its chain is a fan.
    fn end(&mut self, region: u32, corner: u32, out: &mut Vec<[u32; 3]>) {
        let mut at = self.regions[region as usize].left_end;
        loop {
            let Link { corner: here, next, .. } = self.links[at as usize];
            if next == NONE {
                return;
            }
            out.push([here, self.links[next as usize].corner, corner]);
            at = next;
        }
    }

    /// The right edge of one region meets the left edge of another.
    fn merge(&mut self, points: &[DVec2], left: u32, right: u32, corner: u32, out: &mut Vec<[u32; 3]>) {
        self.attach_right(points, left, corner, out);
        self.attach_left(points, right, corner, out);
        let (l, r) = (self.regions[left as usize], self.regions[right as usize]);
        // The corner ends one chain and starts the other: one link is enough.
        let next = self.links[r.left_end as usize].next;
        self.links[l.right_end as usize].next = next;
        let right_end = if next == NONE {
            l.right_end
        } else {
            self.links[next as usize].prev = l.right_end;
            r.right_end
        };
        let merged = &mut self.regions[left as usize];
        merged.right_end = right_end;
        merged.latest = l.right_end;
        self.set_right(left, r.right);
        self.remove(points, right, corner);
    }

    /// Takes a region whose left edge has come to its end out of the row.
    fn remove(&mut self, points: &[DVec2], region: u32, corner: u32) {
        let guess = self.status.partition_point(|&other| {
            let left = self.regions[other as usize].left;
            let [from, to, p] = [self.next[left as usize], left, corner].map(|c| points[c as usize]);
            orient(from, to, p) < 0
        });
        let at = if self.status.get(guess) == Some(&region) {
            Some(guess)
        } else {
            self.status.iter().position(|&other| other == region)
        };
        if let Some(at) = at {
            self.status.remove(at);
        }
    }
}

/// The order of the sweep: up, and to the right where that is equal.
#[inline]
fn below(points: &[DVec2], a: u32, b: u32) -> bool {
    let (p, q) = (points[a as usize], points[b as usize]);
    p.y < q.y || (p.y == q.y && p.x < q.x)
}

/// Whether a corner above sees the edge of a chain from `left` to `right`, `near` being its end at the corner's side. An
/// edge without length hides nothing, nor does one that ends where the corner is.
#[inline]
fn sees(points: &[DVec2], left: u32, right: u32, corner: u32, [near, far]: [u32; 2]) -> bool {
    let [l, r, p] = [left, right, corner].map(|c| points[c as usize]);
    orient(l, r, p) > 0 || points[near as usize] == points[far as usize] || points[far as usize] == p
}
