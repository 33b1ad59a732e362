//! Assigns the holes of a section to its outlines.
//!
//! Outlines are counter-clockwise, holes clockwise (the opposite if the section is inside out as a whole). A hole
//! belongs to the smallest outline that winds around it; a hole without such an outline stays separate. Each hole is
//! tested at one point just beside it, on the side of the solid, against the outlines whose bounding box contains the
//! point (`crate::nesting::box_tree`). If this takes too long, because many boxes contain points that their
//! outlines do not, a sweep decides (`crate::nesting::sweep`), unless loops cross. Rounding may flatten or
//! invert the area between a hole and its outline. So a hole without a possible outline is tested again at a point well
//! inside it.
//!
//! The number of boxes and edges that all queries visit is limited per corner of the section. Holes that remain then
//! stay separate. Parts are closed with any assignment of holes to outlines.

mod box_tree;
pub(crate) mod contour;
mod duplicates;
pub(crate) mod extent;
mod measured_loop;
mod pairing;
pub(crate) mod polygons;
mod probe;
mod sweep;
mod winding;

use std::ops::Range;

use glam::DVec2;

use crate::buckets::Buckets;
use crate::tol::PLANAR_EPSILON;
use box_tree::BoxTree;
use contour::FlatLoops;
use duplicates::Twins;
use extent::{Extent, about_one};
use measured_loop::Loop;
pub use polygons::NestedRings;
use probe::Probe;
use sweep::LoopSweep;
use winding::{QueryBudget, Runs};

/// The limit on visited boxes and edges per corner of a section, and the minimum for any section. Sections with loops
/// at random positions need about ten per corner, and the sweep takes about as long as this limit.
const LIMIT: usize = 64;
const SMALL: usize = 1 << 16;

/// The budget for the queries of a section.
fn budget(section: &FlatLoops<'_>) -> QueryBudget {
    QueryBudget(SMALL.max(LIMIT * section.corners.len()))
}

/// The loops of a section in groups, each an outline with its holes, and buffers.
#[derive(Default)]
pub(crate) struct Nest {
    loops: Vec<Loop>,
    by_outline: Buckets,
    /// The loops in the order of groups, and the end of each group.
    order: Vec<Range<usize>>,
    ends: Vec<usize>,
    /// True if outlines are clockwise and holes counter-clockwise.
    inverted: bool,
    /// The factor that scales the section to about 1.
    scale: f64,
    twins: Twins,
    tree: BoxTree,
    runs: Runs,
    sweep: LoopSweep,
    /// The holes to test, each with its point.
    probes: Vec<(usize, Probe)>,
}

impl Nest {
    /// Sorts rings of corners that follow each other, with the positions of the corners. A single ring is an outline.
    pub(crate) fn sort_rings(&mut self, ends: &[usize], at: impl Fn(usize) -> DVec2) {
        if let [end] = *ends {
            self.order.clear();
            self.ends.clear();
            self.order.push(0..end);
            self.ends.push(1);
            return;
        }
        let count = ends.last().copied().unwrap_or(0);
        let flat: Vec<DVec2> = (0..count).map(at).collect();
        let corners: Vec<u32> = (0..count as u32).collect();
        self.sort(&FlatLoops { flat: &flat, corners: &corners, ends });
    }

    /// Sorts the loops of a section into groups.
    pub(crate) fn sort(&mut self, section: &FlatLoops<'_>) {
        self.measure(section);
        // In a section that is inside out, outlines are clockwise. If outlines and holes cancel, the sum is rounding
        // noise.
        let (sum, all) =
            self.loops.iter().fold((0.0, 0.0), |(sum, all), ring| (sum + ring.area, all + ring.area.abs()));
        self.nest(section, sum < -PLANAR_EPSILON * all);
    }

    /// The same for a section that is known to be inside out or not.
    pub(crate) fn sort_as(&mut self, section: &FlatLoops<'_>, inverted: bool) {
        self.measure(section);
        self.nest(section, inverted);
    }

    /// The holes without an outline.
    pub(crate) fn lone_holes(&self) -> impl Iterator<Item = &Range<usize>> {
        self.loops.iter().filter(|ring| !ring.is_outline() && ring.outline.is_none()).map(|ring| &ring.range)
    }

    fn measure(&mut self, section: &FlatLoops<'_>) {
        self.loops.clear();
        let scale = about_one(section.corners.iter().map(|&corner| section.flat[corner as usize]));
        self.scale = scale;
        let mut start = 0;
        for &end in section.ends {
            self.loops.push(measure(section, start..end, scale));
            start = end;
        }
    }

    fn nest(&mut self, section: &FlatLoops<'_>, inverted: bool) {
        self.inverted = inverted;
        if inverted {
            self.loops.iter_mut().for_each(|ring| ring.area = -ring.area);
        }
        let outlines = self.loops.iter().filter(|ring| ring.is_outline()).count();
        if outlines < self.loops.len() && outlines != 0 {
            self.assign(section);
        }
        self.group();
    }

    /// Lists each outline, followed by its holes, in the order in which they were found.
    fn group(&mut self) {
        let Nest { loops, order, ends, by_outline, .. } = self;
        order.clear();
        ends.clear();
        by_outline.fill(loops.len(), (0..).zip(&*loops).map(|(at, ring)| ring.outline.map_or(at, |at| at as u32)));
        for (outline, ring) in loops.iter().enumerate().filter(|(_, ring)| ring.outline.is_none()) {
            order.push(ring.range.clone());
            let holes = by_outline.of(outline).iter().filter(|&&hole| hole as usize != outline);
            order.extend(holes.map(|&hole| loops[hole as usize].range.clone()));
            ends.push(order.len());
        }
    }

    /// The groups: each outline, followed by its holes.
    pub(crate) fn groups(&self) -> impl ExactSizeIterator<Item = &[Range<usize>]> + Clone {
        (0..self.ends.len()).map(|group| {
            let start = if group == 0 { 0 } else { self.ends[group - 1] };
            &self.order[start..self.ends[group]]
        })
    }

    /// Finds an outline for each hole.
    fn assign(&mut self, section: &FlatLoops<'_>) {
        let Nest { loops, inverted, twins, tree, runs, probes, .. } = self;
        twins.find(section, loops.iter().map(|ring| (ring.range.clone(), ring.extent)));
        // Rounding depends on where a loop starts, and for an area of about 0 it may decide the sign.
        for (number, first) in twins.others() {
            loops[number].area = loops[first].area;
        }
        let is_asked = |number: usize| loops[number].is_outline() && twins.first(number).0 == number;
        tree.fill(loops, is_asked);
        runs.fill(section, loops.iter().enumerate().map(|(number, ring)| is_asked(number).then_some(&ring.range)));
        probes.clear();
        for (hole, ring) in loops.iter().enumerate() {
            if !ring.is_outline() && twins.first(hole).0 == hole {
                let place = |corner| section.flat[corner as usize];
                probes.push((hole, Probe::beside(section.ring(&ring.range), *inverted, place)));
            }
        }
        self.ask_beside(section);
        self.ask_inside(section);
        // If outlines occur several times, so do holes: each gets its own outline.
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

    /// Finds for each hole the smallest outline that winds around the point beside it. If the budget is spent and loops
    /// cross, some holes stay without an outline.
    fn ask_beside(&mut self, section: &FlatLoops<'_>) {
        let Nest { loops, inverted, twins, tree, runs, sweep, probes, .. } = self;
        let mut budget = budget(section);
        for (hole, probe) in &*probes {
            let at = probe.at;
            let found = tree.smallest(
                &mut budget,
                |extent| extent.holds(at),
                |outline, budget| runs.winding(section, outline, &loops[outline].range, probe, budget) != 0,
            );
            loops[*hole].outline = found;
        }
        let is_outline = |number: usize| loops[number].is_outline();
        if budget.is_spent() && sweep.find(section, *inverted, |number| twins.first(number).0 == number, is_outline) {
            probes.iter().for_each(|&(hole, _)| loops[hole].outline = sweep.around(hole));
        }
    }

    /// Repeats the test for holes without a possible outline, at a point inside the hole if there is one, with possible
    /// outlines only.
    fn ask_inside(&mut self, section: &FlatLoops<'_>) {
        let Nest { loops, scale, tree, runs, probes, .. } = self;
        let mut budget = budget(section);
        for (hole, beside) in &*probes {
            let own = &loops[*hole];
            if own.outline.is_some_and(|outline| loops[outline].may_hold(own, *scale)) {
                continue;
            }
            let inside = Probe::inside(section.ring(&own.range), |corner| section.flat[corner as usize]);
            let probe = inside.as_ref().unwrap_or(beside);
            let found = tree.smallest(
                &mut budget,
                |extent| own.extent.is_in(extent),
                |outline, budget| {
                    loops[outline].may_hold(own, *scale)
                        && runs.winding(section, outline, &loops[outline].range, probe, budget) != 0
                },
            );
            loops[*hole].outline = found.or(own.outline);
        }
    }
}

/// The area and the bounding box of a loop; the area belongs to the section scaled by `scale`.
fn measure(section: &FlatLoops<'_>, range: Range<usize>, scale: f64) -> Loop {
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
    Loop { range, area, extent: Extent { low, high }, outline: None }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Pseudo-random numbers from 0 to 1.
    fn noise(seed: &mut u32) -> f64 {
        *seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        f64::from(*seed >> 8) / f64::from(1 << 24)
    }

    /// Stars that cross each other, every second one a hole.
    fn stars(count: usize, seed: &mut u32) -> Vec<Vec<DVec2>> {
        let star = |number: usize| {
            let (corners, size) = (3 + (noise(seed) * 40.0) as usize, 0.02 + noise(seed) * noise(seed) * 0.4);
            let centre = DVec2::new(noise(seed), noise(seed));
            let corner = |i: usize| {
                let (sin, cos) = libm::sincos(i as f64 / corners as f64 * std::f64::consts::TAU);
                centre + DVec2::new(cos, sin) * size * (0.3 + noise(seed))
            };
            let mut ring: Vec<DVec2> = (0..corners).map(corner).collect();
            if number % 2 == 1 {
                ring.reverse();
            }
            ring
        };
        (0..count).map(star).collect()
    }

    #[test]
    fn crossing_loops_nest_as_their_windings_say() {
        let mut seed = 1;
        for round in 0..40 {
            let loops = stars(60, &mut seed);
            let flat: Vec<DVec2> = loops.iter().flatten().copied().collect();
            let corners: Vec<u32> = (0..flat.len() as u32).collect();
            let mut end = 0;
            let ends: Vec<usize> = loops.iter().map(|ring| (end += ring.len(), end).1).collect();
            let mut nest = Nest::default();
            nest.sort(&FlatLoops { flat: &flat, corners: &corners, ends: &ends });
            let place = |corner: u32| flat[corner as usize];
            let around = |probe: &Probe, counts: &dyn Fn(&Loop) -> bool| {
                let winds = |number: usize| {
                    let ring = &loops[number];
                    (0..ring.len()).map(|i| probe.turn(ring[i], ring[(i + 1) % ring.len()])).sum::<i32>() != 0
                };
                let outlines = (0..loops.len()).filter(|&i| nest.loops[i].is_outline() && counts(&nest.loops[i]));
                let smaller = |&a: &usize, &b: &usize| nest.loops[a].area.total_cmp(&nest.loops[b].area);
                outlines.filter(|&number| winds(number)).min_by(smaller)
            };
            let mut held = 0;
            for hole in nest.loops.iter().filter(|ring| !ring.is_outline()) {
                let ring = &corners[hole.range.clone()];
                let beside = around(&Probe::beside(ring, nest.inverted, place), &|_| true);
                let holds = |outline: &Loop| outline.may_hold(hole, nest.scale);
                let expected = if beside.is_some_and(|outline| holds(&nest.loops[outline])) {
                    beside
                } else {
                    Probe::inside(ring, place).and_then(|probe| around(&probe, &holds)).or(beside)
                };
                assert_eq!(hole.outline, expected, "round {round}");
                held += usize::from(expected.is_some());
            }
            assert!(5 < held, "round {round}: {held}");
        }
    }
}
