//! Edges of outlines by the strip of the plane they reach into, so that a question at a point looks at few of them.

use glam::DVec2;

use super::contour::Section;
use super::nest::Loop;
use super::probe::Probe;

/// Strips lie across y or across x, whichever way edges reach less far.
#[derive(Default)]
pub(super) struct Strips {
    /// Whether strips are told apart by x.
    by_x: bool,
    low: f64,
    per_unit: f64,
    /// Where the edges of each strip begin.
    starts: Vec<usize>,
    edges: Vec<StripEdge>,
}

/// An edge of an outline, from corner to corner.
#[derive(Clone, Copy, Default)]
pub(super) struct StripEdge {
    pub(super) from: u32,
    pub(super) to: u32,
    pub(super) outline: u32,
}

impl Strips {
    /// Sorts in the edges of outlines, of those that count.
    pub(super) fn fill(&mut self, section: &Section<'_>, loops: &[Loop], counts: impl Fn(usize) -> bool + Copy) {
        let (mut starts, mut edges) = (std::mem::take(&mut self.starts), std::mem::take(&mut self.edges));
        starts.clear();
        edges.clear();
        let outlines = || loops.iter().enumerate().filter(|(number, ring)| ring.is_outline() && counts(*number));
        let low = outlines().fold(DVec2::INFINITY, |low, (_, ring)| low.min(ring.low));
        let high = outlines().fold(DVec2::NEG_INFINITY, |high, (_, ring)| high.max(ring.high));
        let each = |visit: &mut dyn FnMut(StripEdge)| {
            for (outline, ring) in outlines() {
                let ring = section.ring(&ring.range);
                let mut from = ring[ring.len() - 1];
                for &to in ring {
                    visit(StripEdge { from, to, outline: outline as u32 });
                    from = to;
                }
            }
        };
        let (mut count, mut reach) = (0usize, DVec2::ZERO);
        each(&mut |edge| {
            count += 1;
            reach += (section.flat[edge.from as usize] - section.flat[edge.to as usize]).abs();
        });
        let size = high - low;
        self.by_x = reach.x * size.y < reach.y * size.x;
        let along = usize::from(!self.by_x);
        // As many strips as keep the edges in them to a few times their number; one where that is not a number.
        let strips = ((2.0 * size[along] * count as f64 / reach[along]) as usize).clamp(1, count.max(1));
        self.low = low[along];
        self.per_unit = strips as f64 / size[along];
        let at = |corner: u32| self.number(section.flat[corner as usize][along], strips);
        let spans = |edge: StripEdge| {
            let (from, to) = (at(edge.from), at(edge.to));
            from.min(to)..=from.max(to)
        };
        starts.resize(strips + 1, 0);
        each(&mut |edge| spans(edge).for_each(|strip| starts[strip + 1] += 1));
        (0..strips).for_each(|strip| starts[strip + 1] += starts[strip]);
        let mut fill = starts.clone();
        edges.resize(starts[strips], StripEdge::default());
        each(&mut |edge| {
            for strip in spans(edge) {
                edges[fill[strip]] = edge;
                fill[strip] += 1;
            }
        });
        (self.starts, self.edges) = (starts, edges);
    }

    /// The strip of a coordinate.
    fn number(&self, at: f64, strips: usize) -> usize {
        (((at - self.low) * self.per_unit) as usize).min(strips - 1)
    }

    /// A corner, turned so that rays to the right stay in their strip.
    pub(super) fn turned(&self, section: &Section<'_>, corner: u32) -> DVec2 {
        let p = section.flat[corner as usize];
        if self.by_x { DVec2::new(p.y, -p.x) } else { p }
    }

    /// Edges in the strip of a probe.
    pub(super) fn of(&self, probe: &Probe) -> &[StripEdge] {
        let height = probe.height();
        let strip = self.number(if self.by_x { -height } else { height }, self.starts.len() - 1);
        &self.edges[self.starts[strip]..self.starts[strip + 1]]
    }
}
