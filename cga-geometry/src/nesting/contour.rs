//! Joins directed edges in a plane to loops, by point identity.
//!
//! At a point with one incoming and one outgoing edge the loop simply continues. At other points, edges that run back
//! and forth cancel, and the others are paired by angle ([`super::pairing`]). Loops that meet themselves are divided,
//! so each loop has every point once. Edges that do not close are returned as chains.

use std::ops::Range;

use glam::DVec2;

use super::pairing::{self, Chains};

const NONE: u32 = u32::MAX;

/// The loops of one plane, and buffers.
#[derive(Default)]
pub(crate) struct Contour {
    next: Vec<u32>,
    /// The loops in sequence, as numbers of points.
    pub(crate) corners: Vec<u32>,
    pub(crate) ends: Vec<usize>,
    chains: Chains,
    on_stack: Vec<u32>,
    stack: Vec<u32>,
}

/// Loops with their points.
pub(crate) struct FlatLoops<'c> {
    pub(crate) flat: &'c [DVec2],
    pub(crate) corners: &'c [u32],
    pub(crate) ends: &'c [usize],
}

impl FlatLoops<'_> {
    /// The corners of a loop.
    pub(crate) fn ring(&self, range: &Range<usize>) -> &[u32] {
        &self.corners[range.clone()]
    }
}

impl Contour {
    /// The loops that were found. `flat` are the points on the plane.
    pub(crate) fn section<'c>(&'c self, flat: &'c [DVec2]) -> FlatLoops<'c> {
        FlatLoops { flat, corners: &self.corners, ends: &self.ends }
    }

    /// Finds the loops of some edges between points on a plane. Chains that do not close are passed to `open`.
    pub(crate) fn follow(&mut self, edges: &[[u32; 2]], flat: &[DVec2], open: impl FnMut(Vec<u32>)) {
        self.corners.clear();
        self.ends.clear();
        if self.is_single(edges, flat.len()) {
            self.follow_single(edges);
        } else {
            self.follow_paired(edges, flat, open);
        }
    }

    /// Records the successor of each point. Returns whether every point that is used has one incoming and one outgoing
    /// edge.
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

    /// Divides a closed walk into loops that have each point once. When a point occurs again, the part in between is a
    /// loop.
    fn take_apart(&mut self, walk: &[u32]) {
        self.stack.clear();
        for &corner in walk {
            if self.on_stack[corner as usize] != NONE {
                self.pop_loop(self.on_stack[corner as usize] as usize);
            }
            self.on_stack[corner as usize] = self.stack.len() as u32;
            self.stack.push(corner);
        }
        self.pop_loop(0);
    }

    /// Makes a loop of the corners on the stack from a number on.
    fn pop_loop(&mut self, start: usize) {
        let from = self.corners.len();
        self.corners.extend(self.stack.drain(start..));
        self.corners[from..].iter().for_each(|&corner| self.on_stack[corner as usize] = NONE);
        self.end_loop(from);
    }

    /// Ends a loop. Two edges back and forth are dropped.
    fn end_loop(&mut self, from: usize) {
        if self.corners.len() < from + 3 {
            self.corners.truncate(from);
        } else {
            self.ends.push(self.corners.len());
        }
    }
}
