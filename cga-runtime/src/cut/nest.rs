//! Which loops of a section are outlines, and which are holes of which.
//!
//! Outlines run counter-clockwise, holes clockwise (of a section that is inside out as a whole, the other way). A hole belongs to the smallest outline that winds around it. Each hole
//! is asked for at one point, and only the edges in the same strip of the plane are looked at.

use std::ops::Range;

use glam::DVec2;

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

/// Loops of a section in groups: an outline and its holes. Also buffers.
#[derive(Default)]
pub(super) struct Nest {
    loops: Vec<Loop>,
    /// Loops in the order of groups; where each group ends.
    pub(super) order: Vec<Range<usize>>,
    pub(super) ends: Vec<usize>,
    strips: Strips,
    turns: Vec<i32>,
    touched: Vec<usize>,
}

/// Edges of outlines by the strips they reach into.
#[derive(Default)]
struct Strips {
    low: f64,
    per_unit: f64,
    starts: Vec<usize>,
    edges: Vec<(u32, u32, u32)>,
}

impl Nest {
    /// Sorts the loops of a section into groups.
    pub(super) fn sort(&mut self, section: &Section<'_>) {
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
            self.assign(section, outlines);
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

    fn assign(&mut self, section: &Section<'_>, outlines: usize) {
        let only = self.loops.iter().position(|l| 0.0 <= l.area).filter(|_| outlines == 1);
        if let Some(only) = only {
            let (low, high) = (self.loops[only].low, self.loops[only].high);
            if self.loops.iter().all(|l| low.cmple(l.low).all() && l.high.cmple(high).all()) {
                for (index, l) in self.loops.iter_mut().enumerate() {
                    l.outline = (index != only).then_some(only);
                }
                return;
            }
        }
        self.strips.fill(section, &self.loops);
        self.turns.clear();
        self.turns.resize(self.loops.len(), 0);
        for hole in 0..self.loops.len() {
            if self.loops[hole].area < 0.0 {
                self.loops[hole].outline = self.around(section, hole);
            }
        }
    }

    /// The smallest outline that winds around the middle of the longest edge of a hole. The middle of an edge is never a
    /// corner of another loop.
    fn around(&mut self, section: &Section<'_>, hole: usize) -> Option<usize> {
        let ring = &section.corners[self.loops[hole].range.clone()];
        let at = |i: usize| section.flat[ring[i % ring.len()] as usize];
        let longest = (0..ring.len())
            .max_by(|&i, &j| at(i).distance_squared(at(i + 1)).total_cmp(&at(j).distance_squared(at(j + 1))))?;
        let p = at(longest) * 0.5 + at(longest + 1) * 0.5;
        self.touched.clear();
        for &(a, b, outline) in self.strips.around(p.y) {
            let [a, b] = [a, b].map(|corner| section.flat[corner as usize]);
            let up = a.y <= p.y && p.y < b.y;
            let down = b.y <= p.y && p.y < a.y;
            let turn = if up && orient(a, b, p) > 0 {
                1
            } else if down && orient(a, b, p) < 0 {
                -1
            } else {
                continue;
            };
            self.turns[outline as usize] += turn;
            self.touched.push(outline as usize);
        }
        let mut best: Option<usize> = None;
        for &outline in &self.touched {
            let smaller = best.is_none_or(|best| self.loops[outline].area < self.loops[best].area);
            if self.turns[outline] != 0 && smaller {
                best = Some(outline);
            }
        }
        self.touched.iter().for_each(|&outline| self.turns[outline] = 0);
        best
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
        let outlines = || loops.iter().enumerate().filter(|(_, l)| 0.0 <= l.area);
        let low = outlines().fold(f64::INFINITY, |m, (_, l)| m.min(l.low.y));
        let high = outlines().fold(f64::NEG_INFINITY, |m, (_, l)| m.max(l.high.y));
        let mut count = 0usize;
        let mut height = 0.0;
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
        let y = |corner: u32| section.flat[corner as usize].y;
        each(&mut |a, b, _| {
            count += 1;
            height += (y(a) - y(b)).abs();
        });
        // As many strips as keep the edges in them to a few times their number.
        let many = (2.0 * (high - low) * count as f64 / height).clamp(1.0, count as f64);
        let strips = if many.is_finite() { many as usize } else { 1 };
        self.low = low;
        self.per_unit = strips as f64 / (high - low);
        self.starts.clear();
        self.starts.resize(strips + 1, 0);
        let (low, per_unit) = (self.low, self.per_unit);
        let strip = |y: f64| (((y - low) * per_unit) as usize).min(strips - 1);
        let span = |a: u32, b: u32| strip(y(a).min(y(b)))..=strip(y(a).max(y(b)));
        each(&mut |a, b, _| span(a, b).for_each(|s| self.starts[s + 1] += 1));
        (0..strips).for_each(|s| self.starts[s + 1] += self.starts[s]);
        let mut fill = self.starts.clone();
        self.edges.clear();
        self.edges.resize(self.starts[strips], (0, 0, 0));
        each(&mut |a, b, index| {
            for s in span(a, b) {
                self.edges[fill[s]] = (a, b, index);
                fill[s] += 1;
            }
        });
    }

    fn around(&self, y: f64) -> &[(u32, u32, u32)] {
        let strips = self.starts.len() - 1;
        let strip = (((y - self.low) * self.per_unit) as usize).min(strips - 1);
        &self.edges[self.starts[strip]..self.starts[strip + 1]]
    }
}
