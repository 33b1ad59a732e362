//! Keys of shapes in the tree of shapes, during a run (*getTreeKey function*).
//!
//! A run tells when it enters a rule, and the number of rules on the trail, the *level*, determines the parent, as in
//! `run/shape_tree/builder.rs`. Each call of a rule and each leaf symbol is a child with a number. A block belongs to its rule. A child that
//! waits has its number at once. If a block waits, its first child has that number, and its other children have the next free
//! numbers of the rule.

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
}

#[derive(Clone, Copy, Debug)]
struct Node {
    parent: u32,
    /// The number among the children of its parent.
    number: u32,
    /// The number of ancestors.
    depth: u32,
    /// The number of children so far.
    children: u32,
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
    parent: u32,
    children: u32,
    path: Vec<u32>,
    resumed: Option<WaitingChild>,
    waiting: VecDeque<WaitingChild>,
}

impl Default for TreeKeys {
    fn default() -> Self {
        let root = Node { parent: 0, number: 0, depth: 0, children: 0 };
        TreeKeys { nodes: vec![root], path: Vec::new(), resumed: None, waiting: VecDeque::new() }
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
        let mut numbers = vec![0; self.nodes[node.0 as usize].depth as usize + 1];
        let mut at = node.0;
        for number in numbers.iter_mut().rev() {
            let node = self.nodes[at as usize];
            *number = node.number;
            at = node.parent;
        }
        numbers
    }

    /// Returns true if a shape has the key, or is an ancestor or descendant of the place with that key.
    pub(crate) fn is_in_line(&self, node: TreeNode, key: &[u32]) -> bool {
        let mut node = self.nodes[node.0 as usize];
        while key.len() <= node.depth as usize {
            node = self.nodes[node.parent as usize];
        }
        loop {
            if key.get(node.depth as usize) != Some(&node.number) {
                return false;
            }
            if node.depth == 0 {
                return true;
            }
            node = self.nodes[node.parent as usize];
        }
    }

    /// Begins an operand of the rule at a level. Its shapes are not in the tree: they have keys below the current shape, which the end of
    /// the operand removes.
    pub(crate) fn begin_operand(&mut self, level: usize) -> KeysBeforeOperand {
        let parent = self.parent(level);
        KeysBeforeOperand {
            nodes: self.nodes.len(),
            parent,
            children: self.nodes[parent as usize].children,
            path: self.path.clone(),
            resumed: self.resumed,
            waiting: std::mem::take(&mut self.waiting),
        }
    }

    /// Ends an operand.
    pub(crate) fn end_operand(&mut self, before: KeysBeforeOperand) {
        self.nodes.truncate(before.nodes);
        self.nodes[before.parent as usize].children = before.children;
        (self.path, self.resumed, self.waiting) = (before.path, before.resumed, before.waiting);
    }

    fn parent(&self, level: usize) -> u32 {
        match level.checked_sub(1) {
            Some(above) => self.path.get(above).copied().unwrap_or_default(),
            None => self.resumed.map_or(0, |resumed| resumed.parent),
        }
    }

    /// The number of the next child of the rule at a level.
    fn next_number(&mut self, level: usize, parent: u32) -> u32 {
        let reserved = if level == 0 { self.resumed.as_mut().and_then(|resumed| resumed.number.take()) } else { None };
        reserved.unwrap_or_else(|| {
            let children = &mut self.nodes[parent as usize].children;
            *children += 1;
            *children - 1
        })
    }

    /// Adds a child of the rule at a level.
    fn add(&mut self, level: usize) -> u32 {
        let parent = self.parent(level);
        let number = self.next_number(level, parent);
        let depth = self.nodes[parent as usize].depth + 1;
        self.nodes.push(Node { parent, number, depth, children: 0 });
        self.nodes.len() as u32 - 1
    }
}

#[cfg(test)]
mod tests {
    use super::*;

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
        let key = keys.key(parent);
        assert!(
            keys.is_in_line(parent, &key) && keys.is_in_line(child, &key) && keys.is_in_line(keys.current(0), &key)
        );
        let key = keys.key(child);
        assert!(keys.is_in_line(parent, &key) && !keys.is_in_line(sibling, &key));
        assert!(!keys.is_in_line(parent, &[0, 1]) && !keys.is_in_line(child, &[0, 1, 0]));
    }
}
