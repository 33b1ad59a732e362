//! The size of a run's buffers, before they are filled.

use std::ops::ControlFlow;
use std::sync::Arc;

use glam::DAffine3;

use crate::geometry::mesh::Mesh;
use crate::output::flatten::Flattener;
use crate::run::sink::{Cuboid, Filled, Flow, Leaf, Quad, Replay, Sink};

/// The number of vertices and indices that a run writes into [`Buffers`](super::Buffers).
/// [`Session::measure`](crate::grammar::session::Session::measure) finds it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct BufferSize {
    /// The number of leaves, also of leaves without faces.
    pub leaves: usize,
    /// The number of vertices. Faces share none.
    pub vertices: usize,
    /// The number of indices, three for each triangle.
    pub indices: usize,
}

/// Counts what buffers would hold.
#[derive(Default)]
pub(crate) struct Measuring {
    pub(crate) size: BufferSize,
    flattener: Flattener,
}

impl Measuring {
    /// Counts leaves whose faces have four corners each.
    fn quads(&mut self, leaves: usize, corners: usize) -> Flow {
        self.size.leaves += leaves;
        self.size.vertices += corners;
        self.size.indices += corners / 4 * 6;
        ControlFlow::Continue(())
    }
}

impl Sink for Measuring {
    fn filled(&mut self, leaf: &Filled<'_>) -> Flow {
        self.quads(1, 4 * leaf.shape.unit.get().face_count())
    }

    fn replay(&mut self, replay: &Replay<'_>) -> Flow {
        self.quads(replay.leaf_count(), replay.corner_count())
    }

    fn quad(&mut self, _: &Leaf<'_>, _: &Quad) -> Flow {
        self.quads(1, 4)
    }

    fn cuboid(&mut self, _: &Leaf<'_>, _: &Cuboid) -> Flow {
        self.quads(1, 24)
    }

    fn mesh(&mut self, _: &Leaf<'_>, mesh: &Arc<Mesh>, _: &DAffine3) -> Flow {
        let BufferSize { leaves, vertices, indices } = &mut self.size;
        *leaves += 1;
        *vertices += mesh.corners().len();
        self.flattener.whole(mesh, |flat| *indices += 3 * flat.triangle_count());
        ControlFlow::Continue(())
    }

    fn placement(&mut self, _: &Leaf<'_>) -> Flow {
        self.size.leaves += 1;
        ControlFlow::Continue(())
    }
}
