//! Directed edges in a plane into loops, by point identity.
//!
//! Where exactly one edge comes in and one goes out the loop just goes on. Elsewhere, edges that run back and forth cancel,
//! and the rest is paired by angle ([`super::chain`]). Loops that meet themselves are taken apart, so each loop here has
//! every point once. Edges that do not close are given back as chains.

use glam::DVec2;

use super::chain::{self, Chains};

const NONE: u32 = u32::MAX;

/// Loops of one plane, and buffers. Points are numbered from 0 within the plane.
#[derive(Default)]
pub(super) struct Contour {
    /// Number within the plane of each point of the cut, or [`NONE`].
    numbers: Vec<u32>,
    /// Point of the cut by number.
    pub(super) points: Vec<u32>,
    pub(super) flat: Vec<DVec2>,
    edges: Vec<[u32; 2]>,
    next: Vec<u32>,
    /// Loops one after the other, as numbers.
    pub(super) corners: Vec<u32>,
    pub(super) ends: Vec<usize>,
    chains: Chains,
    on_stack: Vec<u32>,
    stack: Vec<u32>,
}

impl Contour {
    /// Makes room for the points of a cut.
    pub(super) fn reset(&mut self, points: usize) {
        self.numbers.clear();
        self.numbers.resize(points, NONE);
    }

    /// Finds the loops of some edges between points of the cut. `flat` gives the place of a point in the plane. Chains
    /// that do not close are handed to `open`, as points of the cut.
    pub(super) fn follow(&mut self, edges: &[[u32; 2]], flat: impl Fn(u32) -> DVec2, open: impl FnMut(Vec<u32>)) {
        self.points.clear();
        self.flat.clear();
        self.edges.clear();
        self.next.clear();
        self.corners.clear();
        self.ends.clear();
        // A number for each point; where the edge from each leads, as long as there is only one.
        let mut single = true;
        for &[a, b] in edges {
            let (a, b) = (self.number(a, &flat), self.number(b, &flat));
            self.edges.push([a, b]);
            single &= self.next[a as usize] == NONE;
            self.next[a as usize] = b;
        }
        self.points.iter().for_each(|&point| self.numbers[point as usize] = NONE);
        // One way out everywhere, and as many edges as points: one way in everywhere unless two lead to one point.
        if single && self.edges.len() == self.points.len() && self.each_reached_once() {
            self.follow_single();
        } else {
            self.follow_paired(open);
        }
    }

    /// The number of a point within the plane.
    #[inline]
    fn number(&mut self, point: u32, flat: &impl Fn(u32) -> DVec2) -> u32 {
        let number = &mut self.numbers[point as usize];
        if *number == NONE {
            *number = self.points.len() as u32;
            self.points.push(point);
            self.flat.push(flat(point));
            self.next.push(NONE);
        }
        *number
    }

    fn each_reached_once(&mut self) -> bool {
        self.stack.clear();
        self.stack.resize(self.points.len(), 0);
        self.edges.iter().all(|&[_, b]| {
            self.stack[b as usize] += 1;
            self.stack[b as usize] == 1
        })
    }

    fn follow_single(&mut self) {
        for start in 0..self.points.len() as u32 {
            let from = self.corners.len();
            let mut at = start;
            while self.next[at as usize] != NONE {
                self.corners.push(at);
                at = std::mem::replace(&mut self.next[at as usize], NONE);
            }
            self.end_loop(from);
        }
    }

    fn follow_paired(&mut self, mut open: impl FnMut(Vec<u32>)) {
        let mut chains = std::mem::take(&mut self.chains);
        chain::pair(&mut chains, &self.edges, &self.flat);
        for chain in &chains.open {
            open(chain.iter().map(|&number| self.points[number as usize]).collect());
        }
        self.on_stack.clear();
        self.on_stack.resize(self.points.len(), NONE);
        let mut from = 0;
        for &end in &chains.loop_ends {
            self.take_apart(&chains.corners[from..end]);
            from = end;
        }
        self.chains = chains;
    }

    /// A closed walk into loops that have each point once: whenever a point comes again, what lies between is a loop.
    fn take_apart(&mut self, walk: &[u32]) {
        self.stack.clear();
        for &corner in walk {
            if self.on_stack[corner as usize] != NONE {
                let at = self.on_stack[corner as usize] as usize;
                let from = self.corners.len();
                for &popped in &self.stack[at..] {
                    self.on_stack[popped as usize] = NONE;
                    self.corners.push(popped);
                }
                self.stack.truncate(at);
                self.end_loop(from);
            }
            self.on_stack[corner as usize] = self.stack.len() as u32;
            self.stack.push(corner);
        }
        let from = self.corners.len();
        for &popped in &self.stack {
            self.on_stack[popped as usize] = NONE;
            self.corners.push(popped);
        }
        self.end_loop(from);
    }

    /// Two edges back and forth are no loop.
    fn end_loop(&mut self, from: usize) {
        if self.corners.len() < from + 3 {
            self.corners.truncate(from);
        } else {
            self.ends.push(self.corners.len());
        }
    }
}
