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

/// So many edges looked at are more work than a corner in the sweep.
const SWEEP_FROM: usize = 100;

/// Loops of a section in groups: an outline and its holes. Also buffers.
#[derive(Default)]
pub(crate) struct Nest {
    loops: Vec<Loop>,
    /// Loops in the order of groups; where each group ends.
    pub(crate) order: Vec<Range<usize>>,
    pub(crate) ends: Vec<usize>,
    strips: Strips,
    sweep: Sweep,
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
        let mut start = 0;
        for &end in section.ends {
            self.loops.push(measure(section, start..end));
            start = end;
        }
        // A section that is inside out has its outlines clockwise.
        if self.loops.iter().map(|l| l.area).sum::<f64>() < 0.0 {
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
        self.strips.fill(section, &self.loops);
        let Nest { loops, strips, sweep, .. } = self;
        let holes = || loops.iter().filter(|l| l.area < 0.0);
        let asked: usize = holes().map(|hole| strips.across(hole.low).len()).sum();
        if asked > SWEEP_FROM * section.corners.len()
            && sweep.find(section, |number| 0.0 <= loops[number as usize].area)
        {
            for (hole, &outline) in loops.iter_mut().zip(&sweep.around).filter(|(l, _)| l.area < 0.0) {
                hole.outline = (outline != around::NONE).then_some(outline as usize);
            }
            return;
        }
        self.turns.clear();
        self.turns.resize(self.loops.len(), 0);
        for hole in 0..self.loops.len() {
            if self.loops[hole].area < 0.0 {
                self.loops[hole].outline = self.around(section, hole);
            }
        }
    }

    /// The smallest outline that winds around a hole. Where outlines are there twice, so are holes: each gets its own.
    fn around(&mut self, section: &Section<'_>, hole: usize) -> Option<usize> {
        // Strips across x are met by rays along y.
        let by_x = self.strips.by_x;
        let flat = |corner: u32| {
            let p = section.flat[corner as usize];
            if by_x { DVec2::new(p.y, -p.x) } else { p }
        };
        let probe = Probe::beside(&section.corners[self.loops[hole].range.clone()], flat)?;
        self.touched.clear();
        for &(a, b, outline) in self.strips.at(if by_x { -probe.at.y } else { probe.at.y }) {
            let turn = probe.turn(flat(a), flat(b));
            if turn != 0 {
                self.turns[outline as usize] += turn;
                self.touched.push(outline as usize);
            }
        }
        let Nest { loops, turns, touched, .. } = self;
        touched.sort_unstable();
        touched.dedup();
        let around = touched.iter().copied().filter(|&outline| turns[outline] != 0);
        let least = around.min_by(|&a, &b| loops[a].area.total_cmp(&loops[b].area));
        // Rounding may tell the areas of equal loops apart, but not their boxes.
        let bounds = |index: usize| (loops[index].low, loops[index].high);
        let equal = least.map(bounds);
        touched.retain(|&outline| std::mem::take(&mut turns[outline]) != 0 && Some(bounds(outline)) == equal);
        match touched[..] {
            [] => None,
            [only] => Some(only),
            _ => {
                let same = |other: usize| loops[other].area < 0.0 && bounds(other) == bounds(hole);
                Some(touched[(0..hole).filter(|&other| same(other)).count() % touched.len()])
            }
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
    fn beside(ring: &[u32], flat: impl Fn(u32) -> DVec2) -> Option<Self> {
        let at = |i: usize| flat(ring[i % ring.len()]);
        let longest = (0..ring.len())
            .max_by(|&i, &j| at(i).distance_squared(at(i + 1)).total_cmp(&at(j).distance_squared(at(j + 1))))?;
        let (a, b) = (at(longest), at(longest + 1));
        Some(Probe { at: a * 0.5 + b * 0.5, ahead: b * 0.5 - a * 0.5 })
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

fn measure(section: &Section<'_>, range: Range<usize>) -> Loop {
    let ring = &section.corners[range.clone()];
    let from = section.flat[ring[0] as usize];
    let (mut low, mut high, mut area) = (from, from, 0.0);
    let mut last = DVec2::ZERO;
    for &corner in &ring[1..] {
        let p = section.flat[corner as usize];
        (low, high) = (low.min(p), high.max(p));
        let here = p - from;
        area += last.perp_dot(here);
        last = here;
    }
    Loop { range, area, low, high, outline: None }
}

impl Strips {
    fn fill(&mut self, section: &Section<'_>, loops: &[Loop]) {
        let (mut starts, mut edges) = (std::mem::take(&mut self.starts), std::mem::take(&mut self.edges));
        starts.clear();
        edges.clear();
        let outlines = || loops.iter().enumerate().filter(|(_, l)| 0.0 <= l.area);
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

    /// Edges in the strip of a point.
    fn across(&self, point: DVec2) -> &[(u32, u32, u32)] {
        self.at(point[usize::from(!self.by_x)])
    }

    fn at(&self, at: f64) -> &[(u32, u32, u32)] {
        let strip = self.number(at, self.starts.len() - 1);
        &self.edges[self.starts[strip]..self.starts[strip + 1]]
    }
}
