//! The rims of strips: arcs are collected in the order in which they are made, and joined to rings at the end.

use glam::DVec2;

use super::{NONE, Strip};
use crate::buckets::Buckets;
use crate::disjoint::DisjointSets;
use crate::each::Each;

/// A directed side of one strip, with the strip on its left.
#[derive(Clone, Copy, Debug)]
struct Arc {
    strip: u32,
    from: u32,
    to: u32,
    /// True if it is an edge of the final wavefront.
    is_front: bool,
}

/// The sides of all strips. The first side of a strip is its edge.
#[derive(Debug, Default)]
pub(super) struct Arcs {
    all: Vec<Arc>,
    /// The number of lines. Each has a strip, which is empty if no edge of the polygon is on the line.
    lines: u32,
}

impl Arcs {
    /// Adds the next edge.
    pub(super) fn edge(&mut self, from: u32, to: u32) {
        self.all.push(Arc { strip: self.lines, from, to, is_front: false });
        self.lines += 1;
    }

    /// Adds a line that no edge of the polygon is on.
    pub(super) fn line(&mut self) {
        self.lines += 1;
    }

    /// Adds a path with one strip on its left and one on its right.
    pub(super) fn path(&mut self, from: u32, to: u32, left: u32, right: u32) {
        if from != to && left != right {
            self.all.push(Arc { strip: left, from, to, is_front: false });
            self.all.push(Arc { strip: right, from: to, to: from, is_front: false });
        }
    }

    /// Adds an edge of the final wavefront, with its strip on the right.
    pub(super) fn front(&mut self, from: u32, to: u32, edge: u32) {
        if from != to {
            self.all.push(Arc { strip: edge, from: to, to: from, is_front: true });
        }
    }

    /// Sorts the arcs by strips. The arcs of a strip keep their order.
    pub(super) fn sort(&mut self) {
        let buckets = Buckets::by(self.lines as usize, self.all.iter().map(|arc| arc.strip));
        self.all = buckets.items.iter().map(|&arc| self.all[arc as usize]).collect();
    }

    /// For each point the point that replaces it when very short arcs are contracted, in space and, with `times`, in
    /// time. The first `fixed` points, which belong to the polygon, are not merged with each other.
    pub(super) fn contracted(&self, points: &[DVec2], times: Option<&[f64]>, fixed: usize, epsilon: f64) -> Vec<u32> {
        let mut same = DisjointSets::new(points.len());
        for arc in &self.all {
            let [from, to] = [arc.from, arc.to].each(|point| point as usize);
            // Beside an edge that does not move, points at different times coincide.
            let is_now = times.is_none_or(|times| (times[from] - times[to]).abs() <= epsilon);
            if is_now && points[from].distance(points[to]) <= epsilon {
                let [a, b] = [arc.from, arc.to].each(|point| same.find_and_shorten(point));
                if fixed <= a.max(b) as usize {
                    same.unite(a, b);
                }
            }
        }
        same.flatten();
        (0..points.len() as u32).map(|point| same.find(point)).collect()
    }

    /// Joins the sorted arcs to rings, with points replaced by `same`.
    pub(super) fn strips(&mut self, same: &[u32]) -> Vec<Strip> {
        for arc in &mut self.all {
            (arc.from, arc.to) = (same[arc.from as usize], same[arc.to as usize]);
        }
        self.all.retain(|arc| arc.from != arc.to);
        let mut strips = Vec::with_capacity(self.lines as usize);
        for arcs in self.all.chunk_by_mut(|a, b| a.strip == b.strip) {
            follow(arcs, &mut strips);
        }
        strips
    }
}

/// Joins the arcs of one strip. Those that are done begin at [`NONE`].
fn follow(arcs: &mut [Arc], strips: &mut Vec<Strip>) {
    // Arcs back and forth are not sides.
    for i in 0..arcs.len() {
        let Arc { from, to, .. } = arcs[i];
        if let Some(back) = arcs[i + 1..].iter().position(|arc| from != NONE && (arc.from, arc.to) == (to, from)) {
            (arcs[i].from, arcs[i + 1 + back].from) = (NONE, NONE);
        }
    }
    for start in 0..arcs.len() {
        let first = arcs[start].from;
        if first == NONE {
            continue;
        }
        let size = arcs.len() - start;
        let mut strip =
            Strip { edge: arcs[start].strip, ring: Vec::with_capacity(size), front: Vec::with_capacity(size) };
        let mut at = Some(start);
        while let Some(arc) = at.map(|at| &mut arcs[at]) {
            let Arc { to, is_front, .. } = *arc;
            strip.ring.push(std::mem::replace(&mut arc.from, NONE));
            strip.front.push(is_front);
            at = if to == first { None } else { arcs.iter().position(|arc| arc.from == to) };
        }
        if 3 <= strip.ring.len() {
            strips.push(strip);
        }
    }
}
