//! Edges in one line with different speeds.
//!
//! The path of a vertex between them is not determined. Where slopes go on over their neighbours, the faster edge takes the
//! place of the slower one, as if the vertex moved along it at once. Of two planes that meet in a level line, the
//! flatter one is the lower one from there on.

use super::wavefront::{Wavefront, WavefrontVertex, turn_back};
use crate::each::Each;

impl Wavefront {
    /// Lets faster edges take the place of slower ones at the given vertices, which start now. The list then has those that
    /// are still there, and new ones.
    pub(super) fn overtake(&mut self, made: &mut Vec<u32>) {
        if !self.overtakes {
            return;
        }
        let mut at = 0;
        while let Some(&vertex) = made.get(at) {
            at += 1;
            let WavefrontVertex { node, before, after, last, next, alive, stuck, .. } = self.vertices[vertex as usize];
            let [a, b] = [before, after].each(|line| self.lines[line as usize]);
            // A loop of two edges has no area.
            if !alive || !stuck || turn_back(&a, &b) || last == next {
                continue;
            }
            self.vertices[vertex as usize].alive = false;
            // The other end of the slower edge goes on between the faster one and the edge beyond.
            let new = if a.speed < b.speed {
                let corner = self.end_now(last);
                self.arcs.path(corner, node, after, before);
                self.join(self.vertices[last as usize].last, corner, vertex, next)
            } else {
                let corner = self.end_now(next);
                self.arcs.path(node, corner, before, after);
                self.join(last, corner, next, self.vertices[next as usize].next)
            };
            made.push(new);
            self.alive.push(new);
        }
        made.retain(|&vertex| self.vertices[vertex as usize].alive);
        self.renew(&[]);
    }

    /// Ends a vertex where it is. Returns its node.
    fn end_now(&mut self, vertex: u32) -> u32 {
        let WavefrontVertex { node, born, .. } = self.vertices[vertex as usize];
        let here = if born == self.now { node } else { self.node(self.at(vertex, self.now)) };
        self.end_at(vertex, here);
        here
    }
}
