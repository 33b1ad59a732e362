//! The rims of strips: arcs are collected edge by edge, and joined to rings at the end.

use glam::DVec2;

use super::Strip;
use crate::geometry::disjoint::DisjointSets;

/// A directed side of one strip, with the strip on its left.
#[derive(Clone, Copy, Debug)]
struct Arc {
    from: u32,
    to: u32,
    /// True if it is an edge of the final wavefront.
    is_front: bool,
}

/// The sides of all strips. The sides of each strip begin with its edge.
#[derive(Debug, Default)]
pub(super) struct Arcs {
    of: Vec<Vec<Arc>>,
}

impl Arcs {
    /// Adds the next edge.
    pub(super) fn edge(&mut self, from: u32, to: u32) {
        self.of.push(vec![Arc { from, to, is_front: false }]);
    }

    /// Adds a line that no edge of the polygon is on.
    pub(super) fn line(&mut self) {
        self.of.push(Vec::new());
    }

    /// Adds a path with one strip on its left and one on its right.
    pub(super) fn path(&mut self, from: u32, to: u32, left: u32, right: u32) {
        if from != to && left != right {
            self.of[left as usize].push(Arc { from, to, is_front: false });
            self.of[right as usize].push(Arc { from: to, to: from, is_front: false });
        }
    }

    /// Adds an edge of the final wavefront, with its strip on the right.
    pub(super) fn front(&mut self, from: u32, to: u32, edge: u32) {
        if from != to {
            self.of[edge as usize].push(Arc { from: to, to: from, is_front: true });
        }
    }

    /// For each point the point that replaces it when very short arcs are contracted, in space and, with `times`, in time. The first `fixed` points, those
    /// of the polygon, are not merged with each other.
    pub(super) fn contracted(&self, points: &[DVec2], times: Option<&[f64]>, fixed: usize, epsilon: f64) -> Vec<u32> {
        let mut same = DisjointSets::new(points.len());
        for arc in self.of.iter().flatten() {
            let [from, to] = [arc.from, arc.to].map(|point| point as usize);
            // Beside an edge that does not move, points at different times coincide.
            let is_now = times.is_none_or(|times| (times[from] - times[to]).abs() <= epsilon);
            if is_now && points[from].distance(points[to]) <= epsilon {
                let [a, b] = [arc.from, arc.to].map(|point| same.find_and_shorten(point));
                if fixed <= a.max(b) as usize {
                    same.unite(a, b);
                }
            }
        }
        same.flatten();
        (0..points.len() as u32).map(|point| same.find(point)).collect()
    }

    /// Joins the arcs to rings, with points replaced by `same`.
    pub(super) fn strips(&mut self, same: &[u32]) -> Vec<Strip> {
        for arcs in &mut self.of {
            arcs.iter_mut().for_each(|arc| (arc.from, arc.to) = (same[arc.from as usize], same[arc.to as usize]));
            arcs.retain(|arc| arc.from != arc.to);
        }
        let mut strips = Vec::new();
        for (edge, arcs) in (0..).zip(&self.of) {
            follow(edge, arcs, &mut strips);
        }
        strips
    }
}

fn follow(edge: u32, arcs: &[Arc], strips: &mut Vec<Strip>) {
    let mut used = vec![false; arcs.len()];
    // Arcs back and forth are not sides.
    for i in 0..arcs.len() {
        let back = |k: &usize| !used[*k] && (arcs[*k].from, arcs[*k].to) == (arcs[i].to, arcs[i].from);
        if let Some(k) = (i + 1..arcs.len()).find(back).filter(|_| !used[i]) {
            (used[i], used[k]) = (true, true);
        }
    }
    for start in 0..arcs.len() {
        if used[start] {
            continue;
        }
        let mut strip = Strip { edge, ring: Vec::new(), front: Vec::new() };
        let mut at = Some(start);
        while let Some(arc) = at {
            used[arc] = true;
            strip.ring.push(arcs[arc].from);
            strip.front.push(arcs[arc].is_front);
            let end = arcs[arc].to;
            at =
                if end == arcs[start].from { None } else { (0..arcs.len()).find(|&k| !used[k] && arcs[k].from == end) };
        }
        if 3 <= strip.ring.len() {
            strips.push(strip);
        }
    }
}
