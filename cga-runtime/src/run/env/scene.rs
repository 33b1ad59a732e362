//! Other shapes: the ones that queries of the run ask about, and the ones that it collects for queries.
//!
//! The checkpoint of a run with tree keys is 0, so every shape leaves the fast path.

use super::Env;
use crate::fault::FaultKind;
use crate::geometry::relation::Relation;
use crate::run::ghost::near::{NearQueries, OcclusionQuery};
use crate::run::ghost::{Collect, Ghost, GhostBuilder, body};
use crate::run::settings::Repeats;
use crate::run::surroundings::{QueryTarget, Surroundings};
use crate::run::tree_keys::{KeysBeforeOperand, TreeKeys, TreeNode};
use crate::shape::ShapeRef;
use crate::shape::body::Body;
use crate::shape::view::View;
use crate::value::text::Text;

/// The shapes around a run, and those that it collects.
#[derive(Debug, Default)]
pub(crate) struct SceneState {
    pub(crate) around: Surroundings,
    /// By target, the closed shapes near the last queries.
    near: [NearQueries; 3],
    /// The keys of the shapes so far, if a rule or the ghost needs them.
    keys: Option<Box<TreeKeys>>,
    /// The ghost under construction. Operands are not collected.
    ghost: Option<Box<GhostBuilder>>,
}

/// The state of a run before an operand.
#[derive(Debug)]
pub(crate) struct BeforeOperand {
    keys: Option<KeysBeforeOperand>,
    ghost: Option<Box<GhostBuilder>>,
}

impl Env {
    /// Begins to record the keys of shapes.
    pub(crate) fn record_keys(&mut self) {
        self.scene.keys = Some(Box::default());
        self.checkpoint.shapes = 0;
    }

    /// Begins to collect shapes for queries.
    pub(crate) fn collect(&mut self, collect: Collect) {
        if collect.occluders {
            // Templates have leaves alone.
            self.settings.repeats = Repeats::Direct;
            self.record_keys();
        }
        self.scene.ghost = Some(Box::new(GhostBuilder::new(collect)));
    }

    /// The shapes collected; empty without a collection.
    pub(crate) fn take_ghost(&mut self) -> Ghost {
        let keys = self.scene.keys.take().unwrap_or_default();
        self.scene.ghost.take().map_or_else(Ghost::default, |ghost| ghost.finish(*keys))
    }

    /// The keys, if they are recorded.
    pub(super) fn keys(&mut self) -> Option<&mut TreeKeys> {
        self.scene.keys.as_deref_mut()
    }

    /// The shape of the current rule.
    pub(super) fn current_node(&self) -> TreeNode {
        self.scene.keys.as_ref().map_or_else(TreeNode::default, |keys| keys.current(self.trail.len()))
    }

    /// The key of the current shape: the numbers of children from the initial shape on.
    pub(crate) fn tree_key(&self) -> Vec<u32> {
        self.scene.keys.as_ref().map_or_else(|| vec![0], |keys| keys.key(keys.current(self.trail.len())))
    }

    /// Enters a block of the current rule, which is a place of its own for occlusion queries.
    pub(crate) fn enter_block(&mut self) {
        let level = self.trail.len();
        if let Some(keys) = self.keys() {
            keys.begin_part(level);
        }
    }

    /// Leaves a block.
    pub(crate) fn leave_block(&mut self) {
        if let Some(keys) = self.keys() {
            keys.end_part();
        }
    }

    /// Returns true if shapes are collected for queries and a rule leaves none if it gets this shape. The rule makes no labels, and solids of
    /// flat faces only if `makes_solids`.
    #[inline]
    pub(crate) fn leaves_nothing(&self, shape: &ShapeRef<'_>, makes_solids: bool) -> bool {
        let Some(ghost) = &self.scene.ghost else { return false };
        !ghost.collect.occluders || (!makes_solids && shape.is_flat_face())
    }

    /// Returns true if closed shapes are collected.
    #[inline]
    pub(crate) fn collects_occluders(&self) -> bool {
        self.scene.ghost.as_ref().is_some_and(|ghost| ghost.collect.occluders)
    }

    /// Collects a labelled copy of the current shape.
    pub(crate) fn collect_label(&mut self, label: Text, body: impl FnOnce() -> Body) {
        let node = self.current_node();
        if let Some(ghost) = &mut self.scene.ghost {
            ghost.add_label(label, body(), node);
        }
    }

    /// Collects the current shape, on which the rule applies a `comp` or an `offset`.
    pub(crate) fn collect_divided(&mut self, body: impl FnOnce() -> Body) {
        if self.collects_occluders() {
            let node = self.current_node();
            self.add_occluder(body(), node);
        }
    }

    /// Collects a leaf.
    pub(crate) fn collect_leaf(&mut self, shape: &ShapeRef<'_>, node: TreeNode) {
        if self.collects_occluders() {
            self.add_occluder(Body::from(shape), node);
        }
    }

    fn add_occluder(&mut self, body: Body, node: TreeNode) {
        if let Some(ghost) = &mut self.scene.ghost {
            ghost.add_occluder(body, node);
        }
    }

    /// Begins an operand.
    pub(crate) fn begin_operand(&mut self) -> BeforeOperand {
        let level = self.trail.len();
        let keys = self.scene.keys.as_mut().map(|keys| keys.begin_operand(level));
        BeforeOperand { keys, ghost: self.scene.ghost.take() }
    }

    /// Ends an operand.
    pub(crate) fn end_operand(&mut self, before: BeforeOperand) {
        if let (Some(keys), Some(before)) = (&mut self.scene.keys, before.keys) {
            keys.end_operand(before);
        }
        self.scene.ghost = before.ghost;
        self.scene.near.iter_mut().for_each(NearQueries::forget);
    }

    /// Reports a query of other initial shapes in a run that knows none, as it is not part of a scene.
    pub(crate) fn expect_scene(&mut self, target: QueryTarget) {
        if target == QueryTarget::Inter && self.scene.around.neighbours.is_none() {
            let message = "a query with `inter` gives its default, as this run knows no other initial shape; lots that ask about each \
                           other are run by `Scene::new(&grammar, &lots).generate(&settings)`";
            self.fault_once(FaultKind::Value, message);
        }
    }

    /// The wanted answers for a shape, among the closed shapes of a target with a label; an empty label means all shapes.
    pub(crate) fn relation(
        &mut self,
        shape: &impl View,
        target: QueryTarget,
        label: &str,
        wanted: Relation,
    ) -> Relation {
        self.expect_scene(target);
        let SceneState { around, keys, near, .. } = &mut self.scene;
        let ghosts = around.occluding(target);
        if ghosts.is_empty() {
            return Relation::NONE;
        }
        let place = keys.as_ref().map(|keys| keys.place(keys.current(self.trail.len())));
        let query = OcclusionQuery { wanted, label: Some(label).filter(|label| !label.is_empty()), place };
        let near = &mut near[target as usize];
        if let Some(geometry) = shape.cuboid() {
            return near.relation_of_box(ghosts, &geometry, query);
        }
        body::relation(&shape.body(), |geometry| near.relation(ghosts, geometry, query))
    }
}
