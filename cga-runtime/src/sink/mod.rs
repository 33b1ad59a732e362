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

use glam::{DAffine3, DMat3, DVec3};

use crate::material::Material;
use crate::mesh::Mesh;
use crate::scope::Scope;

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

/// A flat rectangle: corners `origin`, `origin + u`, `origin + u + v`, `origin + v`, counter-clockwise seen from
/// where `u × v` points. A side may have length zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quad {
    /// First corner, in the world.
    pub origin: DVec3,
    /// First side.
    pub u: DVec3,
    /// Last side, from the origin.
    pub v: DVec3,
}

impl Quad {
    /// The four corners, counter-clockwise.
    pub fn corners(&self) -> [DVec3; 4] {
        [self.origin, self.origin + self.u, self.origin + self.u + self.v, self.origin + self.v]
    }
}

/// A closed box: `origin` and three edges. When `sides` is left-handed (a negative scope size) its faces look inwards.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cuboid {
    /// The corner at (0, 0, 0), in the world.
    pub origin: DVec3,
    /// The three edges from it, as columns; orthogonal, not unit.
    pub sides: DMat3,
}

impl Cuboid {
    /// The six faces: front, right, back, left (counter-clockwise seen from above), top, bottom.
    pub fn faces(&self) -> [Quad; 6] {
        let (o, [x, y, z]) = (self.origin, [self.sides.x_axis, self.sides.y_axis, self.sides.z_axis]);
        [
            Quad { origin: o + z, u: x, v: y },
            Quad { origin: o + z + x, u: -z, v: y },
            Quad { origin: o + x, u: -x, v: y },
            Quad { origin: o, u: z, v: y },
            Quad { origin: o + z + y, u: x, v: -z },
            Quad { origin: o, u: x, v: z },
        ]
    }
}

/// Takes the leaves of a run. Only [`Sink::mesh`] must be written; the others turn their geometry into a mesh by default.
pub trait Sink {
    /// A rectangle.
    fn quad(&mut self, leaf: &Leaf<'_>, quad: &Quad) -> Flow {
        self.mesh(leaf, &Arc::new(Mesh::from_quad(quad)), &DAffine3::IDENTITY)
    }

    /// A box.
    fn cuboid(&mut self, leaf: &Leaf<'_>, cuboid: &Cuboid) -> Flow {
        self.mesh(leaf, &Arc::new(Mesh::from_cuboid(cuboid)), &DAffine3::IDENTITY)
    }

    /// An inserted asset that nothing has cut since: the same mesh many times, each with a placement of its own.
    fn instance(&mut self, leaf: &Leaf<'_>, mesh: &Arc<Mesh>, placement: &DAffine3) -> Flow {
        self.mesh(leaf, mesh, placement)
    }

    /// Any mesh, in local coordinates; `placement` takes them to the world.
    fn mesh(&mut self, leaf: &Leaf<'_>, mesh: &Arc<Mesh>, placement: &DAffine3) -> Flow;
}
