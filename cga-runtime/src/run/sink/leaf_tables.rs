//! The names and looks of leaves, by number.

use std::sync::Arc;

use crate::shape::look::Look;
use crate::shape::look_table::LookTable;
use crate::shape::{Shape, ShapeRef};
use crate::value::text::Text;

/// The names and looks of a run's leaves, by number.
#[derive(Clone, Debug, Default)]
pub(crate) struct LeafTables {
    pub(crate) names: Arc<[Text]>,
    pub(crate) looks: LookTable,
}

impl LeafTables {
    /// The look of a shape.
    #[inline]
    pub(crate) fn look<'a>(&'a self, shape: &ShapeRef<'a>) -> &'a Arc<Look> {
        self.looks.get(shape.look.get()).unwrap_or(shape.base.shape.state.look())
    }

    /// The whole form of a shape.
    pub(crate) fn whole(&self, shape: &ShapeRef<'_>) -> Shape {
        let base = &shape.base.shape;
        let mut state = base.state.clone();
        if let Some(look) = self.looks.get(shape.look.get())
            && !Arc::ptr_eq(look, state.look())
        {
            state.change().look = look.clone();
        }
        Shape {
            scope: shape.scope(),
            pivot: base.pivot,
            geometry: shape.geometry(),
            seed: shape.seed.get(),
            split: shape.split.get(),
            comp: base.comp,
            selector: base.selector.clone(),
            trims: base.trims.clone(),
            state,
        }
    }
}
