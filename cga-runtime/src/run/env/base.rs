//! The conversion between slim and whole shapes.

use super::Env;
use crate::run::sink::Flow;
use crate::shape::base::Base;
use crate::shape::look_id::LookId;
use crate::shape::{Geometry, Shape, ShapeRef};

/// The units of work of a vertex of a mesh that a step reads.
const READING: usize = 2;

impl Env {
    /// The whole form of a shape, for a step that reads or changes it. Its vertices count as work.
    #[cold]
    #[inline(never)]
    pub fn whole(&mut self, shape: &ShapeRef<'_>) -> Shape {
        let whole = self.leaf_tables.whole(shape);
        if let Geometry::Mesh(placed) = &whole.geometry {
            // The next step that counts ends the run.
            let _: Flow = self.spend(READING * placed.mesh.corners().len());
        }
        whole
    }

    /// The base of a whole shape, for slim shapes.
    #[inline(never)]
    pub fn base(&self, shape: Shape) -> Base {
        let look = self.leaf_tables.looks.id(shape.state.look());
        self.base_with_look(shape, look)
    }

    /// The base of a whole shape whose look has the number `look`; inlined.
    #[inline(always)]
    pub(crate) fn base_with_look(&self, shape: Shape, look: LookId) -> Base {
        self.bases.set(self.bases.get() + 1);
        Base::new(shape, look, self.bases.get())
    }
}
