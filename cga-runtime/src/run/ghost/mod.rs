//! Ghosts: the shapes of a derivation that queries of other shapes find.
//!
//! A query never asks the derivation that it is part of. Queries of the same initial shape (`intra`) ask a derivation before it, in which
//! every such query gave its default. Queries of other initial shapes (`inter`) ask derivations of these in which every `inter` query gave
//! its default (*CGA and its context*). The shapes of such a derivation are its ghost.

pub(crate) mod body;
mod label_index;
mod labelled;
pub(crate) mod leaf_sink;
pub(crate) mod near;
mod occluders;

use super::tree_keys::{TreeKeys, TreeNode};
use crate::shape::body::Body;
use crate::value::text::Text;

pub(crate) use label_index::LabelIndex;
pub use labelled::ContextComparison;
pub(crate) use labelled::LabelledShape;
pub(crate) use occluders::{GhostOccluders, OccluderList};

/// What a derivation collects for queries.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Collect {
    /// Labelled shapes.
    pub(crate) labels: bool,
    /// Closed shapes that occlude: leaves, shapes before a `comp` or an `offset` with selector, labelled shapes.
    pub(crate) occluders: bool,
}

impl Collect {
    /// Returns true if nothing is collected.
    pub(crate) fn is_nothing(self) -> bool {
        self == Collect::default()
    }
}

/// The shapes of a derivation that queries find.
#[derive(Debug, Default)]
pub struct Ghost {
    labels: LabelIndex,
    occluders: GhostOccluders,
}

impl Ghost {
    /// The labelled shapes.
    pub(crate) fn labels(&self) -> &LabelIndex {
        &self.labels
    }

    /// The ghost without the tree of its shapes, which only queries of the same initial shape need.
    pub(super) fn without_keys(mut self) -> Self {
        self.occluders.forget_keys();
        self
    }

    /// The closed shapes.
    pub(crate) fn occluders(&self) -> &GhostOccluders {
        &self.occluders
    }
}

/// A ghost under construction.
#[derive(Debug)]
pub(crate) struct GhostBuilder {
    pub(crate) collect: Collect,
    labels: LabelIndex,
    occluders: OccluderList,
}

impl GhostBuilder {
    pub(crate) fn new(collect: Collect) -> Self {
        GhostBuilder { collect, labels: LabelIndex::default(), occluders: OccluderList::default() }
    }

    /// Adds a labelled copy of a shape. `node` is the shape whose rule makes it.
    pub(crate) fn add_label(&mut self, label: Text, body: Body, node: TreeNode) {
        if self.collect.labels {
            self.labels.add(label.clone(), 0, LabelledShape::of(&body));
        }
        if self.collect.occluders {
            self.occluders.add(body, node, Some(label));
        }
    }

    /// Adds a shape that occludes if it is closed.
    pub(crate) fn add_occluder(&mut self, body: Body, node: TreeNode) {
        self.occluders.add(body, node, None);
    }

    /// The ghost of a derivation that has ended, with the keys of its shapes.
    pub(crate) fn finish(self, keys: TreeKeys) -> Ghost {
        Ghost { labels: self.labels, occluders: self.occluders.finish(keys) }
    }
}
