//! The search for the pair of slabs with the sides of the largest rectangle.

use std::cmp::Ordering;
use std::collections::BinaryHeap;

use glam::DVec2;

use super::Found;
use super::corner::{CornerLimits, Limit};
use super::slabs::{PolygonSlabs, SlabEdge};
use crate::each::Each;
use crate::tol::TIE_EPSILON;
use crate::work;

/// Pairs of slabs: all left ones with all right ones. No rectangle with sides in them is larger than `most`.
#[derive(Clone, Copy, Debug, PartialEq)]
struct SlabPairs {
    most: f64,
    left: [usize; 2],
    right: [usize; 2],
}

impl Eq for SlabPairs {}

impl Ord for SlabPairs {
    fn cmp(&self, other: &Self) -> Ordering {
        self.most.total_cmp(&other.most).then_with(|| (other.left, other.right).cmp(&(self.left, self.right)))
    }
}

impl PartialOrd for SlabPairs {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

/// The largest rectangle, if it is not smaller than `least`; of several, the one nearest to `centre`. Every visit of an edge is
/// taken from the budget; the search ends when it is spent.
pub(super) fn search(slabs: &PolygonSlabs, centre: DVec2, least: f64, budget: &mut usize) -> Option<Found> {
    let last = slabs.count().checked_sub(1)?;
    let mut queue = BinaryHeap::new();
    let mut best: Option<Found> = None;
    let mut least = least * (1.0 - TIE_EPSILON);
    queue.push(SlabPairs { most: f64::INFINITY, left: [0, last], right: [0, last] });
    while let Some(pairs) = queue.pop() {
        if pairs.most < least {
            break;
        }
        let SlabPairs { left, right, .. } = pairs;
        if left[0] == left[1] && right[0] == right[1] {
            spend(budget, 8 * slabs.edge_count());
            for found in within(slabs, left[0], right[0], least, centre) {
                let off = |found: &Found| found.middle().distance(centre);
                let is_better = best.is_none_or(|best| {
                    let is_tied = (found.area - best.area).abs() <= TIE_EPSILON * best.area;
                    if is_tied { off(&found) < off(&best) - TIE_EPSILON } else { best.area < found.area }
                });
                if is_better && least <= found.area {
                    least = least.max(found.area * (1.0 - TIE_EPSILON));
                    best = Some(found);
                }
            }
        } else {
            for [left, right] in halves(slabs, left, right) {
                let most = bound(slabs, left, right, least, budget);
                if least <= most {
                    queue.push(SlabPairs { most, left, right });
                }
            }
        }
        if *budget == 0 {
            break;
        }
    }
    // The sets of a large polygon can spend the budget before a single pair is reached.
    if best.is_none() && least == 0.0 { descend(slabs, centre) } else { best }
}

/// Takes visits of edges from the budget: all of it if the work is to end.
pub(super) fn spend(budget: &mut usize, visits: usize) {
    *budget = if work::spend(visits) { budget.saturating_sub(visits) } else { 0 };
}

/// A large rectangle, which need not be the largest one: the half with the larger bound is taken each time.
fn descend(slabs: &PolygonSlabs, centre: DVec2) -> Option<Found> {
    let last = slabs.count().checked_sub(1)?;
    let [mut left, mut right] = [[0, last]; 2];
    let mut unlimited = usize::MAX;
    while left[0] < left[1] || right[0] < right[1] {
        let parts = halves(slabs, left, right).map(|[left, right]| {
            let most = bound(slabs, left, right, 0.0, &mut unlimited);
            SlabPairs { most, left, right }
        });
        SlabPairs { left, right, .. } = parts.max()?;
    }
    let all = within(slabs, left[0], right[0], 0.0, centre).into_iter();
    all.max_by(|a, b| a.area.total_cmp(&b.area)).filter(|found| 0.0 < found.area)
}

/// The halves of a set of pairs. The wider side is divided.
fn halves(slabs: &PolygonSlabs, left: [usize; 2], right: [usize; 2]) -> impl Iterator<Item = [[usize; 2]; 2]> {
    let width = |[first, last]: [usize; 2]| slabs.lines[last + 1] - slabs.lines[first];
    let divides_left = right[0] == right[1] || (left[0] < left[1] && width(right) <= width(left));
    let [first, last] = if divides_left { left } else { right };
    let middle = first + (last - first) / 2;
    let parts = [[first, middle], [middle + 1, last]];
    let sets = parts.each(|part| if divides_left { [part, right] } else { [left, part] });
    sets.into_iter().filter(|[left, right]| left[0] <= right[1])
}

/// The area that no rectangle with its sides in these slabs exceeds, or an area below `least`.
fn bound(slabs: &PolygonSlabs, left: [usize; 2], right: [usize; 2], least: f64, budget: &mut usize) -> f64 {
    let width = slabs.lines[right[1] + 1] - slabs.lines[left[0]];
    let mut height = slabs.highest(left[0], left[1]).min(slabs.highest(right[0], right[1]));
    if left[1] + 1 < right[0] && least <= width * height {
        spend(budget, slabs.edge_count());
        let gaps = slabs.gaps(slabs.lines[left[1] + 1], slabs.lines[right[0]]);
        height = height.min(gaps.iter().map(|gap| gap[1] - gap[0]).fold(0.0, f64::max));
    }
    width * height
}

/// The largest rectangles with the left side in one slab and the right side in another, for each way between them.
fn within(slabs: &PolygonSlabs, left: usize, right: usize, least: f64, centre: DVec2) -> Vec<Found> {
    let [from, to] = [slabs.span(left), slabs.span(right)];
    let most_width = to[1] - from[0];
    let by_left = |edge: &SlabEdge| Limit { constant: edge.at(from[0]), by_left: edge.slope(), by_right: 0.0 };
    let by_right = |edge: &SlabEdge| Limit { constant: edge.at(to[0]), by_left: 0.0, by_right: edge.slope() };
    let starts = slabs.trapezoids(left);
    if left == right {
        let limits = starts.iter().map(|[bottom, top]| CornerLimits {
            tops: vec![by_left(top), by_right(top)],
            bottoms: vec![by_left(bottom), by_right(bottom)],
            lines: [from[0], to[0]],
            widths: [from[1] - from[0], to[1] - to[0]],
        });
        return limits.filter_map(|limits| limits.largest(centre)).collect();
    }
    let gaps = if left + 1 == right { vec![[f64::NEG_INFINITY, f64::INFINITY]] } else { slabs.gaps(from[1], to[0]) };
    let ends = slabs.trapezoids(right);
    let mut all = Vec::new();
    for [low, high] in gaps {
        if !work::spend(starts.len() * ends.len()) {
            break;
        }
        for [start_bottom, start_top] in &starts {
            for [end_bottom, end_top] in &ends {
                let top = high.min(start_top.at(from[1])).min(end_top.at(to[0]));
                let bottom = low.max(start_bottom.at(from[1])).max(end_bottom.at(to[0]));
                if top <= bottom || (top - bottom) * most_width < least {
                    continue;
                }
                let limits = CornerLimits {
                    tops: vec![Limit::constant(top), by_left(start_top), by_right(end_top)],
                    bottoms: vec![Limit::constant(bottom), by_left(start_bottom), by_right(end_bottom)],
                    lines: [from[0], to[0]],
                    widths: [from[1] - from[0], to[1] - to[0]],
                };
                all.extend(limits.largest(centre));
            }
        }
    }
    all
}
