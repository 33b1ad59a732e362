//! A tree of the bounding boxes of facets.

use glam::DVec3;

use super::facet::Facet;
use crate::geometry::mesh::Bounds;

/// The number of facets in a leaf of the tree.
const LEAF: usize = 6;

/// A binary tree. A node is followed by all nodes of its first half, then by all nodes of its second half.
pub(super) struct FacetTree {
    nodes: Vec<FacetNode>,
    /// The facets, leaf by leaf.
    order: Vec<u32>,
}

struct FacetNode {
    bounds: Bounds,
    /// The node of the second half; 0 for a leaf.
    second: u32,
    /// The range in `order`.
    start: u32,
    end: u32,
}

impl FacetTree {
    pub(super) fn of(facets: &[Facet]) -> Self {
        let mut tree = FacetTree { nodes: Vec::new(), order: (0..facets.len() as u32).collect() };
        if !facets.is_empty() {
            tree.add(facets, 0, facets.len());
        }
        tree
    }

    fn add(&mut self, facets: &[Facet], start: usize, end: usize) {
        let number = self.nodes.len();
        let boxes = self.order[start..end].iter().map(|facet| &facets[*facet as usize].bounds);
        let bounds = Bounds::of(boxes.flat_map(|bounds| [bounds.low, bounds.high]));
        self.nodes.push(FacetNode { bounds, second: 0, start: start as u32, end: end as u32 });
        if end - start <= LEAF {
            return;
        }
        let size = bounds.size().to_array();
        let axis = (1..3).fold(0, |longest, axis| if size[longest] < size[axis] { axis } else { longest });
        let middle = |facet: u32| facets[facet as usize].bounds.low[axis] + facets[facet as usize].bounds.high[axis];
        let half = (end - start) / 2;
        self.order[start..end].select_nth_unstable_by(half, |&a, &b| middle(a).total_cmp(&middle(b)).then(a.cmp(&b)));
        self.add(facets, start, start + half);
        self.nodes[number].second = self.nodes.len() as u32;
        self.add(facets, start + half, end);
    }

    /// Calls `found` with the facets in the nodes that `enters` accepts, until `found` returns false.
    pub(super) fn visit(&self, enters: impl Fn(&Bounds) -> bool, mut found: impl FnMut(u32) -> bool) {
        let mut open = vec![0usize];
        while let Some(number) = open.pop() {
            let Some(node) = self.nodes.get(number).filter(|node| enters(&node.bounds)) else { continue };
            if node.second == 0 {
                if !self.order[node.start as usize..node.end as usize].iter().all(|facet| found(*facet)) {
                    return;
                }
            } else {
                open.extend([node.second as usize, number + 1]);
            }
        }
    }
}

/// Returns true if two boxes have a common point.
pub(super) fn overlap(a: &Bounds, b: &Bounds) -> bool {
    a.low.cmple(b.high).all() && b.low.cmple(a.high).all()
}

/// Returns true if a ray meets a box. `inverse` are the reciprocals of the ray's direction, which has no component zero.
pub(super) fn meets_ray(bounds: &Bounds, from: DVec3, inverse: DVec3) -> bool {
    let [a, b] = [(bounds.low - from) * inverse, (bounds.high - from) * inverse];
    a.min(b).max_element().max(0.0) <= a.max(b).min_element()
}
