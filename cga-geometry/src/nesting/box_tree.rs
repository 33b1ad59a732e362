//! Finds the smallest loop around a point, with a tree of bounding boxes.
//!
//! A k-d tree: boxes are divided by the one of their four bounds that varies most, so the tree separates large boxes
//! from small ones and distant boxes from each other. A query visits the loops whose box contains the point by
//! increasing area, and ends at the first one that is accepted.

use crate::each::Each;
use std::cmp::Reverse;
use std::collections::BinaryHeap;

use super::extent::Extent;
use super::measured_loop::Loop;
use super::winding::QueryBudget;
use crate::small_sort::SmallSort;

/// A tree of some loops.
#[derive(Default)]
pub(crate) struct BoxTree {
    /// A node is followed by all nodes of its first half, then by all nodes of its second half.
    nodes: Vec<BoxNode>,
    /// The loops by increasing area.
    by_rank: Vec<u32>,
    /// The nodes that a query still has to visit.
    open: BinaryHeap<Reverse<(u32, u32)>>,
}

#[derive(Clone, Copy)]
struct BoxNode {
    extent: Extent,
    /// The lowest rank in the node.
    rank: u32,
    /// The start of its second half; 0 for a single loop.
    second: u32,
}

impl BoxTree {
    /// Builds the tree of the loops that `counts` accepts.
    pub(crate) fn fill(&mut self, loops: &[Loop], counts: impl Fn(usize) -> bool) {
        self.nodes.clear();
        self.by_rank.clear();
        self.by_rank.extend((0..loops.len()).filter(|&number| counts(number)).map(|number| number as u32));
        let area = |number: u32| loops[number as usize].area;
        self.by_rank.small_sort_unstable_by(|&a, &b| area(a).total_cmp(&area(b)).then(a.cmp(&b)));
        let leaf = |(rank, &number): (usize, &u32)| BoxNode {
            extent: loops[number as usize].extent,
            rank: rank as u32,
            second: 0,
        };
        let mut leaves: Vec<BoxNode> = self.by_rank.iter().enumerate().map(leaf).collect();
        self.add(&mut leaves);
    }

    fn add(&mut self, leaves: &mut [BoxNode]) {
        if let [leaf] = leaves {
            self.nodes.push(*leaf);
            return;
        }
        let Some(rank) = leaves.iter().map(|leaf| leaf.rank).min() else { return };
        let lows = Extent::of(leaves.iter().map(|leaf| leaf.extent.low));
        let highs = Extent::of(leaves.iter().map(|leaf| leaf.extent.high));
        let number = self.nodes.len();
        self.nodes.push(BoxNode { extent: Extent { low: lows.low, high: highs.high }, rank, second: 0 });
        let [low, high] = [lows, highs].each(|extent| extent.high * 0.5 - extent.low * 0.5);
        let by = |key: fn(&Extent) -> f64| {
            move |a: &BoxNode, b: &BoxNode| key(&a.extent).total_cmp(&key(&b.extent)).then(a.rank.cmp(&b.rank))
        };
        let middle = leaves.len() / 2;
        let widest = low.max(high).max_element();
        let bound: fn(&Extent) -> f64 = if low.x == widest {
            |extent| extent.low.x
        } else if low.y == widest {
            |extent| extent.low.y
        } else if high.x == widest {
            |extent| extent.high.x
        } else {
            |extent| extent.high.y
        };
        leaves.small_select_by(middle, by(bound));
        let (first, second) = leaves.split_at_mut(middle);
        self.add(first);
        self.nodes[number].second = self.nodes.len() as u32;
        self.add(second);
    }

    /// Finds the smallest loop that is accepted. `None` if the budget is spent before. `may_be_in` tests the box of one
    /// or several loops: false if none of them can be accepted.
    pub(crate) fn smallest(
        &mut self,
        budget: &mut QueryBudget,
        may_be_in: impl Fn(&Extent) -> bool,
        mut accept: impl FnMut(usize, &mut QueryBudget) -> bool,
    ) -> Option<usize> {
        self.open.clear();
        let may_be_in = |node: u32| may_be_in(&self.nodes[node as usize].extent);
        let mut next = (!self.nodes.is_empty() && may_be_in(0)).then_some(0);
        while let Some(node) = next.take().or_else(|| self.open.pop().map(|Reverse((_, node))| node)) {
            budget.spend(1);
            let BoxNode { rank, second, .. } = self.nodes[node as usize];
            let is_found = second == 0 && accept(self.by_rank[rank as usize] as usize, budget);
            if budget.is_spent() {
                return None;
            }
            if is_found {
                return Some(self.by_rank[rank as usize] as usize);
            }
            if second == 0 {
                continue;
            }
            for child in [node + 1, second].into_iter().filter(|&child| may_be_in(child)) {
                let child_rank = self.nodes[child as usize].rank;
                // No other node has a lower rank than the current one.
                if child_rank == rank {
                    next = Some(child);
                } else {
                    self.open.push(Reverse((child_rank, child)));
                }
            }
        }
        None
    }
}

#[cfg(test)]
mod tests {
    use glam::DVec2;

    use super::*;

    #[test]
    fn queries_look_at_few_of_many_boxes() {
        // Boxes of various sizes, and of one size, each twice: the query finds the smaller one.
        for mixed in [false, true] {
            for count in [1 << 8, 1 << 11, 1 << 14] {
                let side = f64::from(count).sqrt();
                let mut seed = 7u32;
                let mut noise = || {
                    seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
                    f64::from(seed >> 8) / f64::from(1 << 24)
                };
                let mut loops = Vec::new();
                for _ in 0..count {
                    let size = if mixed { side * 0.5 / (1.0 + noise() * side) } else { 1.0 };
                    let low = DVec2::new(noise(), noise()) * side;
                    for shrink in [0.0, 0.1] {
                        let [low, high] = [low + shrink * size, low + size - shrink * size];
                        let area = 2.0 * (high - low).element_product();
                        loops.push(Loop { range: 0..4, area, extent: Extent { low, high }, outline: None });
                    }
                }
                let mut tree = BoxTree::default();
                tree.fill(&loops, |_| true);
                let mut budget = QueryBudget(usize::MAX);
                for (number, ring) in loops.iter().enumerate() {
                    let at = ring.extent.low;
                    let found = tree.smallest(&mut budget, |extent| extent.holds(at), |_, _| true);
                    assert!(found.is_some_and(|found| loops[found].area <= loops[number].area));
                }
                let each = (usize::MAX - budget.0) / loops.len();
                let levels = loops.len().ilog2() as usize;
                assert!(each <= 6 * levels, "{each} of {}", loops.len());
            }
        }
    }
}
