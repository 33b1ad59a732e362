//! A tree of the edges of a facet with many corners, to find those at a place.

use glam::DVec2;

use crate::bounds_tree::{BoundsTree, overlap};
use crate::each::Each;
use crate::mesh::Bounds;
use crate::small_sort::SmallSort;

/// Facets with at most this many corners have no tree: a look at all their edges is as fast.
pub(super) const MOST_WITHOUT_TREE: usize = 64;

/// The edges of the loops of a facet, in its plane.
pub(super) struct RimTree {
    /// Each edge as the numbers of its corners.
    edges: Vec<[usize; 2]>,
    boxes: Vec<Bounds>,
    tree: BoundsTree,
}

impl RimTree {
    /// The tree of some edges. `at` gives the place of a corner, and `reach` is added to the boxes.
    pub(super) fn new(edges: Vec<[usize; 2]>, at: impl Fn(usize) -> DVec2, reach: f64) -> Self {
        let around = |edge: &[usize; 2]| {
            let Bounds { low, high } = Bounds::of(edge.each(|corner| at(corner).extend(0.0)));
            Bounds { low: low - reach, high: high + reach }
        };
        let boxes: Vec<Bounds> = edges.iter().map(around).collect();
        let tree = BoundsTree::of(&boxes);
        RimTree { edges, boxes, tree }
    }

    /// Calls `found` with the edges whose boxes overlap the one between two places. Returns the number of boxes that were
    /// compared.
    pub(super) fn visit(&self, low: DVec2, high: DVec2, mut found: impl FnMut([usize; 2])) -> usize {
        let here = Bounds { low: low.extend(0.0), high: high.extend(0.0) };
        let mut compared = 0;
        self.tree.visit(
            |around| overlap(around, &here),
            |number| {
                compared += 1;
                if overlap(&self.boxes[number as usize], &here) {
                    found(self.edges[number as usize]);
                }
                true
            },
        );
        compared
    }

    /// Finds the edges that may have a point in a box between two opposite corners, in order. Returns the number of boxes that
    /// were compared.
    pub(super) fn near(&self, [a, b]: [DVec2; 2], edges: &mut Vec<[usize; 2]>) -> usize {
        edges.clear();
        let compared = self.visit(a.min(b), a.max(b), |edge| edges.push(edge));
        edges.small_sort_unstable();
        compared
    }
}
