//! Edges in a plane where several meet at a point: the successor of each.
//!
//! The interior is left of each edge. In counter-clockwise order around a point, an edge that leaves begins a sector of
//! the interior, and an edge that arrives ends one. So the two are paired like brackets, and the paired loops do not
//! cross. If a section is inside out as a whole, the interior is right of each edge: an arriving edge begins a sector,
//! and a leaving edge ends it.

use std::cmp::Ordering;

use glam::DVec2;

use super::extent::about_one;
use crate::buckets::Buckets;
use crate::exact::orient;
use crate::small_sort::SmallSort;

const NONE: u32 = u32::MAX;

/// The walks, and buffers.
#[derive(Default)]
pub(crate) struct Chains {
    /// Closed walks in sequence. A point may occur several times.
    pub(crate) corners: Vec<u32>,
    pub(crate) loop_ends: Vec<usize>,
    /// Walks that do not close, with both ends.
    pub(crate) open: Vec<Vec<u32>>,
    /// The ends of edges at each point: twice the number of the edge, plus 1 for edges that arrive.
    at: Buckets,
    /// The successor of each edge.
    next: Vec<u32>,
    arrived: Vec<bool>,
    dead: Vec<bool>,
    round: Vec<u32>,
    brackets: Vec<u32>,
}

/// Finds the walks of some edges.
pub(crate) fn pair(chains: &mut Chains, edges: &[[u32; 2]], flat: &[DVec2]) {
    chains.corners.clear();
    chains.loop_ends.clear();
    chains.open.clear();
    chains.at.fill(flat.len(), edges.iter().flatten().copied());
    chains.dead.clear();
    chains.dead.resize(edges.len(), false);
    (0..flat.len()).for_each(|point| chains.cancel(edges, point));
    chains.next.clear();
    chains.next.resize(edges.len(), NONE);
    chains.arrived.clear();
    chains.arrived.resize(edges.len(), false);
    let inverted = is_inside_out(edges, flat);
    (0..flat.len()).for_each(|point| chains.pair_at(edges, flat, point, inverted));
    chains.walk(edges);
}

impl Chains {
    /// Collects the edges at a point: twice the number of an edge, plus 1 for edges that leave.
    fn gather(&mut self, point: usize) {
        self.round.clear();
        let all = self.at.of(point).iter().map(|end| end ^ 1);
        self.round.extend(all.filter(|&item| !self.dead[item as usize / 2]));
    }

    /// Removes pairs of edges that run back and forth between this point and another.
    fn cancel(&mut self, edges: &[[u32; 2]], point: usize) {
        if self.at.of(point).len() < 4 {
            return;
        }
        // By the other end, arriving edges before leaving ones, so that pairs to cancel are neighbours.
        let other = |item: u32| edges[item as usize / 2][(item & 1) as usize];
        self.gather(point);
        self.round.small_sort_by_key(|&item| (other(item), item & 1));
        for same in self.round.chunk_by(|&a, &b| other(a) == other(b)) {
            let arriving = same.partition_point(|item| item & 1 == 0);
            for (a, b) in same[..arriving].iter().zip(&same[arriving..]) {
                self.dead[*a as usize / 2] = true;
                self.dead[*b as usize / 2] = true;
            }
        }
    }

    fn pair_at(&mut self, edges: &[[u32; 2]], flat: &[DVec2], point: usize, inverted: bool) {
        self.gather(point);
        let centre = flat[point];
        let other = |item: u32| flat[edges[item as usize / 2][(item & 1) as usize] as usize];
        if self.round.len() > 2 {
            self.round.small_sort_by(|&a, &b| by_angle(centre, other(a), other(b)));
        }
        // Brackets on a circle: two rounds, so that brackets open at the end are closed at the start.
        self.brackets.clear();
        for turn in 0..2 {
            for &item in &self.round {
                let (edge, leaves) = (item / 2, item & 1 == 1);
                let is_paired = if leaves { self.arrived[edge as usize] } else { self.next[edge as usize] != NONE };
                if leaves != inverted {
                    if turn == 0 {
                        self.brackets.push(edge);
                    }
                } else if !is_paired && let Some(open) = self.brackets.pop() {
                    let [arriving, leaving] = if leaves { [open, edge] } else { [edge, open] };
                    self.next[arriving as usize] = leaving;
                    self.arrived[leaving as usize] = true;
                }
            }
        }
    }

    fn walk(&mut self, edges: &[[u32; 2]]) {
        // Open walks begin at an edge without a predecessor. When they are done, only circles remain.
        for first in 0..edges.len() {
            if self.dead[first] || self.arrived[first] {
                continue;
            }
            let mut chain = vec![edges[first][0]];
            let mut at = first;
            loop {
                self.dead[at] = true;
                chain.push(edges[at][1]);
                match self.next[at] {
                    NONE => break,
                    next => at = next as usize,
                }
            }
            self.open.push(chain);
        }
        for first in 0..edges.len() {
            let mut at = first;
            while !self.dead[at] {
                self.dead[at] = true;
                self.corners.push(edges[at][0]);
                at = self.next[at] as usize;
            }
            if self.loop_ends.last().copied().unwrap_or(0) < self.corners.len() {
                self.loop_ends.push(self.corners.len());
            }
        }
    }
}

/// Returns true if the closed part of the edges encloses more area clockwise than counter-clockwise.
fn is_inside_out(edges: &[[u32; 2]], flat: &[DVec2]) -> bool {
    let Some(&[first, _]) = edges.first() else { return false };
    let ends = edges.iter().flatten().map(|&end| flat[end as usize]);
    let (from, scale) = (flat[first as usize], about_one(ends));
    let at = |end: u32| flat[end as usize] * scale - from * scale;
    edges.iter().map(|&[a, b]| at(a).perp_dot(at(b))).sum::<f64>() < 0.0
}

/// Counter-clockwise from the right, as seen from a centre. A point at the centre has no order.
fn by_angle(centre: DVec2, a: DVec2, b: DVec2) -> Ordering {
    let lower = |p: DVec2| p.y < centre.y || (p.y == centre.y && p.x < centre.x);
    lower(a).cmp(&lower(b)).then_with(|| 0.cmp(&orient(centre, a, b)))
}
