//! The conversion between slim and whole shapes.

use std::sync::Arc;

use super::Env;
use crate::geometry::mesh::{Bounds, Mesh};
use crate::run::sink::Flow;
use crate::shape::base::Base;
use crate::shape::look::Look;
use crate::shape::look_id::LookId;
use crate::shape::scope::Scope;
use crate::shape::{Geometry, Shape, ShapeRef};

/// The units of work for reading a vertex of a mesh or a point of a path.
pub(crate) const READING: usize = 2;

impl Env {
    /// The whole form of a shape, for a step that reads or changes it. Its vertices count as work. A mesh is left out if the run
    /// has ended.
    #[cold]
    #[inline(never)]
    pub fn whole(&mut self, shape: &ShapeRef<'_>) -> Shape {
        let mut whole = self.leaf_tables.whole(shape);
        if let Geometry::Mesh(placed) = &whole.geometry
            && !self.reads(&placed.mesh)
        {
            // The next step that counts ends the run. Steps before it have nothing to do.
            whole.geometry = Geometry::Empty;
        }
        whole
    }

    /// Counts the vertices of a mesh that is read. Returns false if the run has ended.
    pub(crate) fn reads(&mut self, mesh: &Mesh) -> bool {
        let flow: Flow = self.spend(READING * mesh.corners().len());
        flow.is_continue() && !self.ended()
    }

    /// The base of a whole shape, for slim shapes.
    #[inline(never)]
    pub fn base(&mut self, shape: Shape) -> Base {
        let look = self.look_id(shape.state.look());
        Base::new(shape, look)
    }

    /// The number of the look of a base. The leaves of a template have one.
    pub(crate) fn look_id(&mut self, look: &Arc<Look>) -> LookId {
        let looks = &mut self.leaf_tables.looks;
        if self.checkpoint.measures_room() { looks.number_at_least_for_now(look) } else { looks.id(look) }
    }

    /// Keeps the box of a scope whose contents trim planes may cut, while a template is recorded.
    pub(crate) fn reach(&mut self, scope: &Scope) {
        if self.checkpoint.measures_room() {
            let bounds = Bounds::of(scope.corners());
            self.reach = Some(self.reach.unwrap_or(Bounds::EMPTY).union(bounds));
        }
    }
}
