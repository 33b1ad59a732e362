//! The conversion between slim and whole shapes.

use super::Env;
use crate::shape::base::Base;
use crate::shape::look_id::LookId;
use crate::shape::{Shape, ShapeRef};

impl Env {
    /// The whole form of a shape.
    #[cold]
    #[inline(never)]
    pub fn whole(&self, shape: &ShapeRef<'_>) -> Shape {
        self.leaf_tables.whole(shape)
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
