//! Removes reversed triangles from a triangulation if the polygon allows it.
//!
//! If loops cross, even if only by rounding errors, a sweep makes reversed triangles. Around each of them a patch of
//! connected triangles is removed. Its rim is a closed chain of corners. It is triangulated again with the least reversed
//! area, by dynamic programming over stretches of the chain. A patch grows along shared edges, so its
//! triangles form a tree and its rim is one chain, even if the polygon has holes. The rim stays, so for any geometry
//! each edge of each loop is still used exactly once.
//!
//! The work is bounded: a few rounds with patches of a given size, and a limit on the number of triangles that are
//! tried.

use std::cmp::Ordering;

use glam::DVec2;

use crate::each::Each;
use crate::exact::orient;
use crate::small_sort::SmallSort;

const NONE: u32 = u32::MAX;

/// The largest number of triangles in a patch, by round. Small patches nearly always suffice.
const PATCHES: [usize; 4] = [6, 24, 96, 180];

/// The limit on tried triangles is `TRIED`, plus `TRIED_EACH` per corner of the polygon.
const TRIED_EACH: usize = 64;
const TRIED: usize = 1 << 20;

/// Buffers, reused for the next polygon.
#[derive(Default)]
pub(super) struct Unfold {
    /// Reversed triangles with their areas, the largest first.
    turned: Vec<(f64, u32)>,
    /// Edges by their corners, whether they go from the higher to the lower number, and their side of a triangle.
    edges: Vec<(u64, bool, u32)>,
    /// For each side of each triangle the side of the neighbour at the same edge.
    twin: Vec<u32>,
    /// True if a triangle was in a patch of this round.
    taken: Vec<bool>,
    patch: Vec<u32>,
    rim: Vec<RimEdge>,
    chain: Vec<u32>,
    table: Vec<StretchPlan>,
    stretches: Vec<[usize; 2]>,
}

/// An edge of a patch's rim.
struct RimEdge {
    corner: u32,
    /// The side of the triangle in the patch.
    side: u32,
    next: usize,
}

/// The best triangulation of a stretch of a chain.
#[derive(Clone, Copy)]
struct StretchPlan {
    cost: Cost,
    /// The third corner of the triangle at the edge that closes the stretch.
    apex: u32,
}

/// The cost of triangles; less is better.
#[derive(Clone, Copy, PartialEq, PartialOrd)]
struct Cost {
    /// The area of reversed triangles.
    turned: f64,
    /// The number of triangles without area.
    flat: u32,
}

impl Cost {
    const NOTHING: Cost = Cost { turned: 0.0, flat: 0 };

    fn of(points: &[DVec2], corners: [u32; 3]) -> Self {
        let [a, b, c] = corners.each(|corner| points[corner as usize]);
        match orient(a, b, c) {
            1 => Cost::NOTHING,
            0 => {
                // Corners of several loops at one position make invisible triangles.
                let [i, j, k] = corners;
                let hidden = (a == b || b == c || c == a) && i != j && j != k && k != i;
                Cost { turned: 0.0, flat: u32::from(!hidden) }
            }
            _ => Cost { turned: twice_area(a, b, c).abs().max(f64::MIN_POSITIVE), flat: 0 },
        }
    }

    fn plus(self, other: Cost) -> Cost {
        Cost { turned: self.turned + other.turned, flat: self.flat + other.flat }
    }
}

fn twice_area(a: DVec2, b: DVec2, c: DVec2) -> f64 {
    (b - a).perp_dot(c - a)
}

impl Unfold {
    /// Replaces reversed triangles, and others around them, if that reduces the reversed area. The triangles of the
    /// polygon begin at `from`.
    pub(super) fn repair(&mut self, points: &[DVec2], loops: usize, triangles: &mut Vec<[u32; 3]>, from: usize) {
        let mut budget = TRIED + TRIED_EACH * points.len();
        for size in PATCHES {
            self.find_turned(points, &triangles[from..]);
            if self.turned.is_empty() {
                return;
            }
            if loops == 1 && points.len() <= size + 2 {
                self.whole(points, triangles, from);
                return;
            }
            self.connect(&triangles[from..]);
            self.taken.clear();
            self.taken.resize(triangles.len() - from, false);
            for at in 0..self.turned.len() {
                let turned = self.turned[at].1;
                if self.taken[turned as usize] {
                    continue;
                }
                self.grow(&triangles[from..], turned, size);
                let count = self.chain.len();
                match budget.checked_sub(count * count * count / 6) {
                    Some(left) => budget = left,
                    None => return,
                }
                self.patch_up(points, &mut triangles[from..]);
            }
        }
    }

    /// Triangulates a whole loop. The sweep of a loop that crosses itself may leave slits, which patches would keep.
    fn whole(&mut self, points: &[DVec2], triangles: &mut Vec<[u32; 3]>, from: usize) {
        self.chain.clear();
        self.chain.extend(0..points.len() as u32);
        let old = triangles[from..].iter().fold(Cost::NOTHING, |sum, &triangle| sum.plus(Cost::of(points, triangle)));
        if self.solve(points).turned < old.turned {
            triangles.truncate(from);
            self.read(|triangle| triangles.push(triangle));
        }
    }

    fn find_turned(&mut self, points: &[DVec2], triangles: &[[u32; 3]]) {
        self.turned.clear();
        for (number, &corners) in triangles.iter().enumerate() {
            let [a, b, c] = corners.each(|corner| points[corner as usize]);
            // The exact test is needed only for triangles that look reversed.
            if twice_area(a, b, c) < 0.0 && orient(a, b, c) < 0 {
                self.turned.push((Cost::of(points, corners).turned, number as u32));
            }
        }
        self.turned.small_sort_by(|a, b| b.0.partial_cmp(&a.0).unwrap_or(Ordering::Equal).then(a.1.cmp(&b.1)));
    }

    /// Finds the twin of each side.
    fn connect(&mut self, triangles: &[[u32; 3]]) {
        self.edges.clear();
        let sides = triangles.as_flattened();
        self.edges.extend((0..sides.len()).map(|side| {
            let (a, b) = (sides[side], sides[if side % 3 == 2 { side - 2 } else { side + 1 }]);
            (u64::from(a.min(b)) << 32 | u64::from(a.max(b)), b < a, side as u32)
        }));
        self.edges.small_sort_unstable();
        self.twin.clear();
        self.twin.resize(sides.len(), NONE);
        // If loops cross, an edge may occur several times.
        for same in self.edges.chunk_by(|a, b| a.0 == b.0) {
            let (up, down) = same.split_at(same.partition_point(|edge| !edge.1));
            for (&(.., a), &(.., b)) in up.iter().zip(down) {
                self.twin[a as usize] = b;
                self.twin[b as usize] = a;
            }
        }
    }

    /// Collects the triangles nearest to a reversed one, and the chain of corners around them.
    fn grow(&mut self, triangles: &[[u32; 3]], turned: u32, size: usize) {
        self.patch.clear();
        self.patch.push(turned);
        self.taken[turned as usize] = true;
        self.rim.clear();
        let corner = |side: u32| triangles[side as usize / 3][side as usize % 3];
        let edge = |side: u32, next: usize| RimEdge { corner: corner(side), side, next };
        self.rim.extend([0, 1, 2].each(|k| edge(3 * turned + k, (k as usize + 1) % 3)));
        let mut at = 0;
        while at < self.rim.len() && self.patch.len() < size {
            let twin = self.twin[self.rim[at].side as usize];
            let beyond = twin / 3;
            if twin == NONE || self.taken[beyond as usize] {
                at += 1;
                continue;
            }
            self.patch.push(beyond);
            self.taken[beyond as usize] = true;
            // The first new edge takes the place of the old one and is not visited again. The second one goes to the
            // end of the list, so that the patch grows evenly.
            let [first, second] = [1, 2].each(|k| 3 * beyond + (twin + k) % 3);
            let new = self.rim.len();
            let next = self.rim[at].next;
            self.rim.push(edge(second, next));
            self.rim[at] = edge(first, new);
            at += 1;
        }
        self.chain.clear();
        let mut at = 0;
        loop {
            self.chain.push(self.rim[at].corner);
            at = self.rim[at].next;
            if at == 0 {
                return;
            }
        }
    }

    /// Triangulates the chain around the patch again.
    fn patch_up(&mut self, points: &[DVec2], triangles: &mut [[u32; 3]]) {
        let costs = self.patch.iter().map(|&triangle| Cost::of(points, triangles[triangle as usize]));
        let old = costs.fold(Cost::NOTHING, Cost::plus);
        if self.solve(points).turned < old.turned {
            let patch = std::mem::take(&mut self.patch);
            let mut free = patch.iter();
            self.read(|triangle| {
                if let Some(&place) = free.next() {
                    triangles[place as usize] = triangle;
                }
            });
            self.patch = patch;
        }
    }

    /// Finds the best triangles of the chain.
    fn solve(&mut self, points: &[DVec2]) -> Cost {
        let count = self.chain.len();
        self.table.clear();
        self.table.resize(count * count, StretchPlan { cost: Cost::NOTHING, apex: 0 });
        let (chain, table) = (&self.chain, &mut self.table);
        for length in 2..count {
            for from in 0..count - length {
                let to = from + length;
                let mut best = StretchPlan { cost: Cost { turned: f64::INFINITY, flat: 0 }, apex: from as u32 + 1 };
                for apex in from + 1..to {
                    let parts = table[from * count + apex].cost.plus(table[apex * count + to].cost);
                    if parts < best.cost {
                        let cost = parts.plus(Cost::of(points, [chain[from], chain[apex], chain[to]]));
                        if cost < best.cost {
                            best = StretchPlan { cost, apex: apex as u32 };
                            if cost == Cost::NOTHING {
                                break;
                            }
                        }
                    }
                }
                table[from * count + to] = best;
            }
        }
        table[count - 1].cost
    }

    /// Passes the triangles that were found to `each`.
    fn read(&mut self, mut each: impl FnMut([u32; 3])) {
        let count = self.chain.len();
        self.stretches.clear();
        self.stretches.push([0, count - 1]);
        while let Some([from, to]) = self.stretches.pop() {
            if from + 1 < to {
                let apex = self.table[from * count + to].apex as usize;
                each([from, apex, to].each(|at| self.chain[at]));
                self.stretches.extend([[from, apex], [apex, to]]);
            }
        }
    }
}
