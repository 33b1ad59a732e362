//! The closed shapes of a ghost (*occlusion queries*).

use std::sync::OnceLock;

use super::body;
use crate::geometry::relation::{Occluders, QueryGeometry, Relation};
use crate::run::tree_keys::{Place, TreeKeys, TreeNode};
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

    /// The wanted answers for a geometry, among the shapes with a label, or among all shapes without one. `place` is the place of the query in
    /// its own tree, if this is a derivation of the same initial shape: its ancestors and descendants are left out.
    pub(crate) fn relation(
        &self,
        query: &QueryGeometry<'_>,
        wanted: Relation,
        label: Option<&str>,
        place: Option<Place<'_>>,
    ) -> Relation {
        if self.list.is_empty() {
            return Relation::NONE;
        }
        let occluders = || Occluders::new(self.list.iter().filter_map(|occluder| body::occluder(&occluder.body)));
        let solids = self.solids.get_or_init(occluders);
        solids.query(query, wanted, &mut |number| self.counts(number, label, place))
    }

    /// Returns true if a shape counts for a query with a label and a place.
    fn counts(&self, number: u32, label: Option<&str>, place: Option<Place<'_>>) -> bool {
        let GhostOccluder { label: own, node, .. } = &self.list[number as usize];
        label.is_none_or(|label| own.as_deref() == Some(label))
            && !place.is_some_and(|place| self.keys.is_in_line(*node, place))
    }
}
