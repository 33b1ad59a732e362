//! Boxes around initial shapes as seen from above, by which neighbours are found.

use crate::geometry::bounds_tree::BoundsTree;
use crate::geometry::mesh::Bounds;
use crate::geometry::small_sort::SmallSort;
use crate::shape::Shape;
use crate::shape::body::Body;

/// The box around an initial shape, without its height. A wrong one, such as one with NaN, has an empty box: its run never begins, and NaN
/// in the tree of boxes would hide others.
pub(super) fn plan_box(lot: &Shape) -> Bounds {
    if lot.check_initial().is_err() {
        return Bounds::EMPTY;
    }
    let Bounds { mut low, mut high } = Body::from(lot).bounds();
    (low.y, high.y) = (0.0, 0.0);
    Bounds { low, high }
}

/// Boxes with a tree.
#[derive(Debug)]
pub(super) struct Plan {
    boxes: Vec<Bounds>,
    tree: BoundsTree,
}

impl Plan {
    pub(super) fn of(boxes: Vec<Bounds>) -> Self {
        Plan { tree: BoundsTree::of(&boxes), boxes }
    }

    pub(super) fn boxes(&self) -> &[Bounds] {
        &self.boxes
    }

    /// The numbers of the boxes that are at most so far from another one, in ascending order.
    pub(super) fn within(&self, query: &Bounds, distance: f64) -> Vec<usize> {
        let mut found = Vec::new();
        self.visit(query, distance, |at| {
            found.push(at);
            true
        });
        found.small_sort_unstable();
        found
    }

    /// Returns true if a box is at most so far from another one.
    pub(super) fn has_within(&self, query: &Bounds, distance: f64) -> bool {
        let mut is_found = false;
        self.visit(query, distance, |_| {
            is_found = true;
            false
        });
        is_found
    }

    /// Calls `take` with the numbers of the boxes that are at most so far from another one, until it returns false.
    fn visit(&self, query: &Bounds, distance: f64, mut take: impl FnMut(usize) -> bool) {
        let is_near = |bounds: &Bounds| bounds.distance(query) <= distance;
        self.tree.visit(is_near, |at| !is_near(&self.boxes[at as usize]) || take(at as usize));
    }
}
