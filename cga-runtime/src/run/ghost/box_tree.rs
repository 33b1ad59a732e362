//! A tree of boxes along the axes of the world, for questions about what is near.

use std::ops::Range;

use glam::DVec3;

use crate::geometry::mesh::Bounds;

/// The largest number of boxes in a node without children.
const LEAF: usize = 8;

/// The rounding errors of a measured distance, relative to the largest coordinate.
const ROUNDING: f64 = 64.0 * f64::EPSILON;

/// Boxes, divided at the median of their centres.
#[derive(Debug, Default)]
pub(crate) struct BoxTree {
    boxes: Vec<Bounds>,
    /// The numbers of boxes, in the order of the nodes.
    items: Vec<u32>,
    /// Each node before its children. The first child follows its parent.
    nodes: Vec<Node>,
}

#[derive(Debug)]
struct Node {
    bounds: Bounds,
    items: Range<usize>,
    /// The second child; `None` for a node without children.
    second: Option<usize>,
}

/// The distance between two boxes; infinite for an empty box.
pub(crate) fn gap(a: &Bounds, b: &Bounds) -> f64 {
    (b.low - a.high).max(a.low - b.high).max(DVec3::ZERO).length()
}

/// A length that no measured distance between things in two boxes is below, in spite of rounding.
fn least_measure(a: &Bounds, b: &Bounds) -> f64 {
    let corners = [a.low, a.high, b.low, b.high].map(|corner| corner.abs().max_element());
    let far = corners.into_iter().fold(0.0, f64::max);
    (gap(a, b) - ROUNDING * far).max(0.0)
}

impl BoxTree {
    /// A tree of boxes, in time n log² n.
    pub(crate) fn new(boxes: Vec<Bounds>) -> Self {
        let items = (0..boxes.len() as u32).collect();
        let mut tree = BoxTree { boxes, items, nodes: Vec::new() };
        if !tree.items.is_empty() {
            tree.divide(0..tree.items.len());
        }
        tree
    }

    fn divide(&mut self, range: Range<usize>) {
        let (boxes, items) = (&self.boxes, &mut self.items[range.clone()]);
        let bounds = items.iter().fold(Bounds::EMPTY, |sum, item| sum.union(boxes[*item as usize]));
        let node = self.nodes.len();
        self.nodes.push(Node { bounds, items: range.clone(), second: None });
        if range.len() <= LEAF {
            return;
        }
        let size = bounds.size();
        let axis = (0..3).fold(0, |longest, axis| if size[longest] < size[axis] { axis } else { longest });
        let centre = |item: &u32| boxes[*item as usize].low[axis] * 0.5 + boxes[*item as usize].high[axis] * 0.5;
        items.sort_unstable_by(|a, b| centre(a).total_cmp(&centre(b)).then(a.cmp(b)));
        let middle = range.start + range.len() / 2;
        self.divide(range.start..middle);
        self.nodes[node].second = Some(self.nodes.len());
        self.divide(middle..range.end);
    }

    /// The numbers of the boxes that are at most so far from a box, in ascending order.
    pub(crate) fn within(&self, query: &Bounds, distance: f64) -> Vec<u32> {
        let mut found = Vec::new();
        let mut open: Vec<usize> = if self.nodes.is_empty() { Vec::new() } else { vec![0] };
        let is_near = |bounds: &Bounds| gap(bounds, query) <= distance;
        while let Some(at) = open.pop() {
            let node = &self.nodes[at];
            if !is_near(&node.bounds) {
                continue;
            }
            match node.second {
                Some(second) => open.extend([second, at + 1]),
                None => {
                    let items = self.items[node.items.clone()].iter().copied();
                    found.extend(items.filter(|item| is_near(&self.boxes[*item as usize])));
                }
            }
        }
        found.sort_unstable();
        found
    }

    /// The least value of `measure` over all boxes, or `least` if that is less: the distance between `query` and what is in a box, or more. It is less than the distance
    /// of the box at most by rounding, and the result is the same for every order of the boxes.
    pub(crate) fn least(&self, query: &Bounds, mut least: f64, measure: &mut dyn FnMut(u32) -> f64) -> f64 {
        let mut open: Vec<usize> = if self.nodes.is_empty() { Vec::new() } else { vec![0] };
        while let Some(at) = open.pop() {
            let node = &self.nodes[at];
            if least <= least_measure(&node.bounds, query) {
                continue;
            }
            match node.second {
                Some(second) => {
                    let far = |at: usize| gap(&self.nodes[at].bounds, query);
                    // The nearer one is the next.
                    open.extend(if far(second) < far(at + 1) { [at + 1, second] } else { [second, at + 1] });
                }
                None => {
                    for item in &self.items[node.items.clone()] {
                        if least_measure(&self.boxes[*item as usize], query) < least {
                            least = least.min(measure(*item));
                        }
                    }
                }
            }
        }
        least
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Boxes with corners on a grid, the same in each run.
    fn boxes(count: usize) -> Vec<Bounds> {
        let mut state = 1_u64;
        let mut draw = move || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 59) as f64
        };
        let mut corner = move || DVec3::new(draw(), draw(), draw());
        (0..count)
            .map(|_| {
                let (low, size) = (corner() * 4.0, corner() / 8.0);
                Bounds { low, high: low + size }
            })
            .collect()
    }

    #[test]
    fn near_boxes_are_those_of_a_search_of_all() {
        let all = boxes(500);
        let tree = BoxTree::new(all.clone());
        for query in all.iter().step_by(7) {
            for distance in [0.0, 1.0, 10.0, f64::INFINITY] {
                let expected = (0..).zip(&all).filter(|(_, own)| gap(own, query) <= distance);
                assert_eq!(tree.within(query, distance), expected.map(|(at, _)| at).collect::<Vec<u32>>());
            }
            let others =
                |at: u32| if all[at as usize] == *query { f64::INFINITY } else { gap(&all[at as usize], query) };
            let expected = (0..all.len() as u32).map(others).fold(f64::INFINITY, f64::min);
            let mut measured = 0;
            let found = tree.least(query, f64::INFINITY, &mut |at| {
                measured += 1;
                others(at)
            });
            assert_eq!(found, expected);
            assert!(measured < 120, "{measured}");
            // With a bound below it, nothing is measured.
            let mut none = |_| unreachable!("nothing is nearer");
            assert_eq!(tree.least(query, 0.0, &mut none), 0.0);
        }
        assert!(BoxTree::new(Vec::new()).within(&all[0], 1.0).is_empty());
    }

    #[test]
    fn the_least_value_does_not_depend_on_the_order_of_equally_near_boxes() {
        // Measured distances of equally near boxes differ by rounding.
        let box_at = |x: f64| Bounds { low: DVec3::X * x, high: DVec3::X * x + 1.0 };
        let query = box_at(0.0);
        for places in [[4.0, -4.0], [-4.0, 4.0]] {
            let tree = BoxTree::new(places.map(box_at).to_vec());
            let measure = |at: u32| if places[at as usize] < 0.0 { 3.0 - 2.0 * f64::EPSILON } else { 3.0 };
            assert_eq!(tree.least(&query, f64::INFINITY, &mut { measure }), 3.0 - 2.0 * f64::EPSILON);
        }
    }
}
