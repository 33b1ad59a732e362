//! The closed shapes of a ghost (*occlusion queries*).

use std::sync::OnceLock;

use super::body;
use super::near::OcclusionQuery;
use crate::geometry::relation::Occluders;
use crate::run::tree_keys::{Kinship, Place, TreeKeys, TreeNode};
use crate::shape::body::Body;
use crate::value::text::Text;

/// Closed shapes in order, while a derivation collects them.
#[derive(Debug, Default)]
pub(crate) struct OccluderList {
    list: Vec<GhostOccluder>,
}

/// A closed shape.
#[derive(Debug)]
struct GhostOccluder {
    body: Body,
    label: Option<Text>,
    /// The shape of the tree that it is, or whose rule has made it.
    node: TreeNode,
}

impl OccluderList {
    /// Adds a shape if it is closed.
    pub(super) fn add(&mut self, body: Body, node: TreeNode, label: Option<Text>) {
        if body.is_closed() {
            self.list.push(GhostOccluder { body, label, node });
        }
    }

    pub(super) fn finish(self, keys: TreeKeys) -> GhostOccluders {
        GhostOccluders { list: self.list, keys, solids: OnceLock::new() }
    }
}

/// The closed shapes of a derivation, with the places that they have in its tree.
#[derive(Debug, Default)]
pub(crate) struct GhostOccluders {
    list: Vec<GhostOccluder>,
    keys: TreeKeys,
    /// The shapes as solids, made at the first query.
    solids: OnceLock<Occluders>,
}

impl GhostOccluders {
    /// Drops the places in the tree. No query passes a key from now on.
    pub(super) fn forget_keys(&mut self) {
        self.keys = TreeKeys::default();
        self.list.iter_mut().for_each(|occluder| occluder.node = TreeNode::default());
    }

    /// Returns true if no shape is closed.
    pub(super) fn is_empty(&self) -> bool {
        self.list.is_empty()
    }

    /// The shapes as solids.
    #[inline]
    pub(super) fn solids(&self) -> &Occluders {
        let occluders = || Occluders::new(self.list.iter().filter_map(|occluder| body::occluder(&occluder.body)));
        self.solids.get_or_init(occluders)
    }

    /// The kinship of a shape with the place of a query in its own tree.
    pub(super) fn kinship(&self, number: u32, place: Place<'_>) -> Kinship {
        self.keys.kinship(self.list[number as usize].node, place)
    }

    /// Returns true if a shape counts for a query: it has the label, if there is one, and is neither an ancestor nor a descendant of the place of
    /// the query, if that is a place in the tree of the same initial shape.
    pub(super) fn counts(&self, number: u32, query: OcclusionQuery<'_>) -> bool {
        query.label.is_none_or(|label| self.list[number as usize].label.as_deref() == Some(label))
            && query.place.is_none_or(|place| matches!(self.kinship(number, place), Kinship::Beside(_)))
    }
}
