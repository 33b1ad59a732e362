//! A tree of bounding boxes.

use glam::DVec3;

use crate::bounds::Bounds;

/// The number of boxes in a leaf of the tree.
const LEAF: usize = 6;

/// The most nodes that wait for a visit: one for each level of the tree. Each level halves a number of 32 bits.
const MOST_OPEN: usize = 40;

/// A binary tree of numbered boxes. A node is followed by all nodes of its first half, then by all nodes of its second half.
#[derive(Debug, Default)]
pub(crate) struct BoundsTree {
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
    /// The tree of boxes, which are numbered in order.
    pub(crate) fn of(boxes: &[Bounds]) -> Self {
        let mut tree = BoundsTree { nodes: Vec::new(), order: (0..boxes.len() as u32).collect() };
        if !boxes.is_empty() {
            tree.add(boxes, 0, boxes.len());
        }
        tree
    }

    fn add(&mut self, boxes: &[Bounds], start: usize, end: usize) {
        let number = self.nodes.len();
        let here = self.order[start..end].iter().map(|number| &boxes[*number as usize]);
        let bounds = Bounds::of(here.flat_map(|bounds| [bounds.low, bounds.high]));
        self.nodes.push(BoundsNode { bounds, second: 0, start: start as u32, end: end as u32 });
        if end - start <= LEAF {
            return;
        }
        let size = bounds.size().to_array();
        let axis = (1..3).fold(0, |longest, axis| if size[longest] < size[axis] { axis } else { longest });
        let middle = |number: u32| boxes[number as usize].low[axis] + boxes[number as usize].high[axis];
        let half = (end - start) / 2;
        self.order[start..end].select_nth_unstable_by(half, |&a, &b| middle(a).total_cmp(&middle(b)).then(a.cmp(&b)));
        self.add(boxes, start, start + half);
        self.nodes[number].second = self.nodes.len() as u32;
        self.add(boxes, start + half, end);
    }

    /// Calls `found` with the numbers of the boxes in the nodes that `enters` accepts, until `found` returns false. Returns the number
    /// of nodes that were compared.
    #[inline]
    pub(crate) fn visit(&self, enters: impl Fn(&Bounds) -> bool, mut found: impl FnMut(u32) -> bool) -> usize {
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
}

/// Returns true if two boxes have a common point.
pub(crate) fn overlap(a: &Bounds, b: &Bounds) -> bool {
    a.low.cmple(b.high).all() && b.low.cmple(a.high).all()
}

/// Returns true if a ray meets a box. `inverse` are the reciprocals of the ray's direction, which has no component zero.
pub(crate) fn meets_ray(bounds: &Bounds, from: DVec3, inverse: DVec3) -> bool {
    let [a, b] = [(bounds.low - from) * inverse, (bounds.high - from) * inverse];
    a.min(b).max_element().max(0.0) <= a.max(b).min_element()
}
