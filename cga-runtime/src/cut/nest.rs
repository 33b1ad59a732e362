//! Which loops of a section are outlines, and which are holes of which.
//!
//! Outlines run counter-clockwise, holes clockwise (of a section that is inside out as a whole, the other way). A hole
//! belongs to the smallest outline that winds around it; one that none winds around stays on its own. Each hole is asked
//! for at one point just beside it, on the side of the solid, and only the edges in the same strip of the plane are looked
//! at. Where these are too many, because many edges are long and aslant, a sweep tells ([`super::around`]), unless loops
//! cross. Rounding may press what is between a hole and its outline flat, or turn it over: a hole for which nothing is found
//! that could hold it is asked for again at a point well inside.

use std::ops::Range;

use glam::DVec2;

use super::around::Sweep;
use super::contour::Section;
use super::probe::Probe;
use super::strips::Strips;
use super::twins::Twins;
use crate::tol::AROUND_EPSILON;

/// A loop, and for a hole its outline.
pub(super) struct Loop {
    pub(super) range: Range<usize>,
    /// Twice the area, negative for a hole.
    area: f64,
    pub(super) low: DVec2,
    pub(super) high: DVec2,
    outline: Option<usize>,
}

impl Loop {
    pub(super) fn is_outline(&self) -> bool {
        0.0 <= self.area
    }

    /// Whether it could be around a hole, as far as boxes and areas tell, but for rounding. The areas are those of a section
    /// that is `scale` times as large.
    fn may_hold(&self, hole: &Loop, scale: f64) -> bool {
        let slack = AROUND_EPSILON * self.low.abs().max(self.high.abs()).max_element();
        let spare = slack * scale * (self.high * scale - self.low * scale).element_sum();
        self.low.cmple(hole.low + slack).all()
            && hole.high.cmple(self.high + slack).all()
            && -hole.area <= self.area + spare
    }
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
    /// What makes the section about as large as 1.
    scale: f64,
    twins: Twins,
    strips: Strips,
    sweep: Sweep,
    /// Holes to ask about, each at its point.
    probes: Vec<(usize, Probe)>,
    /// How often outlines wind around a point, and which do or nearly do.
    turns: Vec<i32>,
    touched: Vec<usize>,
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
        self.turns.clear();
        self.touched.clear();
        let scale = about_one(section.corners.iter().map(|&corner| section.flat[corner as usize]));
        self.scale = scale;
        let mut start = 0;
        for &end in section.ends {
            self.loops.push(measure(section, start..end, scale));
            start = end;
        }
        // A section that is inside out has its outlines clockwise.
        self.inverted = self.loops.iter().map(|ring| ring.area).sum::<f64>() < 0.0;
        if self.inverted {
            self.loops.iter_mut().for_each(|ring| ring.area = -ring.area);
        }
        let outlines = self.loops.iter().filter(|ring| ring.is_outline()).count();
        if outlines < self.loops.len() && outlines != 0 {
            self.assign(section);
        }
        self.group();
    }

    /// Lists each outline with its holes behind it, all in the order they were found.
    fn group(&mut self) {
        self.order.clear();
        self.ends.clear();
        if self.loops.iter().all(|ring| ring.outline.is_none()) {
            for ring in &self.loops {
                self.order.push(ring.range.clone());
                self.ends.push(self.order.len());
            }
            return;
        }
        // Where each group starts: behind as many loops as are in the groups before.
        let mut starts = vec![0usize; self.loops.len() + 1];
        for (index, ring) in self.loops.iter().enumerate() {
            starts[ring.outline.unwrap_or(index) + 1] += 1;
        }
        (0..self.loops.len()).for_each(|index| starts[index + 1] += starts[index]);
        self.order.resize(self.loops.len(), 0..0);
        let mut next = starts.clone();
        for (index, ring) in self.loops.iter().enumerate() {
            if ring.outline.is_none() {
                self.order[starts[index]] = ring.range.clone();
                next[index] += 1;
            }
        }
        for ring in &self.loops {
            if let Some(outline) = ring.outline {
                self.order[next[outline]] = ring.range.clone();
                next[outline] += 1;
            }
        }
        let outlines = (0..self.loops.len()).filter(|&index| self.loops[index].outline.is_none());
        self.ends.extend(outlines.map(|outline| starts[outline + 1]));
    }

    /// Finds an outline for each hole.
    fn assign(&mut self, section: &Section<'_>) {
        let Nest { loops, inverted, twins, strips, sweep, probes, .. } = self;
        twins.find(section, loops.iter().map(|ring| (ring.range.clone(), ring.low, ring.high)));
        // Rounding depends on where a loop starts. Of an area of about 0 that may be the sign.
        for (number, first) in twins.others() {
            loops[number].area = loops[first].area;
        }
        let is_first = |number: usize| twins.first(number).0 == number;
        strips.fill(section, loops, is_first);
        probes.clear();
        for (hole, ring) in loops.iter().enumerate().filter(|(hole, ring)| !ring.is_outline() && is_first(*hole)) {
            let turned = |corner| strips.turned(section, corner);
            probes.push((hole, Probe::beside(section.ring(&ring.range), *inverted, turned)));
        }
        let asked: usize = probes.iter().map(|(_, probe)| strips.of(probe).len()).sum();
        let is_outline = |number: usize| loops[number].is_outline();
        if asked > SWEEP_FROM * section.corners.len() && sweep.find(section, *inverted, is_first, is_outline) {
            probes.iter().for_each(|&(hole, _)| loops[hole].outline = sweep.around(hole));
        } else {
            self.ask_beside(section);
        }
        self.ask_inside(section);
        // Where outlines are there several times, so are holes: each gets its own.
        for hole in 0..self.loops.len() {
            if !self.loops[hole].is_outline() {
                let (first, rank) = self.twins.first(hole);
                self.loops[hole].outline = self.loops[first].outline.map(|outline| {
                    let (kind, _) = self.twins.first(outline);
                    self.twins.nth(kind, rank)
                });
            }
        }
    }

    /// Finds, for each hole, the smallest outline that winds around the point beside it.
    fn ask_beside(&mut self, section: &Section<'_>) {
        let probes = std::mem::take(&mut self.probes);
        for (hole, probe) in &probes {
            self.wind(section, probe);
            self.loops[*hole].outline = self.smallest_around(|_| true);
        }
        self.probes = probes;
    }

    /// The same, of holes that have no outline that could hold them, for a point inside, if there is one, and outlines that
    /// could.
    fn ask_inside(&mut self, section: &Section<'_>) {
        let mut left = SWEEP_FROM * section.corners.len();
        let probes = std::mem::take(&mut self.probes);
        for (hole, beside) in &probes {
            let hole = *hole;
            let own = &self.loops[hole];
            if own.outline.is_some_and(|outline| self.loops[outline].may_hold(own, self.scale)) {
                continue;
            }
            let turned = |corner| self.strips.turned(section, corner);
            let inside = Probe::inside(section.ring(&own.range), turned);
            let probe = inside.as_ref().unwrap_or(beside);
            // Not more of a section than its size allows: only one that is broken has so many holes that nothing holds.
            let Some(rest) = left.checked_sub(self.strips.of(probe).len()) else { break };
            left = rest;
            self.wind(section, probe);
            let found = self.smallest_around(|outline| outline.may_hold(&self.loops[hole], self.scale));
            self.loops[hole].outline = found.or(self.loops[hole].outline);
        }
        self.probes = probes;
    }

    /// Counts how often outlines wind around a point.
    fn wind(&mut self, section: &Section<'_>, probe: &Probe) {
        let Nest { strips, turns, touched, loops, .. } = self;
        touched.drain(..).for_each(|outline| turns[outline] = 0);
        turns.resize(loops.len(), 0);
        for edge in strips.of(probe) {
            let turn = probe.turn(strips.turned(section, edge.from), strips.turned(section, edge.to));
            if turn != 0 {
                turns[edge.outline as usize] += turn;
                touched.push(edge.outline as usize);
            }
        }
        touched.sort_unstable();
        touched.dedup();
    }

    /// Of the outlines that do, the smallest of some.
    fn smallest_around(&self, counts: impl Fn(&Loop) -> bool) -> Option<usize> {
        let around = self.touched.iter().copied().filter(|&outline| self.turns[outline] != 0);
        let area = |outline: usize| self.loops[outline].area;
        around.filter(|&outline| counts(&self.loops[outline])).min_by(|&a, &b| area(a).total_cmp(&area(b)))
    }
}

/// What makes a section of these corners about as large as 1 when its areas would be beyond what a number holds.
pub(super) fn about_one(mut corners: impl Iterator<Item = DVec2>) -> f64 {
    const RANGE: std::ops::Range<f64> = 1e-100..1e100;
    let Some(from) = corners.next() else { return 1.0 };
    let half = corners.fold(0.0, |half: f64, corner| half.max((corner * 0.5 - from * 0.5).abs().max_element()));
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
