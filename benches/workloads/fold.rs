//! A sink without storage, for the cost of terminals without buffers.

use std::hint::black_box;
use std::sync::Arc;

use cga::glam::DAffine3;
use cga::{Cuboid, Flow, Leaf, Mesh, Quad, Sink};

/// Folds every leaf into a number.
#[derive(Default)]
pub(crate) struct Fold {
    pub(crate) leaves: u64,
    pub(crate) sum: f64,
}

impl Sink for Fold {
    #[inline]
    fn quad(&mut self, _: &Leaf<'_>, quad: &Quad) -> Flow {
        self.leaves += 1;
        self.sum += black_box(quad.origin.x + quad.u.x + quad.v.y);
        Flow::Continue(())
    }

    #[inline]
    fn cuboid(&mut self, _: &Leaf<'_>, cuboid: &Cuboid) -> Flow {
        self.leaves += 1;
        self.sum += black_box(cuboid.origin.x + cuboid.sides.x_axis.x);
        Flow::Continue(())
    }

    fn mesh(&mut self, _: &Leaf<'_>, mesh: &Arc<Mesh>, _: &DAffine3) -> Flow {
        self.leaves += 1;
        self.sum += black_box(mesh.points().len() as f64);
        Flow::Continue(())
    }
}
