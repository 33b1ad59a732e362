//! The closed shapes of a ghost (*occlusion queries*).

use std::sync::OnceLock;

use super::relation::{Occluders, Relation};
use crate::geometry::mesh::Mesh;
use crate::run::tree_keys::{TreeKeys, TreeNode};
use crate::shape::body::Body;
use crate::value::text::Text;

/// Closed shapes in order, while a derivation collects them.
#[derive(Debug, Default)]
pub(crate) struct OccluderList {
    list: Vec<Occluder>,
}

/// A closed shape.
#[derive(Debug)]
struct Occluder {
    body: Body,
    label: Option<Text>,
    /// The shape of the tree that it is, or whose rule has made it.
    node: TreeNode,
}

impl OccluderList {
    /// Adds a shape if it is closed.
    pub(super) fn add(&mut self, body: Body, node: TreeNode, label: Option<Text>) {
        if body.is_closed() {
            self.list.push(Occluder { body, label, node });
        }
    }

    pub(super) fn finish(self, keys: TreeKeys) -> GhostOccluders {
        GhostOccluders { list: self.list, keys, solids: OnceLock::new() }
    }
}

/// The closed shapes of a derivation, with the places that they have in its tree.
#[derive(Debug, Default)]
pub(crate) struct GhostOccluders {
    list: Vec<Occluder>,
    keys: TreeKeys,
    /// The shapes as meshes, made at the first query.
    solids: OnceLock<Occluders>,
}

impl GhostOccluders {
    /// The relation of a mesh in the world to the shapes with a label, or to all shapes without one. `key` is the place of the query in its
    /// own tree, if this is a derivation of the same initial shape: its ancestors and descendants are left out.
    pub(crate) fn relation(&self, query: &Mesh, label: Option<&str>, key: Option<&[u32]>) -> Relation {
        if self.list.is_empty() {
            return Relation::default();
        }
        let meshes = || self.list.iter().filter_map(|occluder| occluder.body.world_mesh());
        let solids = self.solids.get_or_init(|| Occluders::new(meshes().collect()));
        solids.query(query, &mut |number| {
            let Occluder { label: own, node, .. } = &self.list[number as usize];
            label.is_none_or(|label| own.as_deref() == Some(label))
                && !key.is_some_and(|key| self.keys.is_in_line(*node, key))
        })
    }
}
