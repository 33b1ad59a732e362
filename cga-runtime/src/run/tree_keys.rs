//! Keys of shapes in the tree of shapes, during a run (*getTreeKey function*).
//!
//! A run tells when it enters a rule, and the number of rules on the trail, the *level*, determines the parent, as in
//! `run/shape_tree/builder.rs`. Each call of a rule and each leaf symbol is a child with a number. A block belongs to its rule, so its
//! children have numbers of the rule. A child that waits has its number at once. If a block waits, its first child has that number, and its
//! other children have the next free numbers of the rule.
//!
//! Occlusion queries tell blocks apart: the solid in one part of a split is no ancestor of the shapes in another part. So a block that is
//! entered is a place of its own, the *part*, with no number in keys. In a rule that does not ask, blocks need not be told.

use std::collections::VecDeque;

/// A shape in [`TreeKeys`]; the initial shape by default.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct TreeNode(u32);

/// The shapes of a run so far. The first one is the initial shape.
#[derive(Clone, Debug)]
pub(crate) struct TreeKeys {
    nodes: Vec<Node>,
    /// The shapes of the rules on the trail, since the last waiting call was resumed.
    path: Vec<u32>,
    /// The waiting call that was resumed last.
    resumed: Option<WaitingChild>,
    waiting: VecDeque<WaitingChild>,
    /// The places around the parts that were entered: each with its level.
    around: Vec<(usize, u32)>,
}

/// A shape or a part.
#[derive(Clone, Copy, Debug)]
struct Node {
    parent: u32,
    /// The number among the children of its rule; for a part, [`PART`] and the number among the parts of its parent.
    number: u32,
    /// The number of ancestors, parts included.
    depth: u32,
    /// The number of children so far; unused for a part.
    children: u32,
    /// The number of parts so far.
    parts: u32,
}

/// The place of a shape in a tree.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Place<'k> {
    keys: &'k TreeKeys,
    node: TreeNode,
}

/// The kinship of a shape with a place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kinship {
    /// It is the place or an ancestor, at a depth.
    Above(u32),
    /// It is a descendant.
    Below,
    /// Their ancestors differ from a depth on.
    Beside(u32),
}

/// Marks the number of a part.
const PART: u32 = 1 << 31;

impl Place<'_> {
    /// The ancestor of the place at a depth.
    pub(crate) fn ancestor(self, depth: u32) -> TreeNode {
        self.keys.ancestor(self.node, depth)
    }

    /// Returns true if the place is a shape of its tree or is below it.
    #[inline]
    pub(crate) fn is_at_or_below(self, above: TreeNode) -> bool {
        self.keys.is_at_or_below(self.node, above)
    }
}

impl Node {
    fn is_part(&self) -> bool {
        self.number & PART != 0
    }
}

/// A call that waits.
#[derive(Clone, Copy, Debug)]
struct WaitingChild {
    parent: u32,
    /// The number of its first child, until there is one.
    number: Option<u32>,
}

/// The state of [`TreeKeys`] before an operand.
#[derive(Debug)]
pub(crate) struct KeysBeforeOperand {
    nodes: usize,
    /// The current shape and its part, whose counts an operand changes.
    counts: [(u32, Node); 2],
    path: Vec<u32>,
    resumed: Option<WaitingChild>,
    waiting: VecDeque<WaitingChild>,
}

impl Default for TreeKeys {
    fn default() -> Self {
        let root = Node { parent: 0, number: 0, depth: 0, children: 0, parts: 0 };
        TreeKeys { nodes: vec![root], path: Vec::new(), resumed: None, waiting: VecDeque::new(), around: Vec::new() }
    }
}

impl TreeKeys {
    /// Enters the rule that is the last of `level` rules on the trail.
    pub(crate) fn enter(&mut self, level: usize) {
        let above = level.saturating_sub(1);
        // The start rule is the rule of the initial shape.
        let node = if above == 0 && self.resumed.is_none() { 0 } else { self.add(above) };
        self.path.truncate(above);
        self.path.push(node);
    }

    /// Enters a block of the rule at a level.
    pub(crate) fn begin_part(&mut self, level: usize) {
        let parent = self.parent(level);
        let above = &mut self.nodes[parent as usize];
        above.parts += 1;
        let part = Node { parent, number: PART | (above.parts - 1), depth: above.depth + 1, children: 0, parts: 0 };
        self.nodes.push(part);
        self.around.push((level, parent));
        self.replace_parent(level, self.nodes.len() as u32 - 1);
    }

    /// Leaves the block that was entered last.
    pub(crate) fn end_part(&mut self) {
        if let Some((level, parent)) = self.around.pop() {
            self.replace_parent(level, parent);
        }
    }

    /// Counts a leaf symbol of the rule at a level, whose place is not needed.
    pub(crate) fn count_symbol(&mut self, level: usize) {
        self.next_number(level, self.parent(level));
    }

    /// Adds a leaf symbol of the rule at a level.
    pub(crate) fn symbol(&mut self, level: usize) -> TreeNode {
        TreeNode(self.add(level))
    }

    /// The shape of the rule at a level; the initial shape before any rule.
    pub(crate) fn current(&self, level: usize) -> TreeNode {
        TreeNode(self.parent(level))
    }

    /// Adds a call of the rule at a level that waits.
    pub(crate) fn wait(&mut self, level: usize) {
        let parent = self.parent(level);
        let number = Some(self.next_number(level, parent));
        self.waiting.push_back(WaitingChild { parent, number });
    }

    /// Resumes the call that has waited longest.
    pub(crate) fn resume(&mut self) {
        self.path.clear();
        self.resumed = self.waiting.pop_front();
    }

    /// The key of a shape: the numbers of children from the initial shape on.
    pub(crate) fn key(&self, node: TreeNode) -> Vec<u32> {
        self.numbers(node).into_iter().filter(|number| number & PART == 0).collect()
    }

    /// The place of a shape, to compare it with places in another tree.
    pub(crate) fn place(&self, node: TreeNode) -> Place<'_> {
        Place { keys: self, node }
    }

    /// The numbers of the key of a shape, with its parts.
    fn numbers(&self, node: TreeNode) -> Vec<u32> {
        let mut numbers = vec![0; self.nodes[node.0 as usize].depth as usize + 1];
        let mut at = node.0;
        for number in numbers.iter_mut().rev() {
            let node = self.nodes[at as usize];
            *number = node.number;
            at = node.parent;
        }
        numbers
    }

    /// The kinship of a shape with a place of another tree.
    pub(crate) fn kinship(&self, node: TreeNode, place: Place<'_>) -> Kinship {
        let [(nodes, own), (others, other)] = [(&*self.nodes, node.0), (&*place.keys.nodes, place.node.0)];
        let [mut own, mut other] = [&nodes[own as usize], &others[other as usize]];
        let above = own.depth;
        let is_below = other.depth < own.depth;
        while own.depth < other.depth {
            other = &others[other.parent as usize];
        }
        while other.depth < own.depth {
            own = &nodes[own.parent as usize];
        }
        // The least depth at which the two differ.
        let mut beside = None;
        while own.depth != 0 {
            if own.number != other.number {
                beside = Some(own.depth);
            }
            (own, other) = (&nodes[own.parent as usize], &others[other.parent as usize]);
        }
        match beside {
            Some(depth) => Kinship::Beside(depth),
            None if is_below => Kinship::Below,
            None => Kinship::Above(above),
        }
    }

    /// The ancestor of a shape at a depth; the shape itself at its own depth or below.
    pub(crate) fn ancestor(&self, node: TreeNode, depth: u32) -> TreeNode {
        let mut at = node.0;
        while depth < self.nodes[at as usize].depth {
            at = self.nodes[at as usize].parent;
        }
        TreeNode(at)
    }

    /// Returns true if a shape is another shape of this tree or is below it.
    #[inline]
    pub(crate) fn is_at_or_below(&self, node: TreeNode, above: TreeNode) -> bool {
        // A shape comes after its ancestors.
        let mut at = node.0;
        while above.0 < at {
            at = self.nodes[at as usize].parent;
        }
        at == above.0
    }

    /// Begins an operand of the rule at a level. Its shapes are not in the tree: they have keys below the current shape, which the end of
    /// the operand removes.
    pub(crate) fn begin_operand(&mut self, level: usize) -> KeysBeforeOperand {
        let parent = self.parent(level);
        KeysBeforeOperand {
            nodes: self.nodes.len(),
            counts: [self.rule_of(parent), parent].map(|node| (node, self.nodes[node as usize])),
            path: self.path.clone(),
            resumed: self.resumed,
            waiting: std::mem::take(&mut self.waiting),
        }
    }

    /// Ends an operand.
    pub(crate) fn end_operand(&mut self, before: KeysBeforeOperand) {
        self.nodes.truncate(before.nodes);
        before.counts.into_iter().for_each(|(node, counts)| self.nodes[node as usize] = counts);
        (self.path, self.resumed, self.waiting) = (before.path, before.resumed, before.waiting);
    }

    #[inline]
    fn parent(&self, level: usize) -> u32 {
        match level.checked_sub(1) {
            Some(above) => self.path.get(above).copied().unwrap_or_default(),
            None => self.resumed.map_or(0, |resumed| resumed.parent),
        }
    }

    fn replace_parent(&mut self, level: usize, parent: u32) {
        match level.checked_sub(1) {
            Some(above) => self.path[above..].iter_mut().take(1).for_each(|own| *own = parent),
            None => self.resumed.iter_mut().for_each(|resumed| resumed.parent = parent),
        }
    }

    /// The shape whose part a place is, or the shape itself.
    fn rule_of(&self, mut node: u32) -> u32 {
        while self.nodes[node as usize].is_part() {
            node = self.nodes[node as usize].parent;
        }
        node
    }

    /// The number of the next child of the rule at a level.
    #[inline]
    fn next_number(&mut self, level: usize, parent: u32) -> u32 {
        let reserved = if level == 0 { self.resumed.as_mut().and_then(|resumed| resumed.number.take()) } else { None };
        reserved.unwrap_or_else(|| {
            let rule = self.rule_of(parent);
            let children = &mut self.nodes[rule as usize].children;
            *children += 1;
            *children - 1
        })
    }

    /// Adds a child of the rule at a level.
    #[inline]
    fn add(&mut self, level: usize) -> u32 {
        let parent = self.parent(level);
        let number = self.next_number(level, parent);
        let depth = self.nodes[parent as usize].depth + 1;
        self.nodes.push(Node { parent, number, depth, children: 0, parts: 0 });
        self.nodes.len() as u32 - 1
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Returns true if a shape is at a place of another tree, or is an ancestor or descendant of it.
    fn is_in_line(keys: &TreeKeys, node: TreeNode, place: Place<'_>) -> bool {
        !matches!(keys.kinship(node, place), Kinship::Beside(_))
    }

    #[test]
    fn children_are_numbered_in_order() {
        let mut keys = TreeKeys::default();
        assert_eq!(keys.key(keys.current(0)), [0]);
        keys.enter(1);
        assert_eq!(keys.key(keys.current(1)), [0]);
        keys.enter(2);
        keys.enter(3);
        assert_eq!(keys.key(keys.current(3)), [0, 0, 0]);
        let leaf = keys.symbol(1);
        assert_eq!(keys.key(leaf), [0, 1]);
        keys.enter(2);
        let leaf = keys.symbol(2);
        assert_eq!(keys.key(leaf), [0, 2, 0]);
    }

    #[test]
    fn calls_that_wait_keep_their_number() {
        let mut keys = TreeKeys::default();
        keys.enter(1);
        keys.wait(1);
        let second = keys.symbol(1);
        assert_eq!(keys.key(second), [0, 1]);
        keys.resume();
        keys.enter(1);
        assert_eq!(keys.key(keys.current(1)), [0, 0]);
        // The second child of a block that waited has the next free number.
        let other = keys.symbol(0);
        assert_eq!(keys.key(other), [0, 2]);
    }

    #[test]
    fn parts_are_places_without_a_number() {
        let mut keys = TreeKeys::default();
        keys.enter(1);
        keys.begin_part(1);
        let (first, in_first) = (keys.current(1), keys.symbol(1));
        keys.end_part();
        keys.begin_part(1);
        keys.begin_part(1);
        keys.enter(2);
        let in_second = keys.current(2);
        keys.end_part();
        keys.end_part();
        assert_eq!([keys.key(first), keys.key(in_first), keys.key(in_second)], [vec![0], vec![0, 0], vec![0, 1]]);
        assert!(is_in_line(&keys, first, keys.place(in_first)) && is_in_line(&keys, in_first, keys.place(first)));
        assert!(!is_in_line(&keys, first, keys.place(in_second)) && !is_in_line(&keys, in_second, keys.place(first)));
        assert!(is_in_line(&keys, keys.current(1), keys.place(in_second)));
    }

    #[test]
    fn an_operand_takes_no_number() {
        let mut keys = TreeKeys::default();
        keys.enter(1);
        keys.symbol(1);
        let before = keys.begin_operand(1);
        keys.enter(2);
        assert_eq!(keys.key(keys.current(2)), [0, 1]);
        keys.wait(2);
        keys.resume();
        keys.enter(1);
        assert_eq!(keys.key(keys.current(1)), [0, 1, 0]);
        keys.end_operand(before);
        let next = keys.symbol(1);
        assert_eq!(keys.key(next), [0, 1]);
    }

    #[test]
    fn ancestors_and_descendants_are_in_line() {
        let mut keys = TreeKeys::default();
        keys.enter(1);
        keys.enter(2);
        let (parent, child, sibling) = (keys.current(2), keys.symbol(2), keys.symbol(2));
        let place = keys.place(parent);
        assert!([parent, child, keys.current(0)].into_iter().all(|node| is_in_line(&keys, node, place)));
        let place = keys.place(child);
        assert!(is_in_line(&keys, parent, place) && !is_in_line(&keys, sibling, place));
        // The same places in another tree.
        let mut other = TreeKeys::default();
        other.enter(1);
        let uncle = other.symbol(1);
        other.count_symbol(1);
        other.enter(2);
        let cousin = other.symbol(2);
        assert!(is_in_line(&keys, parent, other.place(uncle)) && is_in_line(&keys, child, other.place(uncle)));
        assert!(!is_in_line(&keys, parent, other.place(cousin)) && !is_in_line(&keys, child, other.place(cousin)));
        assert_eq!(other.key(cousin), [0, 2, 0]);
    }
}
