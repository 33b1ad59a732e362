//! The status of a sweep: edges, or regions by their left edges, on the sweep line, from left to right.
//!
//! A height-balanced (AVL) tree in an arena. The number of an entry is the index of its node, so an entry is removed
//! without a search. All steps are loops, and each takes at most as many steps as the tree is high, for any results of
//! the comparisons.

use crate::each::Each;
use glam::DVec2;

/// No node.
const NONE: u32 = u32::MAX;

/// The order of a sweep: upwards, then to the right.
#[inline]
pub(super) fn is_below(a: DVec2, b: DVec2) -> bool {
    a.y < b.y || (a.y == b.y && a.x < b.x)
}

/// An entry in the tree. Links are indices, or [`NONE`].
#[derive(Clone, Copy)]
struct StatusNode {
    parent: u32,
    /// The subtrees of entries to the left and to the right.
    children: [u32; 2],
    /// The height of the subtree, 1 for a leaf.
    height: u32,
    /// The lower and upper end of its edge. Stored here, because searches in a large tree wait for memory.
    edge: [DVec2; 2],
}

pub(super) const LEFT: usize = 0;
pub(super) const RIGHT: usize = 1;

/// Entries in order, by number.
pub(super) struct Status {
    nodes: Vec<StatusNode>,
    root: u32,
}

impl Default for Status {
    fn default() -> Self {
        Status { nodes: Vec::new(), root: NONE }
    }
}

impl Status {
    /// Removes all entries.
    pub(super) fn clear(&mut self) {
        self.nodes.clear();
        self.root = NONE;
    }

    /// The entries on both sides of a position: the last one whose edge is left of it, and the first one whose edge is
    /// not. A binary search.
    #[inline]
    pub(super) fn around(&self, mut is_left: impl FnMut([DVec2; 2]) -> bool) -> [Option<u32>; 2] {
        let mut found = [None; 2];
        let mut at = self.root;
        while at != NONE {
            let node = &self.nodes[at as usize];
            let left = is_left(node.edge);
            found[if left { LEFT } else { RIGHT }] = Some(at);
            at = node.children[if left { RIGHT } else { LEFT }];
        }
        found
    }

    /// Inserts an entry after another entry, or at the front. Returns its number: the count of entries so far.
    pub(super) fn insert_after(&mut self, entry: Option<u32>, edge: [DVec2; 2]) -> u32 {
        let new = self.nodes.len() as u32;
        let (parent, side) = match entry {
            Some(entry) => match self.nodes[entry as usize].children[RIGHT] {
                NONE => (entry, RIGHT),
                right => (self.outermost(right, LEFT), LEFT),
            },
            None if self.root == NONE => (NONE, LEFT),
            None => (self.outermost(self.root, LEFT), LEFT),
        };
        self.nodes.push(StatusNode { parent, children: [NONE; 2], height: 1, edge });
        if parent == NONE {
            self.root = new;
        } else {
            self.nodes[parent as usize].children[side] = new;
            self.balance_up(parent);
        }
        new
    }

    /// Sets the edge of an entry.
    #[inline]
    pub(super) fn set_edge(&mut self, entry: u32, edge: [DVec2; 2]) {
        self.nodes[entry as usize].edge = edge;
    }

    /// The next entry on one side of an entry.
    pub(super) fn beside(&self, entry: u32, side: usize) -> Option<u32> {
        let StatusNode { mut parent, children, .. } = self.nodes[entry as usize];
        if children[side] != NONE {
            return Some(self.outermost(children[side], 1 - side));
        }
        let mut at = entry;
        while parent != NONE && self.nodes[parent as usize].children[side] == at {
            (at, parent) = (parent, self.nodes[parent as usize].parent);
        }
        (parent != NONE).then_some(parent)
    }

    /// Removes an entry.
    pub(super) fn remove(&mut self, entry: u32) {
        let StatusNode { parent, children, height, .. } = self.nodes[entry as usize];
        let [left, right] = children;
        if left == NONE || right == NONE {
            let child = if left == NONE { right } else { left };
            self.replace(parent, entry, child);
            self.balance_up(parent);
            return;
        }
        // The next entry takes its place.
        let next = self.outermost(right, LEFT);
        let lowest = if next == right {
            next
        } else {
            let StatusNode { parent: above, children: [_, below], .. } = self.nodes[next as usize];
            self.adopt(above, LEFT, below);
            self.adopt(next, RIGHT, right);
            above
        };
        self.adopt(next, LEFT, left);
        self.nodes[next as usize].height = height;
        self.replace(parent, entry, next);
        self.balance_up(lowest);
    }

    /// The outermost entry of a subtree on one side.
    fn outermost(&self, mut at: u32, side: usize) -> u32 {
        loop {
            match self.nodes[at as usize].children[side] {
                NONE => return at,
                child => at = child,
            }
        }
    }

    /// Makes a subtree, or no subtree, a child.
    fn adopt(&mut self, parent: u32, side: usize, child: u32) {
        self.nodes[parent as usize].children[side] = child;
        if child != NONE {
            self.nodes[child as usize].parent = parent;
        }
    }

    /// Puts a subtree, or no subtree, in the place of a child or of the root.
    fn replace(&mut self, parent: u32, old: u32, new: u32) {
        if parent != NONE {
            let side = usize::from(self.nodes[parent as usize].children[RIGHT] == old);
            self.adopt(parent, side, new);
            return;
        }
        self.root = new;
        if new != NONE {
            self.nodes[new as usize].parent = NONE;
        }
    }

    fn height(&self, at: u32) -> u32 {
        if at == NONE { 0 } else { self.nodes[at as usize].height }
    }

    fn heights(&self, at: u32) -> [u32; 2] {
        self.nodes[at as usize].children.each(|child| self.height(child))
    }

    /// Corrects heights from a node upwards, and rotates where they differ by two, until nothing changes.
    fn balance_up(&mut self, mut at: u32) {
        while at != NONE {
            let old = self.nodes[at as usize].height;
            let [left, right] = self.heights(at);
            if left.abs_diff(right) > 1 {
                let high = usize::from(left < right);
                let child = self.nodes[at as usize].children[high];
                let below = self.heights(child);
                if below[high] < below[1 - high] {
                    self.rotate(child, 1 - high);
                }
                at = self.rotate(at, high);
            } else {
                self.nodes[at as usize].height = 1 + left.max(right);
            }
            let StatusNode { parent, height, .. } = self.nodes[at as usize];
            if height == old {
                return;
            }
            at = parent;
        }
    }

    /// Lifts the child on one side above its parent. Returns the child.
    fn rotate(&mut self, at: u32, side: usize) -> u32 {
        let StatusNode { parent, children, .. } = self.nodes[at as usize];
        let child = children[side];
        self.replace(parent, at, child);
        self.adopt(at, side, self.nodes[child as usize].children[1 - side]);
        self.adopt(child, 1 - side, at);
        for node in [at, child] {
            let [left, right] = self.heights(node);
            self.nodes[node as usize].height = 1 + left.max(right);
        }
        child
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The entries in order. Checks links and heights.
    fn in_order(status: &Status) -> Vec<u32> {
        fn walk(status: &Status, at: u32, parent: u32, order: &mut Vec<u32>) -> u32 {
            if at == NONE {
                return 0;
            }
            let node = status.nodes[at as usize];
            assert_eq!(node.parent, parent);
            let left = walk(status, node.children[LEFT], at, order);
            order.push(at);
            let right = walk(status, node.children[RIGHT], at, order);
            assert!(left.abs_diff(right) <= 1);
            assert_eq!(node.height, 1 + left.max(right));
            node.height
        }
        let mut order = Vec::new();
        walk(status, status.root, NONE, &mut order);
        order
    }

    #[test]
    fn order_and_balance_are_those_of_a_list() {
        let mut random = 1u64;
        let mut below = |count: usize| {
            random = random.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (random >> 33) as usize % count
        };
        // Grows, shrinks to nothing and grows again, at random positions and at the ends.
        for ends in [false, true] {
            let (mut status, mut list) = (Status::default(), Vec::new());
            for round in 0..6_000 {
                let grows = if round / 1_000 % 2 == 0 { below(10) < 8 } else { below(10) < 1 };
                if grows || list.is_empty() {
                    let at = if ends { list.len() } else { below(list.len() + 1) };
                    let new = status.nodes.len() as u32;
                    let edge = [DVec2::splat(f64::from(new)), DVec2::ZERO];
                    status.insert_after(at.checked_sub(1).map(|at| list[at]), edge);
                    list.insert(at, new);
                } else {
                    let at = if ends { 0 } else { below(list.len()) };
                    status.remove(list.remove(at));
                }
                if round % 50 == 0 {
                    assert_eq!(in_order(&status), list);
                    for (at, &entry) in list.iter().enumerate() {
                        let neighbours = [at.checked_sub(1).map(|at| list[at]), list.get(at + 1).copied()];
                        assert_eq!([LEFT, RIGHT].map(|side| status.beside(entry, side)), neighbours);
                    }
                    let at = below(list.len() + 1);
                    let place =
                        |[from, _]: [DVec2; 2]| list.iter().position(|&entry| f64::from(entry) == from.x).unwrap();
                    let found = status.around(|edge| place(edge) < at);
                    assert_eq!(found, [at.checked_sub(1).map(|at| list[at]), list.get(at).copied()]);
                }
            }
        }
    }
}
