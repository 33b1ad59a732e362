//! Winding numbers of loops, from the bounding boxes of runs of their edges.
//!
//! A ray to the right meets no edge of a run whose box is above it, below it or left of its start. If the box is right
//! of the start, only the two ends of the run matter, because crossings in between cancel. So a query visits only the
//! runs whose box contains the start of the ray.

use std::ops::Range;

use glam::DVec2;

use super::contour::FlatLoops;
use super::extent::Extent;
use super::probe::Probe;

/// The number of edges in a run, and of runs in a longer run.
const FAN: usize = 8;

/// The number of boxes and edges that queries may still visit.
pub(crate) struct QueryBudget(pub(crate) usize);

impl QueryBudget {
    #[inline]
    pub(crate) fn spend(&mut self, count: usize) {
        self.0 = self.0.saturating_sub(count);
    }

    #[inline]
    pub(crate) fn is_spent(&self) -> bool {
        self.0 == 0
    }
}

/// The runs of several loops.
#[derive(Default)]
pub(crate) struct Runs {
    /// Loop by loop: runs of edges, then runs of runs, until a few remain.
    extents: Vec<Extent>,
    /// The extents of each loop; short loops have none.
    of_loop: Vec<Range<usize>>,
}

impl Runs {
    /// Sorts the edges of loops into runs. `None` for a loop that is never queried.
    pub(crate) fn fill<'r>(&mut self, section: &FlatLoops<'_>, loops: impl Iterator<Item = Option<&'r Range<usize>>>) {
        self.extents.clear();
        self.of_loop.clear();
        for range in loops {
            let first = self.extents.len();
            if let Some(range) = range.filter(|range| range.len() > 2 * FAN) {
                self.add(section, section.ring(range));
            }
            self.of_loop.push(first..self.extents.len());
        }
    }

    fn add(&mut self, section: &FlatLoops<'_>, ring: &[u32]) {
        let mut level = self.extents.len();
        for start in (0..ring.len()).step_by(FAN) {
            // The last edge of a run ends where the next run starts.
            let end = (start + FAN).min(ring.len());
            let corners = ring[start..end].iter().chain([&ring[end % ring.len()]]);
            self.extents.push(Extent::of(corners.map(|&corner| section.flat[corner as usize])));
        }
        while self.extents.len() - level > FAN {
            let end = self.extents.len();
            for start in (level..end).step_by(FAN) {
                let union = Extent::union(self.extents[start..end.min(start + FAN)].iter().copied());
                self.extents.push(union);
            }
            level = end;
        }
    }

    /// The winding number of a loop around a probe; an arbitrary number if the budget is spent.
    pub(crate) fn winding(
        &self,
        section: &FlatLoops<'_>,
        number: usize,
        range: &Range<usize>,
        probe: &Probe,
        budget: &mut QueryBudget,
    ) -> i32 {
        let extents = &self.of_loop[number];
        let ring = section.ring(range);
        let mut query = WindingQuery { section, ring, extents: &self.extents[extents.clone()], probe, budget };
        if extents.is_empty() {
            return query.edges(0..ring.len());
        }
        let (mut start, mut span) = (0, FAN);
        let mut runs = ring.len().div_ceil(span);
        while runs > FAN {
            start += runs;
            span *= FAN;
            runs = ring.len().div_ceil(span);
        }
        (0..runs).map(|run| query.run(start, span, run)).sum()
    }
}

/// One loop and one probe.
struct WindingQuery<'q> {
    section: &'q FlatLoops<'q>,
    ring: &'q [u32],
    extents: &'q [Extent],
    probe: &'q Probe,
    budget: &'q mut QueryBudget,
}

impl WindingQuery<'_> {
    /// The corner where an edge begins. After the last edge it is the first corner.
    fn corner(&self, number: usize) -> DVec2 {
        let number = if number == self.ring.len() { 0 } else { number };
        self.section.flat[self.ring[number] as usize]
    }

    /// The contribution of a run. The extents of runs of `span` edges begin at `start`.
    fn run(&mut self, start: usize, span: usize, run: usize) -> i32 {
        if self.budget.is_spent() {
            return 0;
        }
        self.budget.spend(1);
        let (extent, at) = (self.extents[start + run], self.probe.at);
        if extent.high.x < at.x || extent.high.y < at.y || at.y < extent.low.y {
            return 0;
        }
        let edges = run * span..self.ring.len().min((run + 1) * span);
        if at.x < extent.low.x {
            return self.probe.rise(self.corner(edges.start), self.corner(edges.end));
        }
        if span == FAN {
            return self.edges(edges);
        }
        let inner_span = span / FAN;
        let inner_runs = self.ring.len().div_ceil(inner_span);
        let inner = run * FAN..inner_runs.min((run + 1) * FAN);
        inner.map(|inner| self.run(start - inner_runs, inner_span, inner)).sum()
    }

    fn edges(&mut self, edges: Range<usize>) -> i32 {
        self.budget.spend(edges.len());
        let mut from = self.corner(edges.start);
        let mut turns = 0;
        for edge in edges {
            let to = self.corner(edge + 1);
            turns += self.probe.turn(from, to);
            from = to;
        }
        turns
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn windings_by_runs_are_those_of_all_edges() {
        // A spiral in and out, which winds around many points several times, as a ring of many runs.
        let count = 1500;
        let place = |i: u32| {
            let (sin, cos) = libm::sincos(f64::from(i) * 0.04);
            DVec2::new(cos, sin) * (1.0 + f64::from(i) * 0.01)
        };
        let flat: Vec<DVec2> = (0..count).map(place).collect();
        let corners: Vec<u32> = (0..count).collect();
        let section = FlatLoops { flat: &flat, corners: &corners, ends: &[count as usize] };
        let range = 0..count as usize;
        let mut runs = Runs::default();
        runs.fill(&section, [Some(&range)].into_iter());
        let mut seen = Vec::new();
        for i in 0..400 {
            let triangle: Vec<u32> = vec![i * 3, (i * 7 + 1) % count, (i * 13 + 5) % count];
            let probe = Probe::beside(&triangle, i % 2 == 0, |corner| flat[corner as usize] * 0.9);
            let all: i32 = (0..flat.len()).map(|i| probe.turn(flat[i], flat[(i + 1) % flat.len()])).sum();
            let mut budget = QueryBudget(usize::MAX);
            assert_eq!(runs.winding(&section, 0, &range, &probe, &mut budget), all);
            assert!(usize::MAX - budget.0 < flat.len() / 2);
            seen.push(all);
        }
        seen.sort_unstable();
        seen.dedup();
        assert!(seen.len() > 3, "{seen:?}");
    }
}
