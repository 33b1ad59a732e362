//! Where leaves go.
//!
//! A run hands every leaf shape to a [`Sink`] as soon as it is known, in an order that depends on the rules alone.
//! A sink may end the run by returning `ControlFlow::Break(())`.

pub mod buffers;
pub mod error;
pub(crate) mod flatten;
#[cfg(feature = "gltf")]
pub mod gltf;
pub(crate) mod measure;
pub(crate) mod number;
pub mod obj;
pub(crate) mod order;
pub mod picture;
pub mod stats;
pub mod svg;
pub mod table;

use std::ops::ControlFlow;
use std::sync::Arc;

use glam::DAffine3;

use crate::material::Material;
use crate::mesh::Mesh;
use crate::scope::Scope;

pub use crate::place::{Cuboid, Quad};

/// Go on, or stop the run.
pub type Flow = ControlFlow<()>;

/// What is known of a leaf besides its geometry.
#[derive(Clone, Copy, Debug)]
pub struct Leaf<'a> {
    /// The name of the rule or leaf symbol, without the dot. One address a name within a grammar.
    pub rule: &'static str,
    /// What the rules set; what it leaves unset comes from the mesh's own material or is the default.
    pub material: &'a Arc<Material>,
    /// The leaf's scope, in the world.
    pub scope: &'a Scope,
}

/// Takes the leaves of a run. Only [`Sink::mesh`] must be written; the others turn their geometry into a mesh by default.
pub trait Sink {
    /// A rectangle.
    fn quad(&mut self, leaf: &Leaf<'_>, quad: &Quad) -> Flow {
        self.mesh(leaf, &Arc::new(quad.to_mesh()), &DAffine3::IDENTITY)
    }

    /// A box.
    fn cuboid(&mut self, leaf: &Leaf<'_>, cuboid: &Cuboid) -> Flow {
        self.mesh(leaf, &Arc::new(cuboid.to_mesh()), &DAffine3::IDENTITY)
    }

    /// An inserted asset that nothing has cut since: the same mesh many times, each with a placement of its own.
    fn instance(&mut self, leaf: &Leaf<'_>, mesh: &Arc<Mesh>, placement: &DAffine3) -> Flow {
        self.mesh(leaf, mesh, placement)
    }

    /// Any mesh, in local coordinates; `placement` takes them to the world.
    fn mesh(&mut self, leaf: &Leaf<'_>, mesh: &Arc<Mesh>, placement: &DAffine3) -> Flow;

    /// Hands on what the sink still holds. There are no more leaves after it.
    ///
    /// The owner of a sink calls it, once, after the last run: the same sink may take the leaves of many runs, so a run never
    /// calls it. [`parallel`](crate::parallel) owns the sinks of its stretches and finishes each, unless a run ended with an
    /// error. `Break` ends what the owner would do next.
    fn finish(&mut self) -> Flow {
        Flow::Continue(())
    }
}
