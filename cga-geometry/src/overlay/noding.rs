//! Divides edges where they cross and where they pass a point closely, until all edges meet in points only.
//!
//! A crossing is rounded to a place of the grid, and both edges lead through it. So an edge moves by less than a step, and
//! may then cross or pass others: the new edges are compared again.

use crate::each::Each;
use crate::long_sort::long_sort_by;
use crate::small_sort::SmallSort;
use crate::work;
use std::cmp::Ordering;

use super::OverlayError;
use super::grid::{GridPoint, is_near, side};
use super::places::Places;

/// An edge between two points, the first before the second in lexicographic order of places, and the number of times that
/// it runs in that direction, less those back.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct NodedEdge {
    pub(super) ends: [u32; 2],
    pub(super) count: i32,
    /// True for edges that were not compared yet.
    is_new: bool,
}

/// A point in which an edge is divided.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct Cut {
    edge: u32,
    point: u32,
}

/// Points at most this far from an edge are on it, in steps. The limit is below the distance of the diagonal of a step from
/// its other corners, so that every division makes edges shorter.
const NEAR: f64 = 0.7;

/// The same in the first round: a given point on an edge, and the ends of the edge, are rounded by up to 0.71 steps each.
const NEAR_AT_FIRST: f64 = 2.0;

/// The limit on comparisons of edges, about two seconds.
const MOST_PAIRS: usize = 400_000_000;

/// The units of work of an edge in a round, and of a division of it: it is sorted, and its edge is compared again.
const EDGE: usize = 16;
const CUT: usize = 64;

/// The units of work of two edges whose boxes meet.
const MEETING: usize = 16;

/// The limit on rounds. One or two suffice for most polygons.
const MOST_ROUNDS: usize = 24;

/// Divides edges. New points are added to `places`.
pub(super) fn divide(places: &mut Places, edges: Vec<[u32; 2]>) -> Result<Vec<NodedEdge>, OverlayError> {
    let mut all: Vec<NodedEdge> = edges.into_iter().filter_map(|[a, b]| directed(places, a, b, 1)).collect();
    merge(&mut all)?;
    let mut pairs = MOST_PAIRS;
    for round in 0..MOST_ROUNDS {
        let near = if round == 0 { NEAR_AT_FIRST } else { NEAR };
        let mut cuts = Vec::new();
        compare(places, &all, near, &mut cuts, &mut pairs)?;
        if cuts.is_empty() {
            return Ok(all);
        }
        if !long_sort_by(&mut cuts, Ord::cmp) {
            return Err(OverlayError::TooMany);
        }
        all = parts(places, &all, cuts)?;
        merge(&mut all)?;
    }
    Err(OverlayError::Tangled)
}

/// Counts work; an error if it is to end.
fn goes_on(units: usize) -> Result<(), OverlayError> {
    if work::spend(units) { Ok(()) } else { Err(OverlayError::TooMany) }
}

/// The edges, divided at their cuts, which are sorted.
fn parts(places: &Places, all: &[NodedEdge], cuts: Vec<Cut>) -> Result<Vec<NodedEdge>, OverlayError> {
    let mut made = Vec::with_capacity(all.len() + cuts.len());
    let (mut rest, mut own) = (&cuts[..], Vec::new());
    for (number, edge) in (0..).zip(all) {
        let (here, later) = rest.split_at(rest.iter().take_while(|cut| cut.edge == number).count());
        rest = later;
        goes_on(1 + CUT * here.len())?;
        if here.is_empty() {
            made.push(NodedEdge { is_new: false, ..*edge });
            continue;
        }
        own.clear();
        own.extend(here.iter().map(|cut| cut.point));
        let [a, b] = edge.ends.each(|end| places.at(end));
        let along = |point: u32| {
            let p = places.at(point);
            i128::from(b.x - a.x) * i128::from(p.x - a.x) + i128::from(b.y - a.y) * i128::from(p.y - a.y)
        };
        own.small_sort_by_key(|point| (along(*point), *point));
        own.dedup_by_key(|point| along(*point));
        let mut from = edge.ends[0];
        for to in own.iter().copied().chain([edge.ends[1]]) {
            made.extend(directed(places, from, to, edge.count));
            from = to;
        }
    }
    Ok(made)
}

/// A new edge in lexicographic order; `None` if it has no length.
fn directed(places: &Places, a: u32, b: u32, count: i32) -> Option<NodedEdge> {
    match places.at(a).cmp(&places.at(b)) {
        Ordering::Less => Some(NodedEdge { ends: [a, b], count, is_new: true }),
        Ordering::Greater => Some(NodedEdge { ends: [b, a], count: -count, is_new: true }),
        Ordering::Equal => None,
    }
}

/// Unites edges between the same points. Those that cancel are dropped. An edge at a place that was compared is not new.
fn merge(edges: &mut Vec<NodedEdge>) -> Result<(), OverlayError> {
    if !long_sort_by(edges, Ord::cmp) {
        return Err(OverlayError::TooMany);
    }
    edges.dedup_by(|next, kept| {
        let is_same = next.ends == kept.ends;
        if is_same {
            kept.count += next.count;
            kept.is_new &= next.is_new;
        }
        is_same
    });
    edges.retain(|edge| edge.count != 0);
    Ok(())
}

/// Finds the points in which edges must be divided, by a sweep over their boxes. Pairs of old edges are known.
fn compare(
    places: &mut Places,
    edges: &[NodedEdge],
    near: f64,
    cuts: &mut Vec<Cut>,
    pairs: &mut usize,
) -> Result<(), OverlayError> {
    let mut boxes: Vec<[i64; 4]> = Vec::with_capacity(edges.len());
    let mut order: Vec<(i64, u32)> = Vec::with_capacity(edges.len());
    for (edge, number) in edges.iter().zip(0..) {
        goes_on(EDGE)?;
        let [a, b] = edge.ends.each(|end| places.at(end));
        boxes.push([a.x, b.x, a.y.min(b.y), a.y.max(b.y)]);
        order.push((a.x, number));
    }
    if !long_sort_by(&mut order, Ord::cmp) {
        return Err(OverlayError::TooMany);
    }
    let mut active: Vec<u32> = Vec::new();
    for (_, edge) in order {
        let own = boxes[edge as usize];
        *pairs = pairs.checked_sub(active.len()).ok_or(OverlayError::TooMany)?;
        let (mut kept, mut met) = (0, 0);
        for i in 0..active.len() {
            let other = active[i];
            let its = boxes[other as usize];
            // A point within two steps may be on an edge beside its box.
            if its[1] + 2 < own[0] {
                continue;
            }
            active[kept] = other;
            kept += 1;
            let apart = its[3] + 2 < own[2] || own[3] + 2 < its[2];
            if !apart && (edges[edge as usize].is_new || edges[other as usize].is_new) {
                met += 1;
                meet(places, edges, [edge as usize, other as usize], near, cuts);
            }
        }
        goes_on(EDGE + active.len() + MEETING * met)?;
        active.truncate(kept);
        active.push(edge);
    }
    Ok(())
}

/// Records where two edges divide each other.
fn meet(places: &mut Places, edges: &[NodedEdge], pair: [usize; 2], near: f64, cuts: &mut Vec<Cut>) {
    let ends = pair.each(|edge| edges[edge].ends);
    let spots = ends.each(|ends| ends.each(|end| places.at(end)));
    let mut touches = false;
    for (own, other) in [(0, 1), (1, 0)] {
        for k in 0..2 {
            let point = ends[other][k];
            if ends[own].contains(&point) {
                touches = true;
            } else if is_near(spots[own][0], spots[own][1], spots[other][k], near) {
                cuts.push(Cut { edge: pair[own] as u32, point });
                touches = true;
            }
        }
    }
    let [[a, b], [c, d]] = spots;
    if touches {
        return;
    }
    let [sides, others] = [[side(a, b, c), side(a, b, d)], [side(c, d, a), side(c, d, b)]];
    if (0 < sides[0]) == (0 < sides[1]) || (0 < others[0]) == (0 < others[1]) {
        return;
    }
    let whole = sides[0] - sides[1];
    let share = |from: i64, to: i64| from + rounded(i128::from(to - from) * sides[0], whole) as i64;
    let place = GridPoint { x: share(c.x, d.x), y: share(c.y, d.y) };
    let number = places.number(place);
    for edge in pair {
        if !edges[edge].ends.contains(&number) {
            cuts.push(Cut { edge: edge as u32, point: number });
        }
    }
}

/// A quotient, rounded to the nearest whole number.
fn rounded(number: i128, by: i128) -> i128 {
    let (number, by) = if by < 0 { (-number, -by) } else { (number, by) };
    (2 * number + by).div_euclid(2 * by)
}
