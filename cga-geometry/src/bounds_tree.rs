//! A tree of bounding boxes, for boolean operations, relations of solids and questions about what is near.

use glam::DVec3;

use crate::bounds::Bounds;
use crate::each::Each;
use crate::small_sort::SmallSort;
use crate::work;

/// The number of boxes in a leaf of the tree.
const LEAF: usize = 6;

/// The rounding errors of a measured distance, relative to the largest coordinate.
const ROUNDING: f64 = 64.0 * f64::EPSILON;

/// The most nodes that wait for a visit: one for each level of the tree. Each level halves a number of 32 bits.
const MOST_OPEN: usize = 40;

/// A binary tree of numbered boxes. A node is followed by all nodes of its first half, then by all nodes of its second half.
#[derive(Debug, Default)]
pub struct BoundsTree {
    nodes: Vec<BoundsNode>,
    /// The numbers of boxes, leaf by leaf.
    order: Vec<u32>,
}

#[derive(Debug)]
struct BoundsNode {
    bounds: Bounds,
    /// The node of the second half; 0 for a leaf.
    second: u32,
    /// The range in `order`.
    start: u32,
    end: u32,
}

impl BoundsTree {
    /// The tree of boxes, which are numbered in order. Takes time n log n and keeps the boxes of its nodes alone.
    pub fn of(boxes: &[Bounds]) -> Self {
        let mut tree = BoundsTree { nodes: Vec::new(), order: (0..boxes.len() as u32).collect() };
        if !boxes.is_empty() {
            tree.add(boxes, 0, boxes.len());
        }
        tree
    }

    fn add(&mut self, boxes: &[Bounds], start: usize, end: usize) {
        let number = self.nodes.len();
        let here = self.order[start..end].iter().map(|number| boxes[*number as usize]);
        let bounds = here.fold(Bounds::EMPTY, Bounds::union);
        self.nodes.push(BoundsNode { bounds, second: 0, start: start as u32, end: end as u32 });
        // If the work is to end, the tree is still correct.
        if end - start <= LEAF || !work::spend(end - start) {
            return;
        }
        let size = bounds.size().to_array();
        let axis = (1..3).fold(0, |longest, axis| if size[longest] < size[axis] { axis } else { longest });
        let middle = |number: u32| boxes[number as usize].low[axis] + boxes[number as usize].high[axis];
        let half = (end - start) / 2;
        self.order[start..end].small_select_by(half, |&a, &b| middle(a).total_cmp(&middle(b)).then(a.cmp(&b)));
        self.add(boxes, start, start + half);
        self.nodes[number].second = self.nodes.len() as u32;
        self.add(boxes, start + half, end);
    }

    /// Calls `found` with the numbers of the boxes in the nodes that `enters` accepts, until `found` returns false. Some of these boxes
    /// would not be accepted themselves, and they come in the order of the tree. Returns the number of nodes that were compared.
    #[inline]
    pub fn visit(&self, enters: impl Fn(&Bounds) -> bool, mut found: impl FnMut(u32) -> bool) -> usize {
        let (mut open, mut waiting, mut compared) = ([0u32; MOST_OPEN], 0, 0);
        let mut next = Some(0u32);
        while let Some(number) = next.take() {
            compared += 1;
            if let Some(node) = self.nodes.get(number as usize).filter(|node| enters(&node.bounds)) {
                if node.second != 0 {
                    open[waiting] = node.second;
                    waiting += 1;
                    next = Some(number + 1);
                    continue;
                }
                if !self.order[node.start as usize..node.end as usize].iter().all(|number| found(*number)) {
                    break;
                }
            }
            if waiting != 0 {
                waiting -= 1;
                next = Some(open[waiting]);
            }
        }
        compared
    }

    /// The least value of `measure` over the numbers of all boxes, or `least` if that is less. A value may be less than the distance between
    /// its box and `query` by rounding errors alone. So most boxes are not measured: nearer nodes come first. The result is the same for every order of
    /// the boxes.
    pub fn least(&self, query: &Bounds, mut least: f64, mut measure: impl FnMut(u32) -> f64) -> f64 {
        let (mut open, mut waiting) = ([(0u32, 0.0); MOST_OPEN], 0);
        let distance = |number: u32| least_measure(&self.nodes[number as usize].bounds, query);
        let mut next = (!self.nodes.is_empty()).then(|| (0, distance(0)));
        while let Some((number, nearest)) = next.take() {
            if nearest < least {
                let node = &self.nodes[number as usize];
                if node.second != 0 {
                    let [first, second] = [number + 1, node.second].map(|half| (half, distance(half)));
                    let (near, far) = if second.1 < first.1 { (second, first) } else { (first, second) };
                    open[waiting] = far;
                    waiting += 1;
                    next = Some(near);
                    continue;
                }
                let here = &self.order[node.start as usize..node.end as usize];
                least = here.iter().map(|number| measure(*number)).fold(least, f64::min);
            }
            if waiting != 0 {
                waiting -= 1;
                next = Some(open[waiting]);
            }
        }
        least
    }
}

/// A length that no measured distance between things in two boxes is below, in spite of rounding.
fn least_measure(a: &Bounds, b: &Bounds) -> f64 {
    let corners = [a.low, a.high, b.low, b.high].each(|corner| corner.abs().max_element());
    let far = corners.into_iter().fold(0.0, f64::max);
    (a.distance(b) - ROUNDING * far).max(0.0)
}

/// Returns true if two boxes have a common point. Most boxes are apart along the first axis that is compared.
#[inline]
pub(crate) fn overlap(a: &Bounds, b: &Bounds) -> bool {
    let ([low, high], [other_low, other_high]) = ([a.low, a.high], [b.low, b.high]);
    low.x <= other_high.x
        && other_low.x <= high.x
        && low.z <= other_high.z
        && other_low.z <= high.z
        && low.y <= other_high.y
        && other_low.y <= high.y
}

/// Returns true if a ray meets a box. `inverse` are the reciprocals of the ray's direction, which has no component zero.
pub(crate) fn meets_ray(bounds: &Bounds, from: DVec3, inverse: DVec3) -> bool {
    let [a, b] = [(bounds.low - from) * inverse, (bounds.high - from) * inverse];
    a.min(b).max_element().max(0.0) <= a.max(b).min_element()
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
        let tree = BoundsTree::of(&all);
        for query in all.iter().step_by(7) {
            for distance in [0.0, 1.0, 10.0, f64::INFINITY] {
                let is_near = |bounds: &Bounds| bounds.distance(query) <= distance;
                let mut found = Vec::new();
                tree.visit(is_near, |at| {
                    found.extend(is_near(&all[at as usize]).then_some(at));
                    true
                });
                found.sort_unstable();
                let expected = (0..).zip(&all).filter(|(_, own)| is_near(own));
                assert_eq!(found, expected.map(|(at, _)| at).collect::<Vec<u32>>());
            }
            let others =
                |at: u32| if all[at as usize] == *query { f64::INFINITY } else { all[at as usize].distance(query) };
            let expected = (0..all.len() as u32).map(others).fold(f64::INFINITY, f64::min);
            let mut measured = 0;
            let found = tree.least(query, f64::INFINITY, |at| {
                measured += 1;
                others(at)
            });
            assert_eq!(found, expected);
            assert!(measured < 120, "{measured}");
        }
        assert_eq!(BoundsTree::default().least(&all[0], f64::INFINITY, |_| 0.0), f64::INFINITY);
    }
    #[test]
    fn the_least_value_does_not_depend_on_the_order_of_equally_near_boxes() {
        // Measured distances of equally near boxes differ by rounding.
        let box_at = |x: f64| Bounds { low: DVec3::X * x, high: DVec3::X * x + 1.0 };
        let places: Vec<f64> = (0..40).map(|at| if at % 2 == 0 { 4.0 } else { -4.0 }).collect();
        let boxes: Vec<Bounds> = places.iter().map(|x| box_at(*x)).collect();
        let least = 3.0 - 2.0 * f64::EPSILON;
        for odd in 0..places.len() {
            let measure = |at: u32| if at as usize == odd { least } else { 3.0 };
            assert_eq!(BoundsTree::of(&boxes).least(&box_at(0.0), f64::INFINITY, measure), least);
        }
    }
}
