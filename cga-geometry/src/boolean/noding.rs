//! Divides the edges of an arrangement until the edges of each facet meet in points only.
//!
//! An edge that passes a point within epsilon is led through it, and edges that cross are led through a new point. So an edge
//! moves by up to epsilon, and may then pass other points: the facets of divided edges are compared again.

use super::budget::Budget;
use super::edge_table::EdgeTable;
use super::facet::Facet;
use super::operation::BooleanError;
use super::plane_group::PlaneGroups;
use super::point_set::PointSet;
use super::progress::{goes_on, sort};
use crate::bounds_tree::{BoundsTree, overlap};
use crate::each::Each;
use crate::exact::orient;
use crate::mesh::Bounds;
use crate::small_sort::SmallSort;

/// The limit on rounds. Two suffice for most arrangements.
const MOST_ROUNDS: usize = 32;

/// The number of edges of a facet that are compared all with all.
const MOST_WITHOUT_TREE: usize = 24;

/// The cost of comparing two edges whose boxes overlap.
const PAIR_COST: usize = 8;

/// The points at which edges are to be divided: pairs of an edge and a point.
type Cuts = Vec<[u32; 2]>;

/// Divides all edges where they meet.
pub(super) fn divide_edges(
    points: &mut PointSet,
    edges: &mut EdgeTable,
    facets: &[Facet<'_>],
    groups: &PlaneGroups,
    budget: &mut Budget,
) -> Result<(), BooleanError> {
    let has_lines = |facet: &u32| !groups.is_member(*facet) && has_company(edges, facets, *facet);
    let mut open: Vec<u32> = (0..facets.len() as u32).filter(has_lines).collect();
    let mut is_open = vec![false; facets.len()];
    for _ in 0..MOST_ROUNDS {
        let mut cuts = Cuts::new();
        open.iter().for_each(|facet| is_open[*facet as usize] = true);
        for &facet in &open {
            let counts = |pair| is_first(edges, &is_open, facet, pair);
            let lines = edges.lines(facet);
            compare_edges(points, edges, (&facets[facet as usize], lines), counts, &mut cuts, budget)?;
        }
        open.iter().for_each(|facet| is_open[*facet as usize] = false);
        if cuts.is_empty() {
            return Ok(());
        }
        sort(&mut cuts)?;
        cuts.dedup();
        open.clear();
        let mut here = Vec::new();
        for group in cuts.chunk_by(|a, b| a[0] == b[0]) {
            here.clear();
            here.extend(group.iter().map(|[_, point]| *point));
            goes_on(2 * here.len() * edges.owners(group[0][0]).len())?;
            edges.divide(points, group[0][0], &mut here, &mut open);
            budget.check(edges, points)?;
        }
        sort(&mut open)?;
        open.dedup();
        for &facet in &open {
            goes_on(edges.lines(facet).len())?;
            edges.drop_foreign(facet);
        }
        open.retain(|facet| !groups.is_member(*facet));
    }
    Err(BooleanError::Tangled)
}

/// Returns true if the edges of a facet may meet elsewhere than at corners.
fn has_company(edges: &EdgeTable, facets: &[Facet<'_>], number: u32) -> bool {
    let is_foreign = |line: &u32| edges.owner(*line, number).is_none_or(|owner| owner.count == 0);
    !facets[number as usize].is_convex || edges.lines(number).iter().any(is_foreign)
}

/// Returns true if a facet is the first one, of those that are compared, that has both edges. Facets in one plane share edges,
/// which meet at the same points in all of them.
fn is_first(edges: &EdgeTable, is_open: &[bool], facet: u32, pair: [u32; 2]) -> bool {
    let [mut a, mut b] = pair.each(|edge| edges.owners(edge).iter().map(|owner| owner.facet).peekable());
    while let (Some(&first), Some(&second)) = (a.peek(), b.peek()) {
        if facet <= first.max(second) {
            return true;
        }
        if first == second && is_open[first as usize] {
            return false;
        }
        if first <= second {
            a.next();
        }
        if second <= first {
            b.next();
        }
    }
    true
}

/// Finds where the edges in the plane of a facet meet.
fn compare_edges(
    points: &mut PointSet,
    edges: &EdgeTable,
    (facet, lines): (&Facet<'_>, &[u32]),
    counts: impl Fn([u32; 2]) -> bool,
    cuts: &mut Cuts,
    budget: &mut Budget,
) -> Result<(), BooleanError> {
    goes_on(lines.len())?;
    let reach = points.epsilon;
    let extent = |line: u32| {
        let [a, b] = edges.list[line as usize].ends.each(|end| facet.flat(points.at[end as usize]));
        (Bounds { low: (a.min(b) - reach).extend(0.0), high: (a.max(b) + reach).extend(0.0) }, line)
    };
    let mut boxes: Vec<(Bounds, u32)> = lines.iter().map(|line| extent(*line)).collect();
    boxes.small_sort_unstable_by(|a, b| a.0.low.x.total_cmp(&b.0.low.x).then(a.1.cmp(&b.1)));
    let lines: Vec<u32> = boxes.iter().map(|entry| entry.1).collect();
    let boxes: Vec<Bounds> = boxes.into_iter().map(|entry| entry.0).collect();
    // A tree costs more than it saves for few edges.
    let tree = (MOST_WITHOUT_TREE < boxes.len()).then(|| BoundsTree::of(&boxes));
    let mut near: Vec<u32> = Vec::new();
    for (number, bounds) in (0..).zip(&boxes) {
        near.clear();
        let mut visited = 0;
        let mut look = |other: u32| {
            visited += 1;
            if other < number && overlap(&boxes[other as usize], bounds) {
                near.push(other);
            }
            true
        };
        match &tree {
            Some(tree) => _ = tree.visit(|around| overlap(around, bounds), look),
            None => (0..number).for_each(|other| _ = look(other)),
        }
        budget.spend(visited + near.len())?;
        if budget.points < points.at.len() || 4 * budget.edges < cuts.len() {
            return Err(BooleanError::TooMany);
        }
        near.small_sort();
        for &other in &near {
            let pair = [lines[number as usize], lines[other as usize]];
            if counts(pair) {
                budget.spend(PAIR_COST)?;
                compare_pair(points, edges, facet, pair, cuts);
            }
        }
    }
    Ok(())
}

/// Finds where two edges divide each other.
fn compare_pair(points: &mut PointSet, edges: &EdgeTable, facet: &Facet<'_>, pair: [u32; 2], cuts: &mut Cuts) {
    let ends = pair.each(|edge| edges.list[edge as usize].ends);
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
    let [from, to] = first.each(|end| points.at[end as usize]);
    let point = points.number(from + (to - from) * share.clamp(0.0, 1.0));
    for own in 0..2 {
        if !ends[own].contains(&point) {
            cuts.push([pair[own], point]);
        }
    }
}
