//! The recording of a tree of shapes.
//!
//! A run tells when it enters a rule, but not when it leaves one. The number of rules on the trail, the *level*, determines the parent.
//! A call that waits has a place among the children of its rule: its shapes take that place at the end, as if it had not waited.

use std::collections::{BTreeMap, VecDeque};

use super::{ShapeTree, TreeShape};
use crate::shape::scope::Scope;
use crate::value::Value;
use crate::value::text::Text;

/// A tree of shapes under construction.
#[derive(Debug, Default)]
pub(crate) struct TreeBuilder {
    shapes: Vec<TreeShape>,
    leaves: Vec<u32>,
    places: Vec<TreePlace>,
    /// The places of the rules on the trail, since the last waiting call was resumed.
    path: Vec<u32>,
    /// The place of the waiting call that was resumed last.
    resumed: Option<u32>,
    /// The places of the calls that wait, in the order in which they are resumed.
    waiting: VecDeque<u32>,
    arguments: BTreeMap<u32, Box<[Value]>>,
}

/// The place of a shape, or of a call that waited, among the children of a rule.
#[derive(Debug)]
struct TreePlace {
    /// The shape. For a call, the shape whose rule has made the call.
    shape: u32,
    is_call: bool,
    first_child: Option<u32>,
    last_child: Option<u32>,
    next: Option<u32>,
}

impl TreeBuilder {
    /// Adds the shape of the rule that is the last of `level` rules on the trail.
    pub(crate) fn enter(&mut self, level: usize, rule: Text, scope: Scope) {
        let place = self.add(level - 1, rule, scope);
        self.path.truncate(level - 1);
        self.path.push(place);
    }

    /// Sets the arguments of the rule that was entered last.
    pub(crate) fn set_arguments(&mut self, arguments: Vec<Value>) {
        if let Some(last) = self.shapes.len().checked_sub(1) {
            self.arguments.insert(last as u32, arguments.into());
        }
    }

    /// Adds a leaf symbol of the rule at a level.
    pub(crate) fn symbol(&mut self, level: usize, rule: Text, scope: Scope) -> u32 {
        let place = self.add(level, rule, scope);
        self.places[place as usize].shape
    }

    /// The shape of the rule at a level.
    pub(crate) fn current(&self, level: usize) -> Option<u32> {
        self.parent(level).map(|place| self.places[place as usize].shape)
    }

    /// Makes a shape the next leaf.
    pub(crate) fn set_leaf(&mut self, shape: u32, rule: Text, scope: Scope) {
        let leaf = Some(self.leaves.len() as u32);
        self.leaves.push(shape);
        let shape = &mut self.shapes[shape as usize];
        (shape.rule, shape.scope, shape.leaf) = (rule, scope, leaf);
    }

    /// Adds a call of the rule at a level that waits.
    pub(crate) fn wait(&mut self, level: usize) {
        if let Some(shape) = self.current(level) {
            let place = self.add_place(level, shape, true);
            self.waiting.push_back(place);
        }
    }

    /// Resumes the call that has waited longest.
    pub(crate) fn resume(&mut self) {
        self.path.clear();
        self.resumed = self.waiting.pop_front();
    }

    /// The finished tree.
    pub(crate) fn finish(self) -> ShapeTree {
        let TreeBuilder { mut shapes, leaves, places, arguments, .. } = self;
        let mut children = Vec::with_capacity(shapes.len());
        let mut open = Vec::new();
        for place in places.iter().filter(|place| !place.is_call) {
            let start = children.len() as u32;
            open.extend(place.first_child);
            while let Some(child) = open.pop() {
                let TreePlace { shape, is_call, first_child, next, .. } = places[child as usize];
                open.extend(next);
                if is_call {
                    open.extend(first_child);
                } else {
                    shapes[shape as usize].number = children.len() as u32 - start;
                    children.push(shape);
                }
            }
            shapes[place.shape as usize].children = start..children.len() as u32;
        }
        ShapeTree { shapes, children, leaves, arguments }
    }

    /// The place of the rule at a level, or of the call that was resumed.
    fn parent(&self, level: usize) -> Option<u32> {
        match level.checked_sub(1) {
            Some(above) => self.path.get(above).copied(),
            None => self.resumed,
        }
    }

    /// Adds a shape below the rule at a level. Returns its place.
    fn add(&mut self, level: usize, rule: Text, scope: Scope) -> u32 {
        let shape = self.shapes.len() as u32;
        let parent = self.current(level);
        self.shapes.push(TreeShape { rule, scope, parent, number: 0, leaf: None, children: 0..0 });
        self.add_place(level, shape, false)
    }

    /// Adds a place after the last child of the rule at a level.
    fn add_place(&mut self, level: usize, shape: u32, is_call: bool) -> u32 {
        let place = self.places.len() as u32;
        if let Some(parent) = self.parent(level) {
            let before = self.places[parent as usize].last_child.replace(place);
            match before {
                Some(before) => self.places[before as usize].next = Some(place),
                None => self.places[parent as usize].first_child = Some(place),
            }
        }
        self.places.push(TreePlace { shape, is_call, first_child: None, last_child: None, next: None });
        place
    }
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::*;

    fn keys(tree: &ShapeTree) -> Vec<String> {
        tree.nodes().map(|node| format!("{} {}", node.rule(), node.key())).collect()
    }

    #[test]
    fn the_level_determines_the_parent() {
        let (mut tree, scope) = (TreeBuilder::default(), Scope::new(DVec3::ONE));
        tree.enter(1, Text::fixed("Lot"), scope);
        tree.enter(2, Text::fixed("A"), scope);
        tree.enter(3, Text::fixed("B"), scope);
        tree.symbol(1, Text::fixed("leaf of Lot"), scope);
        tree.enter(2, Text::fixed("C"), scope);
        tree.symbol(2, Text::fixed("leaf of C"), scope);
        let tree = tree.finish();
        assert_eq!(keys(&tree), ["Lot 0;", "A 0;0;", "B 0;0;0;", "leaf of Lot 0;1;", "C 0;2;", "leaf of C 0;2;0;"]);
        assert!(tree.nodes().all(|node| tree.find(&node.key()).map(|found| found.index()) == Some(node.index())));
        assert!(["", "0", "1;", "0;3;", "0;x;", "0;0"].iter().all(|key| tree.find(key).is_none()));
    }

    #[test]
    fn a_shape_takes_about_200_bytes() {
        // A shape is also a child and may be a leaf.
        let bytes = size_of::<TreeShape>() + size_of::<TreePlace>() + 2 * size_of::<u32>();
        assert!((150..=220).contains(&bytes), "{bytes}");
    }

    #[test]
    fn calls_that_wait_keep_their_place() {
        let (mut tree, scope) = (TreeBuilder::default(), Scope::new(DVec3::ONE));
        tree.enter(1, Text::fixed("Lot"), scope);
        tree.enter(2, Text::fixed("A"), scope);
        tree.wait(2);
        tree.wait(1);
        tree.enter(2, Text::fixed("C"), scope);
        // The call of a rule, by `A`.
        tree.resume();
        tree.enter(1, Text::fixed("below A"), scope);
        tree.wait(1);
        // A block of `Lot` with two children. A third one waits between them.
        tree.resume();
        tree.enter(1, Text::fixed("B"), scope);
        tree.wait(0);
        tree.symbol(0, Text::fixed("leaf"), scope);
        tree.resume();
        tree.symbol(0, Text::fixed("deepest"), scope);
        tree.resume();
        tree.enter(1, Text::fixed("between"), scope);
        let tree = tree.finish();
        let expected =
            ["Lot 0;", "A 0;0;", "C 0;4;", "below A 0;0;0;", "B 0;1;", "leaf 0;3;", "deepest 0;0;0;0;", "between 0;2;"];
        assert_eq!(keys(&tree), expected);
    }
}
