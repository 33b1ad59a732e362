//! Operations that change the scope and the pivot.

pub(crate) mod align;
pub(crate) mod align_box;
pub(crate) mod align_geometry;
pub(crate) mod coordinates;
pub(crate) mod new_axes;
pub(crate) mod pivot;
pub(crate) mod transform;
