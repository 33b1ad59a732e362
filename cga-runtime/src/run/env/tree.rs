//! The recording of the tree of shapes and of keys. The checkpoint of such a run is 0, so every shape leaves the fast path.

use super::Env;
use crate::run::shape_tree::ShapeTree;
use crate::run::sink::Flow;
use crate::run::tree_keys::TreeNode;
use crate::shape::ShapeRef;
use crate::value::Value;
use crate::value::text::Text;

/// A shape that was entered or made, as far as the run records shapes.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct RecordedShape {
    /// Its number in the tree of shapes.
    in_tree: Option<u32>,
    /// Its place among the keys.
    node: TreeNode,
}

impl Env {
    /// Begins to record the tree of shapes.
    pub(crate) fn record_tree(&mut self) {
        self.tree = Some(Box::default());
        self.checkpoint.shapes = 0;
    }

    /// The recorded tree; empty without a recording.
    pub(crate) fn take_tree(&mut self) -> ShapeTree {
        self.tree.take().unwrap_or_default().finish()
    }

    /// Handles the shape of a rule that was entered and counted, at the checkpoint.
    #[cold]
    #[inline(never)]
    pub(crate) fn enter(&mut self, shape: &ShapeRef<'_>) -> Flow {
        if !self.has_quiet_room(0) {
            self.make_room(0)?;
        }
        let level = self.trail.len();
        if let Some(keys) = self.keys() {
            keys.enter(level);
        }
        if self.tree.is_some() {
            let rule = self.trail.last().map_or_else(Text::default, |&rule| self.label(self.rule_name(rule)));
            if let Some(tree) = &mut self.tree {
                tree.enter(level, rule, shape.scope());
            }
        }
        Flow::Continue(())
    }

    /// Records the arguments of the rule that was entered last, in a run that records its tree.
    #[inline]
    pub fn record_arguments(&mut self, arguments: impl FnOnce() -> Vec<Value>) {
        if let Some(tree) = &mut self.tree {
            tree.set_arguments(arguments());
        }
    }

    /// The name of a rule as leaves have it: without the style that has added it, as in `imp.Tall$Cell`.
    fn label(&self, rule: Text) -> Text {
        let Some((style, own)) = rule.rsplit_once('$') else { return rule };
        let import = style.rsplit_once('.').map(|(import, _)| import);
        let is_it = |leaf: &&Text| match import {
            Some(import) => leaf.strip_prefix(import).and_then(|rest| rest.strip_prefix('.')) == Some(own),
            None => leaf.is(own),
        };
        let found = self.leaf_tables.names.iter().find(is_it);
        found.cloned().unwrap_or_else(|| if import.is_none() { own.into() } else { rule.clone() })
    }

    /// The recorded shape of the current rule.
    pub(crate) fn recorded_shape(&self) -> RecordedShape {
        let in_tree = self.tree.as_ref().and_then(|tree| tree.current(self.trail.len()));
        RecordedShape { in_tree, node: self.current_node() }
    }

    /// Records the shape of a leaf symbol.
    pub(crate) fn record_symbol(&mut self, shape: &ShapeRef<'_>, rule: u32) -> RecordedShape {
        let (name, level) = (self.leaf_name(rule), self.trail.len());
        let in_tree = self.tree.as_mut().map(|tree| tree.symbol(level, name, shape.scope()));
        RecordedShape { in_tree, node: self.keys().map_or_else(TreeNode::default, |keys| keys.symbol(level)) }
    }

    /// Counts a leaf symbol in a run that needs no more of leaves. Returns false if it does: it records its tree, or collects closed shapes.
    #[inline]
    pub(crate) fn only_counts_symbol(&mut self) -> bool {
        if self.tree.is_some() || self.collects_occluders() {
            return false;
        }
        let level = self.trail.len();
        self.keys().into_iter().for_each(|keys| keys.count_symbol(level));
        true
    }

    /// Records that a shape was a leaf.
    pub(crate) fn record_leaf(&mut self, recorded: RecordedShape, shape: &ShapeRef<'_>, rule: u32) {
        self.collect_leaf(shape, recorded.node);
        let name = self.leaf_name(rule);
        if let (Some(tree), Some(recorded)) = (&mut self.tree, recorded.in_tree) {
            tree.set_leaf(recorded, name, shape.scope());
        }
    }

    /// The name of a leaf by its number.
    fn leaf_name(&self, rule: u32) -> Text {
        self.leaf_tables.names.get(rule as usize).cloned().unwrap_or_default()
    }
}
