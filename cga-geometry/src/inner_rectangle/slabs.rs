//! A polygon between lines through its corners.

use crate::each::Each;
use crate::small_sort::SmallSort;
use crate::work;
use glam::DVec2;

/// Coordinates that differ by less, for a polygon with an extent of 1, are the same, as for corners on one line that was turned.
const SAME: f64 = 1e-12;

/// An edge, from left to right.
#[derive(Clone, Copy, Debug)]
pub(super) struct SlabEdge {
    from: DVec2,
    to: DVec2,
}

impl SlabEdge {
    /// The height at a place.
    pub(super) fn at(&self, x: f64) -> f64 {
        if x == self.to.x {
            return self.to.y;
        }
        self.from.y + (self.to.y - self.from.y) * ((x - self.from.x) / (self.to.x - self.from.x))
    }

    /// The rise per length.
    pub(super) fn slope(&self) -> f64 {
        (self.to.y - self.from.y) / (self.to.x - self.from.x)
    }
}

/// A polygon as edges, and the coordinates of its corners along x.
pub(super) struct PolygonSlabs {
    /// Sorted by their left ends.
    edges: Vec<SlabEdge>,
    /// The lines between slabs.
    pub(super) lines: Vec<f64>,
    /// The length of the longest line across each slab, inside the polygon.
    highest: Vec<f64>,
}

impl PolygonSlabs {
    pub(super) fn of(points: &[DVec2], rings: &[Vec<u32>]) -> Self {
        let mut lines: Vec<f64> = rings.iter().flatten().map(|&point| points[point as usize].x).collect();
        lines.small_sort_by(f64::total_cmp);
        lines.dedup_by(|next, kept| *next - *kept <= SAME);
        // The last line at most that far to the right.
        let snapped = |p: DVec2| DVec2::new(lines[lines.partition_point(|line| *line <= p.x).max(1) - 1], p.y);
        let mut edges = Vec::new();
        for ring in rings {
            for (k, &a) in ring.iter().enumerate() {
                let [a, b] = [a, ring[(k + 1) % ring.len()]].each(|point| snapped(points[point as usize]));
                edges.push(if b.x < a.x { SlabEdge { from: b, to: a } } else { SlabEdge { from: a, to: b } });
            }
        }
        edges.small_sort_by(|a, b| a.from.x.total_cmp(&b.from.x));
        let mut slabs = PolygonSlabs { edges, lines, highest: Vec::new() };
        let (mut active, mut next): (Vec<SlabEdge>, usize) = (Vec::new(), 0);
        for slab in 0..slabs.count() {
            if !work::spend(8 * active.len()) {
                slabs.highest.resize(slabs.count(), 0.0);
                break;
            }
            let [low, high] = slabs.span(slab);
            active.retain(|edge| low < edge.to.x);
            while let Some(edge) = slabs.edges.get(next).filter(|edge| edge.from.x <= low) {
                if low < edge.to.x {
                    active.push(*edge);
                }
                next += 1;
            }
            upwards(&mut active, [low, high]);
            let chord =
                |pair: &[SlabEdge]| (pair[1].at(low) - pair[0].at(low)).max(pair[1].at(high) - pair[0].at(high));
            slabs.highest.push(active.chunks_exact(2).map(chord).fold(0.0, f64::max));
        }
        slabs
    }

    /// The number of slabs.
    pub(super) fn count(&self) -> usize {
        self.lines.len().saturating_sub(1)
    }

    /// The number of edges.
    pub(super) fn edge_count(&self) -> usize {
        self.edges.len()
    }

    /// The sides of a slab.
    pub(super) fn span(&self, slab: usize) -> [f64; 2] {
        [self.lines[slab], self.lines[slab + 1]]
    }

    /// The length of the longest line across some slabs, inside the polygon.
    pub(super) fn highest(&self, first: usize, last: usize) -> f64 {
        self.highest[first..=last].iter().copied().fold(0.0, f64::max)
    }

    /// The parts of a slab that are inside the polygon, from bottom to top: the edges below and above each.
    pub(super) fn trapezoids(&self, slab: usize) -> Vec<[SlabEdge; 2]> {
        let [low, high] = self.span(slab);
        let before = self.edges.partition_point(|edge| edge.from.x <= low);
        let mut across: Vec<SlabEdge> = self.edges[..before].iter().filter(|edge| high <= edge.to.x).copied().collect();
        upwards(&mut across, [low, high]);
        across.chunks_exact(2).map(|pair| [pair[0], pair[1]]).collect()
    }

    /// The gaps of the strip between two lines: the intervals of y that no edge covers, inside the polygon.
    pub(super) fn gaps(&self, low: f64, high: f64) -> Vec<[f64; 2]> {
        let middle = low + (high - low) * 0.5;
        let before = self.edges.partition_point(|edge| edge.from.x < high);
        // The covered interval of each edge, and whether it crosses the middle.
        let mut covered: Vec<([f64; 2], bool)> = Vec::new();
        for edge in &self.edges[..before] {
            if edge.to.x <= low {
                continue;
            }
            let ends = match edge.from.x < edge.to.x {
                true => [edge.at(edge.from.x.max(low)), edge.at(edge.to.x.min(high))],
                false => [edge.from.y, edge.to.y],
            };
            let crosses = edge.from.x <= middle && middle < edge.to.x;
            covered.push(([ends[0].min(ends[1]), ends[0].max(ends[1])], crosses));
        }
        covered.small_sort_by(|a, b| a.0[0].total_cmp(&b.0[0]));
        let (mut gaps, mut top, mut inside) = (Vec::new(), f64::INFINITY, false);
        for ([from, to], crosses) in covered {
            if inside && top < from {
                gaps.push([top, from]);
            }
            top = if top == f64::INFINITY { to } else { top.max(to) };
            inside ^= crosses;
        }
        gaps
    }
}

/// Sorts edges that cross a slab from bottom to top.
fn upwards(edges: &mut [SlabEdge], [low, high]: [f64; 2]) {
    let middle = low + (high - low) * 0.5;
    edges.small_sort_by(|a, b| a.at(middle).total_cmp(&b.at(middle)));
}
