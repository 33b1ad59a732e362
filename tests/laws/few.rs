//! Sinks of the harness.

use std::ops::ControlFlow;
use std::sync::Arc;

use cga::glam::DAffine3;
use cga::sink::Replay;
use cga::{Cuboid, Flow, Leaf, Mesh, Model, Quad, Sink};

/// Leaves after which a run is stopped.
const MOST_LEAVES: usize = 200;

/// A model that takes some leaves only.
pub(crate) struct Few {
    pub(crate) model: Model,
}

impl Few {
    pub(crate) fn new() -> Self {
        Few { model: Model::new() }
    }

    fn go_on(&self) -> Flow {
        if self.model.len() < MOST_LEAVES { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
    }
}

impl Sink for Few {
    fn quad(&mut self, leaf: &Leaf<'_>, quad: &Quad) -> Flow {
        self.model.quad(leaf, quad)?;
        self.go_on()
    }

    fn cuboid(&mut self, leaf: &Leaf<'_>, cuboid: &Cuboid) -> Flow {
        self.model.cuboid(leaf, cuboid)?;
        self.go_on()
    }

    fn instance(&mut self, leaf: &Leaf<'_>, mesh: &Arc<Mesh>, placement: &DAffine3) -> Flow {
        self.model.instance(leaf, mesh, placement)?;
        self.go_on()
    }

    fn mesh(&mut self, leaf: &Leaf<'_>, mesh: &Arc<Mesh>, placement: &DAffine3) -> Flow {
        self.model.mesh(leaf, mesh, placement)?;
        self.go_on()
    }

    fn placement(&mut self, leaf: &Leaf<'_>) -> Flow {
        self.model.placement(leaf)?;
        self.go_on()
    }
}

/// Counts the leaves that come from templates.
#[derive(Default)]
pub(crate) struct Replayed {
    pub(crate) leaves: usize,
}

impl Sink for Replayed {
    fn replay(&mut self, replay: &Replay<'_>) -> Flow {
        self.leaves += replay.leaf_count();
        ControlFlow::Continue(())
    }

    fn mesh(&mut self, _: &Leaf<'_>, _: &Arc<Mesh>, _: &DAffine3) -> Flow {
        ControlFlow::Continue(())
    }
}
