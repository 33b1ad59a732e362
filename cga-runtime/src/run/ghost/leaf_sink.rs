//! The leaves of a grammar that is written by hand, as a ghost. Such grammars have no tree of shapes and no labels.

use std::sync::Arc;

use glam::DAffine3;

use super::{Collect, Ghost, GhostBuilder};
use crate::geometry::mesh::Mesh;
use crate::run::sink::{Filled, Flow, Leaf, Sink};
use crate::run::tree_keys::{TreeKeys, TreeNode};
use crate::shape::Shape;
use crate::shape::body::Body;

/// Collects closed leaves.
#[derive(Debug)]
pub(crate) struct LeafGhost(GhostBuilder);

impl LeafGhost {
    pub(crate) fn new(collect: Collect) -> Self {
        LeafGhost(GhostBuilder::new(collect))
    }

    pub(crate) fn finish(self) -> Ghost {
        self.0.finish(TreeKeys::default())
    }

    fn add(&mut self, body: Body) -> Flow {
        if self.0.collect.occluders {
            self.0.add_occluder(body, TreeNode::default());
        }
        Flow::Continue(())
    }
}

impl Sink for LeafGhost {
    fn filled(&mut self, leaf: &Filled<'_>) -> Flow {
        self.add(Body::from(leaf.shape))
    }

    fn keep(&mut self, shape: &dyn Fn() -> Shape) -> Option<Flow> {
        Some(self.add(Body::from(&shape())))
    }

    fn mesh(&mut self, _: &Leaf<'_>, mesh: &Arc<Mesh>, placement: &DAffine3) -> Flow {
        self.add(Body::in_world(mesh.map(placement)))
    }
}
