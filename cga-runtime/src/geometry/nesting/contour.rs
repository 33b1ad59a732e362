//! Directed edges in a plane into loops, by point identity.
//!
//! Where exactly one edge comes in and one goes out the loop just goes on. Elsewhere, edges that run back and forth cancel,
//! and the rest is paired by angle ([`super::pairing`]). Loops that meet themselves are taken apart, so each loop here has
//! every point once. Edges that do not close are given back as chains.

use std::ops::Range;

use glam::DVec2;

use super::pairing::{self, Chains};

const NONE: u32 = u32::MAX;

/// Loops of one plane, and buffers.
#[derive(Default)]
pub(crate) struct Contour {
    next: Vec<u32>,
    /// Loops one after the other, as numbers of points.
    pub(crate) corners: Vec<u32>,
    pub(crate) ends: Vec<usize>,
    chains: Chains,
    on_stack: Vec<u32>,
    stack: Vec<u32>,
}

/// Loops with the points they go through.
pub(crate) struct Section<'c> {
    pub(crate) flat: &'c [DVec2],
    pub(crate) corners: &'c [u32],
    pub(crate) ends: &'c [usize],
}

impl Section<'_> {
    /// The corners of a loop.
    pub(crate) fn ring(&self, range: &Range<usize>) -> &[u32] {
        &self.corners[range.clone()]
    }
}

impl Contour {
    /// The loops that were found, of the plane with these points.
    pub(crate) fn section<'c>(&'c self, flat: &'c [DVec2]) -> Section<'c> {
        Section { flat, corners: &self.corners, ends: &self.ends }
    }

    /// Finds the loops of some edges between points on a plane. Chains that do not close are handed to `open`.
    pub(crate) fn follow(&mut self, edges: &[[u32; 2]], flat: &[DVec2], open: impl FnMut(Vec<u32>)) {
        self.corners.clear();
        self.ends.clear();
        if self.is_single(edges, flat.len()) {
            self.follow_single(edges);
        } else {
            self.follow_paired(edges, flat, open);
        }
    }

    /// Notes where the edge from each point leads. Whether there is one way in and one way out wherever there is any.
    fn is_single(&mut self, edges: &[[u32; 2]], points: usize) -> bool {
        self.next.clear();
        self.next.resize(points, NONE);
        for &[a, b] in edges {
            if std::mem::replace(&mut self.next[a as usize], b) != NONE {
                return false;
            }
        }
        self.stack.clear();
        self.stack.resize(points, 0);
        edges.iter().all(|&[_, b]| {
            self.stack[b as usize] += 1;
            self.stack[b as usize] == 1 && self.next[b as usize] != NONE
        })
    }

    fn follow_single(&mut self, edges: &[[u32; 2]]) {
        for &[start, _] in edges {
            let from = self.corners.len();
            let mut at = start;
            while self.next[at as usize] != NONE {
                self.corners.push(at);
                at = std::mem::replace(&mut self.next[at as usize], NONE);
            }
            self.end_loop(from);
        }
    }

    fn follow_paired(&mut self, edges: &[[u32; 2]], flat: &[DVec2], open: impl FnMut(Vec<u32>)) {
        let mut chains = std::mem::take(&mut self.chains);
        pairing::pair(&mut chains, edges, flat);
        chains.open.drain(..).for_each(open);
        self.on_stack.clear();
        self.on_stack.resize(flat.len(), NONE);
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
