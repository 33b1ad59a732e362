//! Divides the edges of an arrangement until the edges of each facet meet in points only.
//!
//! An edge that passes a point within epsilon is led through it, and edges that cross are led through a new point. So an edge
//! moves by up to epsilon, and may then pass other points: the facets of divided edges are compared again.

use super::budget::Budget;
use super::edge_table::EdgeTable;
use super::facet::Facet;
use super::operation::BooleanError;
use super::point_set::PointSet;
use crate::geometry::exact::orient;

/// The limit on rounds. Two suffice for most arrangements.
const MOST_ROUNDS: usize = 32;

/// The points at which edges are to be divided: pairs of an edge and a point.
type Cuts = Vec<[u32; 2]>;

/// Divides all edges where they meet.
pub(super) fn divide_edges(
    points: &mut PointSet,
    edges: &mut EdgeTable,
    facets: &mut [Facet],
    budget: &mut Budget,
) -> Result<(), BooleanError> {
    let mut open: Vec<u32> = (0..facets.len() as u32).filter(|facet| has_company(edges, facets, *facet)).collect();
    for _ in 0..MOST_ROUNDS {
        let mut cuts = Cuts::new();
        for &facet in &open {
            compare_edges(points, edges, &facets[facet as usize], &mut cuts, budget)?;
        }
        if cuts.is_empty() {
            return Ok(());
        }
        cuts.sort_unstable();
        cuts.dedup();
        open.clear();
        let mut here = Vec::new();
        for group in cuts.chunk_by(|a, b| a[0] == b[0]) {
            here.clear();
            here.extend(group.iter().map(|[_, point]| *point));
            edges.divide(facets, points, group[0][0], &mut here, &mut open);
            budget.check(edges)?;
        }
        open.sort_unstable();
        open.dedup();
    }
    Err(BooleanError::Tangled)
}

/// Returns true if the edges of a facet may meet elsewhere than at corners.
fn has_company(edges: &EdgeTable, facets: &[Facet], number: u32) -> bool {
    let facet = &facets[number as usize];
    let is_foreign = |line: &u32| edges.owner(*line, number).is_none_or(|owner| owner.count == 0);
    !facet.is_convex || facet.lines.iter().any(is_foreign)
}

/// Finds where the edges in the plane of a facet meet, by a sweep over their boxes.
fn compare_edges(
    points: &mut PointSet,
    edges: &EdgeTable,
    facet: &Facet,
    cuts: &mut Cuts,
    budget: &mut Budget,
) -> Result<(), BooleanError> {
    let reach = points.epsilon;
    let extent = |line: u32| {
        let [a, b] = edges.list[line as usize].ends.map(|end| facet.flat(points.at[end as usize]));
        (a.min(b) - reach, a.max(b) + reach, line)
    };
    let mut boxes: Vec<_> = facet.lines.iter().map(|line| extent(*line)).collect();
    boxes.sort_unstable_by(|a, b| a.0.x.total_cmp(&b.0.x).then(a.2.cmp(&b.2)));
    let mut active: Vec<usize> = Vec::new();
    for (number, &(low, high, line)) in boxes.iter().enumerate() {
        budget.spend(active.len())?;
        active.retain(|&other| low.x <= boxes[other].1.x);
        for &other in &active {
            let (its_low, its_high, its_line) = boxes[other];
            if its_low.y <= high.y && low.y <= its_high.y {
                compare_pair(points, edges, facet, [line, its_line], cuts);
            }
        }
        active.push(number);
    }
    Ok(())
}

/// Finds where two edges divide each other.
fn compare_pair(points: &mut PointSet, edges: &EdgeTable, facet: &Facet, pair: [u32; 2], cuts: &mut Cuts) {
    let ends = pair.map(|edge| edges.list[edge as usize].ends);
    let mut touches = false;
    for (own, other) in [(0, 1), (1, 0)] {
        for point in ends[other] {
            if ends[own].contains(&point) {
                touches = true;
            } else if points.on_segment(ends[own], point).is_some() {
                cuts.push([pair[own], point]);
                touches = true;
            }
        }
    }
    if touches {
        return;
    }
    // The result must not depend on the order of the edges.
    let [first, second] = if ends[0] < ends[1] { ends } else { [ends[1], ends[0]] };
    let flat = |point: u32| facet.flat(points.at[point as usize]);
    let [a, b, c, d] = [flat(first[0]), flat(first[1]), flat(second[0]), flat(second[1])];
    let crosses = orient(a, b, c) * orient(a, b, d) < 0 && orient(c, d, a) * orient(c, d, b) < 0;
    if !crosses {
        return;
    }
    let share = (d - c).perp_dot(c - a) / (d - c).perp_dot(b - a);
    let [from, to] = first.map(|end| points.at[end as usize]);
    let point = points.number(from + (to - from) * share.clamp(0.0, 1.0));
    for own in 0..2 {
        if !ends[own].contains(&point) {
            cuts.push([pair[own], point]);
        }
    }
}
