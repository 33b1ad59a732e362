//! The lines in which two facets meet.
//!
//! A point within epsilon of a facet's plane is on the plane. So facets that touch, except for rounding, have common points
//! and edges. Where the outline of a facet crosses the plane of another, the crossing becomes a point.

use crate::each::Each;
use crate::small_sort::SmallSort;
use glam::DVec3;

use super::budget::Budget;
use super::edge_table::{EdgeOwner, EdgeTable, NO_CORNER};
use super::facet::Facet;
use super::operation::BooleanError;
use super::point_set::PointSet;

/// Facets whose planes form a smaller angle than this are nearly parallel: the product of their normals is too
/// inaccurate as the direction of the line in which they meet.
const PARALLEL: f64 = 1e-7;

/// The cost of the line in which two facets meet, and of a piece of it.
const PAIR_COST: usize = 16;

/// The part of a facet's outline on the plane of another facet.
#[derive(Default)]
struct PlaneSection {
    /// True if the facet has many edges, so that only those near the other facet are looked at.
    is_local: bool,
    /// True if all corners are on the plane.
    is_flat: bool,
    /// The edges that are looked at, as the numbers of their corners.
    rim: Vec<[usize; 2]>,
    /// The heights of the ends of these edges over the plane, or of all corners if the section is not local.
    heights: Vec<f64>,
    /// The points on the plane.
    points: Vec<u32>,
    /// The edges on the plane.
    runs: Vec<[u32; 2]>,
}

impl PlaneSection {
    /// Compares the corners of a facet with a plane. Returns false if all are on one side.
    fn measure(
        &mut self,
        points: &PointSet,
        facet: &Facet<'_>,
        plane: &Facet<'_>,
        budget: &mut Budget,
    ) -> Result<bool, BooleanError> {
        let height = |point: u32| {
            let height = plane.height(points.at[point as usize]);
            if height.abs() <= points.epsilon { 0.0 } else { height }
        };
        self.heights.clear();
        self.is_local = facet.rim_tree.is_some();
        if let Some(tree) = &facet.rim_tree {
            let compared = tree.near(facet.flat_box(&plane.bounds), &mut self.rim);
            self.heights.extend(self.rim.as_flattened().iter().map(|corner| height(facet.rings.corners[*corner])));
            budget.spend(compared + 2 * self.rim.len())?;
            self.is_flat = self.heights.iter().all(|height| *height == 0.0)
                && facet.rings.corners.iter().all(|point| height(*point) == 0.0);
            return Ok(true);
        }
        self.heights.extend(facet.rings.corners.iter().map(|point| height(*point)));
        budget.spend(facet.rings.corners.len())?;
        let above = self.heights.iter().all(|height| 0.0 < *height);
        self.is_flat = self.heights.iter().all(|height| *height == 0.0);
        Ok(!above && !self.heights.iter().all(|height| *height < 0.0))
    }

    /// Finds the points and edges of the outline on the plane.
    fn cross(&mut self, points: &mut PointSet, facet: &Facet<'_>) {
        self.points.clear();
        self.runs.clear();
        if self.is_local {
            for number in 0..self.rim.len() {
                let [from, to] = self.rim[number];
                self.pass(points, facet, [from, to], [self.heights[2 * number], self.heights[2 * number + 1]]);
            }
        } else {
            for [from, to] in facet.rings.rim() {
                self.pass(points, facet, [from, to], [self.heights[from], self.heights[to]]);
            }
        }
        self.points.small_sort();
        self.points.dedup();
    }

    /// Adds the point or the edge that an edge has on the plane.
    fn pass(&mut self, points: &mut PointSet, facet: &Facet<'_>, edge: [usize; 2], heights: [f64; 2]) {
        let ends = edge.each(|corner| facet.rings.corners[corner]);
        if heights[0] == 0.0 {
            self.points.push(ends[0]);
            if heights[1] == 0.0 {
                self.runs.push(ends);
            }
        } else if heights[0] * heights[1] < 0.0 {
            // Both facets at an edge cross it in the same order.
            let turned = ends[1] < ends[0];
            let [a, b] = if turned { [1, 0] } else { [0, 1] };
            let [start, end] = [ends[a], ends[b]].each(|point| points.at[point as usize]);
            let share = heights[a] / (heights[a] - heights[b]);
            self.points.push(points.number(start + (end - start) * share));
        }
    }

    /// Returns true if the outline has no point on the plane, so that the facets do not meet.
    fn is_apart(&self) -> bool {
        !self.is_local && self.points.is_empty()
    }

    /// Returns true if the facet contains a place on its plane section.
    fn contains(
        &self,
        points: &PointSet,
        facet: &Facet<'_>,
        along: DVec3,
        place: DVec3,
        budget: &mut Budget,
    ) -> Result<bool, BooleanError> {
        let at = place.dot(along);
        let runs_there = |run: &[u32; 2]| {
            let [a, b] = run.each(|point| points.at[point as usize].dot(along));
            a.min(b) < at && at < a.max(b)
        };
        if self.runs.iter().any(runs_there) {
            return Ok(true);
        }
        let (turns, compared) = facet.winding(points, facet.flat(place));
        budget.spend(1 + compared / 2)?;
        Ok(turns != 0)
    }
}

/// Finds the lines in which facets meet.
#[derive(Default)]
pub(super) struct FacetMeeting {
    sections: [PlaneSection; 2],
    on_line: Vec<(f64, u32)>,
    found: Vec<[u32; 2]>,
    /// The pairs of facets in one plane of which one may divide the other.
    pub(super) overlapping: Vec<[u32; 2]>,
}

impl FacetMeeting {
    /// Adds the lines in which two facets meet to both. Pairs of facets in one plane are collected.
    pub(super) fn meet(
        &mut self,
        points: &mut PointSet,
        edges: &mut EdgeTable,
        facets: &[Facet<'_>],
        pair: [u32; 2],
        budget: &mut Budget,
    ) -> Result<(), BooleanError> {
        let [first, second] = pair.each(|facet| &facets[facet as usize]);
        let [a, b] = &mut self.sections;
        if !a.measure(points, first, second, budget)? || !b.measure(points, second, first, budget)? {
            return Ok(());
        }
        budget.spend(PAIR_COST)?;
        if a.is_flat || b.is_flat {
            let mut divides = |pair| Ok(!dividing_edges(points, edges, facets, pair, budget)?.is_empty());
            if divides(pair)? || divides([pair[1], pair[0]])? {
                self.overlapping.push(pair);
            }
            return Ok(());
        }
        a.cross(points, first);
        b.cross(points, second);
        if a.is_apart() || b.is_apart() || (a.points.is_empty() && b.points.is_empty()) {
            return Ok(());
        }
        let along = line_direction(points, first, second, [&a.points, &b.points]);
        let numbers = a.points.iter().chain(&b.points);
        self.on_line.clear();
        self.on_line.extend(numbers.map(|point| (points.at[*point as usize].dot(along), *point)));
        self.on_line.small_sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        self.on_line.dedup_by_key(|entry| entry.1);
        self.found.clear();
        for between in self.on_line.windows(2) {
            let ends = [between[0].1, between[1].1];
            let [from, to] = ends.each(|point| points.at[point as usize]);
            let middle = (from + to) * 0.5;
            if a.contains(points, first, along, middle, budget)? && b.contains(points, second, along, middle, budget)? {
                self.found.push(ends);
            }
        }
        for ends in self.found.drain(..) {
            for facet in pair {
                // The direction is exact whatever the length of the piece, so it counts as long.
                edges.add(ends, along, EdgeOwner { facet, count: 0, corner: NO_CORNER });
            }
        }
        Ok(())
    }
}

/// The direction of the line in which two facets meet.
fn line_direction(points: &PointSet, first: &Facet<'_>, second: &Facet<'_>, found: [&[u32]; 2]) -> DVec3 {
    let along = first.normal.cross(second.normal);
    let length = along.length();
    if PARALLEL < length {
        return along / length;
    }
    let all = || found.into_iter().flatten().map(|point| points.at[*point as usize]);
    let from = all().next().unwrap_or_default();
    let far = |from: DVec3| {
        all().fold(
            from,
            |far, place| {
                if far.distance_squared(from) < place.distance_squared(from) { place } else { far }
            },
        )
    };
    let end = far(from);
    (far(end) - end).try_normalize().unwrap_or(first.normal.any_orthonormal_vector())
}

/// The edges of a facet that may divide another one in the same plane.
pub(super) fn dividing_edges(
    points: &PointSet,
    edges: &EdgeTable,
    facets: &[Facet<'_>],
    [giver, taker]: [u32; 2],
    budget: &mut Budget,
) -> Result<Vec<[u32; 2]>, BooleanError> {
    let (from, to) = (&facets[giver as usize], &facets[taker as usize]);
    let mut near = Vec::new();
    match &from.rim_tree {
        Some(tree) => budget.spend(tree.near(from.flat_box(&to.bounds), &mut near))?,
        None => near.extend(from.rings.rim()),
    }
    budget.spend(near.len())?;
    let is_own = |ends: [u32; 2]| edges.find(ends).is_some_and(|edge| edges.owner(edge, taker).is_some());
    let ends = near.iter().map(|edge| edge.each(|corner| from.rings.corners[corner]));
    Ok(ends.filter(|ends| may_meet(points, to, *ends) && !is_own(*ends)).collect())
}

/// Returns false if an edge in the plane of a facet certainly has no point in it except for corners of the facet.
fn may_meet(points: &PointSet, facet: &Facet<'_>, ends: [u32; 2]) -> bool {
    let [a, b] = ends.each(|point| points.at[point as usize]);
    let is_apart = facet.bounds.high.cmplt(a.min(b)).any() || a.max(b).cmplt(facet.bounds.low).any();
    if is_apart {
        return false;
    }
    if facet.rim_tree.is_some() {
        return true;
    }
    let flat = [a, b].each(|place| facet.flat(place));
    let is_beyond = |edge: [usize; 2]| {
        let outside = [0, 1].each(|end| {
            let left = facet.left_of(points, edge, flat[end]);
            left < -2.0 * points.epsilon || (left <= points.epsilon && facet.rings.corners.contains(&ends[end]))
        });
        let both_on_it = ends.iter().all(|end| edge.iter().any(|corner| facet.rings.corners[*corner] == *end));
        outside[0] && outside[1] && !both_on_it
    };
    !(facet.is_convex && facet.rings.rim().any(is_beyond))
}
