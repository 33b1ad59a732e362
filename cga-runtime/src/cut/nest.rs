//! Which loops of a section are outlines, and which are holes of which.
//!
//! Outlines run counter-clockwise, holes clockwise (of a section that is inside out as a whole, the other way). A hole
//! belongs to the smallest outline that winds around it; one that none winds around stays on its own. Each hole is asked
//! for at one point, and only the edges in the same strip of the plane are looked at. Where these are too many, because
//! many edges are long and aslant, a sweep tells ([`super::around`]), unless loops cross.

use std::ops::Range;

use glam::DVec2;

use super::around::{self, Sweep};
use super::contour::Section;
use super::twins::Twins;
use crate::exact::orient;

/// A loop, and for a hole its outline.
struct Loop {
    range: Range<usize>,
    /// Twice the area, negative for a hole.
    area: f64,
    low: DVec2,
    high: DVec2,
    outline: Option<usize>,
}

/// Looking at so many edges takes about as long as the sweep does for a corner.
const SWEEP_FROM: usize = 100;

/// Loops of a section in groups: an outline and its holes. Also buffers.
#[derive(Default)]
pub(crate) struct Nest {
    loops: Vec<Loop>,
    /// Loops in the order of groups; where each group ends.
    pub(crate) order: Vec<Range<usize>>,
    pub(crate) ends: Vec<usize>,
    /// Whether outlines run clockwise and holes counter-clockwise.
    inverted: bool,
    twins: Twins,
    strips: Strips,
    sweep: Sweep,
    /// Holes to ask about, each at its point.
    probes: Vec<(usize, Probe)>,
    turns: Vec<i32>,
    touched: Vec<usize>,
}

/// Edges of outlines by the strips they reach into: across y or across x, whichever way they reach less far.
#[derive(Default)]
struct Strips {
    /// Whether strips are told apart by x.
    by_x: bool,
    low: f64,
    per_unit: f64,
    starts: Vec<usize>,
    edges: Vec<(u32, u32, u32)>,
}

impl Nest {
    /// One loop, which is an outline.
    pub(super) fn single(&mut self, end: usize) {
        self.order.clear();
        self.ends.clear();
        self.order.push(0..end);
        self.ends.push(1);
    }

    /// Sorts the loops of a section into groups.
    pub(crate) fn sort(&mut self, section: &Section<'_>) {
        self.loops.clear();
        let scale = about_one(section);
        let mut start = 0;
        for &end in section.ends {
            self.loops.push(measure(section, start..end, scale));
            start = end;
        }
        // A section that is inside out has its outlines clockwise.
        self.inverted = self.loops.iter().map(|l| l.area).sum::<f64>() < 0.0;
        if self.inverted {
            self.loops.iter_mut().for_each(|l| l.area = -l.area);
        }
        let outlines = self.loops.iter().filter(|l| 0.0 <= l.area).count();
        if outlines < self.loops.len() && outlines != 0 {
            self.assign(section);
        }
        self.order.clear();
        self.ends.clear();
        if self.loops.iter().all(|l| l.outline.is_none()) {
            for l in &self.loops {
                self.order.push(l.range.clone());
                self.ends.push(self.order.len());
            }
            return;
        }
        // Holes behind their outlines, all in the order they were found.
        let mut count = vec![0usize; self.loops.len() + 1];
        for (index, l) in self.loops.iter().enumerate() {
            count[l.outline.unwrap_or(index) + 1] += 1;
        }
        (0..self.loops.len()).for_each(|i| count[i + 1] += count[i]);
        self.order.resize(self.loops.len(), 0..0);
        let mut fill: Vec<usize> = count.clone();
        for (index, l) in self.loops.iter().enumerate() {
            if l.outline.is_none() {
                self.order[count[index]] = l.range.clone();
                fill[index] += 1;
            }
        }
        for l in &self.loops {
            if let Some(outline) = l.outline {
                self.order[fill[outline]] = l.range.clone();
                fill[outline] += 1;
            }
        }
        self.ends.extend((0..self.loops.len()).filter(|&i| self.loops[i].outline.is_none()).map(|i| count[i + 1]));
    }

    fn assign(&mut self, section: &Section<'_>) {
        let Nest { loops, inverted, twins, strips, sweep, probes, .. } = self;
        twins.find(section, loops.iter().map(|l| (l.range.clone(), l.low, l.high)));
        let is_first = |number: usize| twins.first(number).0 == number;
        strips.fill(section, loops, is_first);
        probes.clear();
        for (hole, l) in loops.iter().enumerate().filter(|(hole, l)| l.area < 0.0 && is_first(*hole)) {
            probes.push((hole, Probe::beside(section.ring(&l.range), |corner| strips.turned(section, corner))));
        }
        let asked: usize = probes.iter().map(|(_, probe)| strips.of(probe).len()).sum();
        let is_outline = |number: usize| 0.0 <= loops[number].area;
        if asked > SWEEP_FROM * section.corners.len() && sweep.find(section, *inverted, is_first, is_outline) {
            for &(hole, _) in &*probes {
                loops[hole].outline = Some(sweep.around[hole] as usize).filter(|_| sweep.around[hole] != around::NONE);
            }
        } else {
            self.ask(section);
        }
        // Where outlines are there several times, so are holes: each gets its own.
        for hole in 0..self.loops.len() {
            if self.loops[hole].area < 0.0 {
                let (first, rank) = self.twins.first(hole);
                self.loops[hole].outline = self.loops[first].outline.map(|outline| {
                    let (kind, _) = self.twins.first(outline);
                    self.twins.nth(kind, rank)
                });
            }
        }
    }

    /// Finds, for each hole, the smallest outline that winds around it.
    fn ask(&mut self, section: &Section<'_>) {
        let Nest { loops, strips, turns, touched, probes, .. } = self;
        turns.clear();
        turns.resize(loops.len(), 0);
        for (hole, probe) in &*probes {
            touched.clear();
            for &(a, b, outline) in strips.of(probe) {
                let turn = probe.turn(strips.turned(section, a), strips.turned(section, b));
                if turn != 0 {
                    turns[outline as usize] += turn;
                    touched.push(outline as usize);
                }
            }
            touched.sort_unstable();
            touched.dedup();
            let around = touched.iter().copied().filter(|&outline| turns[outline] != 0);
            loops[*hole].outline = around.min_by(|&a, &b| loops[a].area.total_cmp(&loops[b].area));
            touched.iter().for_each(|&outline| turns[outline] = 0);
        }
    }
}

/// A point just beside the middle of a hole's longest edge, on the side of the solid: no edge goes through it, not even one
/// that lies on the hole's.
struct Probe {
    /// The middle of the edge. The point is off it by ε to the left, and by ε² ahead.
    at: DVec2,
    ahead: DVec2,
}

impl Probe {
    fn beside(ring: &[u32], flat: impl Fn(u32) -> DVec2) -> Self {
        let at = |i: usize| flat(ring[i % ring.len()]);
        let length = |i: usize| at(i).distance_squared(at(i + 1));
        let longest = (0..ring.len()).max_by(|&i, &j| length(i).total_cmp(&length(j))).unwrap_or(0);
        let (a, b) = (at(longest), at(longest + 1));
        Probe { at: a * 0.5 + b * 0.5, ahead: b * 0.5 - a * 0.5 }
    }

    /// Whether it is above a point.
    fn is_above(&self, p: DVec2) -> bool {
        let rise = if self.ahead.x != 0.0 { self.ahead.x } else { self.ahead.y };
        p.y < self.at.y || (p.y == self.at.y && 0.0 < rise)
    }

    /// By how much an edge winds around it: 1 where a ray to the right meets it on its way up, -1 on its way down.
    fn turn(&self, a: DVec2, b: DVec2) -> i32 {
        let (up, down) = (self.is_above(a) && !self.is_above(b), self.is_above(b) && !self.is_above(a));
        if !up && !down {
            return 0;
        }
        let mut side = orient(a, b, self.at);
        if side == 0 {
            let along = b * 0.5 - a * 0.5;
            let (left, ahead) = (along.dot(self.ahead), along.perp_dot(self.ahead));
            side = if left != 0.0 { left.signum() as i32 } else { ahead.signum() as i32 };
        }
        i32::from(up && side > 0) - i32::from(down && side < 0)
    }
}

/// What makes a section about as large as 1 when its areas would be beyond what a number holds.
fn about_one(section: &Section<'_>) -> f64 {
    const RANGE: std::ops::Range<f64> = 1e-100..1e100;
    let Some(&first) = section.corners.first() else { return 1.0 };
    let from = section.flat[first as usize];
    let half =
        section.corners.iter().map(|&corner| (section.flat[corner as usize] * 0.5 - from * 0.5).abs().max_element());
    let half = half.fold(0.0, f64::max);
    if half == 0.0 || RANGE.contains(&half) { 1.0 } else { libm::scalbn(1.0, -libm::ilogb(half)) }
}

/// The area of a loop and its box; the area of a section that is `scale` times as large.
fn measure(section: &Section<'_>, range: Range<usize>, scale: f64) -> Loop {
    let ring = &section.corners[range.clone()];
    let from = section.flat[ring[0] as usize];
    let (mut low, mut high, mut area) = (from, from, 0.0);
    let mut last = DVec2::ZERO;
    for &corner in &ring[1..] {
        let p = section.flat[corner as usize];
        (low, high) = (low.min(p), high.max(p));
        let here = p * scale - from * scale;
        area += last.perp_dot(here);
        last = here;
    }
    Loop { range, area, low, high, outline: None }
}

impl Strips {
    /// Sorts in the edges of outlines, of those that count.
    fn fill(&mut self, section: &Section<'_>, loops: &[Loop], counts: impl Fn(usize) -> bool + Copy) {
        let (mut starts, mut edges) = (std::mem::take(&mut self.starts), std::mem::take(&mut self.edges));
        starts.clear();
        edges.clear();
        let outlines = || loops.iter().enumerate().filter(|(number, l)| 0.0 <= l.area && counts(*number));
        let low = outlines().fold(DVec2::INFINITY, |low, (_, l)| low.min(l.low));
        let high = outlines().fold(DVec2::NEG_INFINITY, |high, (_, l)| high.max(l.high));
        let each = |visit: &mut dyn FnMut(u32, u32, u32)| {
            for (index, l) in outlines() {
                let ring = &section.corners[l.range.clone()];
                let mut last = ring[ring.len() - 1];
                for &here in ring {
                    visit(last, here, index as u32);
                    last = here;
                }
            }
        };
        let (mut count, mut reach) = (0usize, DVec2::ZERO);
        each(&mut |a, b, _| {
            count += 1;
            reach += (section.flat[a as usize] - section.flat[b as usize]).abs();
        });
        let size = high - low;
        self.by_x = reach.x * size.y < reach.y * size.x;
        let along = usize::from(!self.by_x);
        // As many strips as keep the edges in them to a few times their number.
        let many = (2.0 * size[along] * count as f64 / reach[along]).clamp(1.0, count as f64);
        let strips = if many.is_finite() { many as usize } else { 1 };
        self.low = low[along];
        self.per_unit = strips as f64 / size[along];
        let at = |corner: u32| self.number(section.flat[corner as usize][along], strips);
        let spans = |a: u32, b: u32| at(a).min(at(b))..=at(a).max(at(b));
        starts.resize(strips + 1, 0);
        each(&mut |a, b, _| spans(a, b).for_each(|s| starts[s + 1] += 1));
        (0..strips).for_each(|s| starts[s + 1] += starts[s]);
        let mut fill = starts.clone();
        edges.resize(starts[strips], (0, 0, 0));
        each(&mut |a, b, index| {
            for s in spans(a, b) {
                edges[fill[s]] = (a, b, index);
                fill[s] += 1;
            }
        });
        (self.starts, self.edges) = (starts, edges);
    }

    /// The strip of a coordinate.
    fn number(&self, at: f64, strips: usize) -> usize {
        (((at - self.low) * self.per_unit) as usize).min(strips - 1)
    }

    /// A corner, turned so that rays to the right stay in their strip.
    fn turned(&self, section: &Section<'_>, corner: u32) -> DVec2 {
        let p = section.flat[corner as usize];
        if self.by_x { DVec2::new(p.y, -p.x) } else { p }
    }

    /// Edges in the strip of a probe.
    fn of(&self, probe: &Probe) -> &[(u32, u32, u32)] {
        let at = if self.by_x { -probe.at.y } else { probe.at.y };
        let strip = self.number(at, self.starts.len() - 1);
        &self.edges[self.starts[strip]..self.starts[strip + 1]]
    }
}
