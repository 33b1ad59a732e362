//! Operations that divide faces in their planes.

pub(crate) mod delete_holes;
pub(crate) mod inner_rectangle;
pub(crate) mod offset;
pub(crate) mod perimeter;
pub(crate) mod refused;
pub(crate) mod setback;
pub(crate) mod setback_to_area;
pub(crate) mod shape_l;
pub(crate) mod shape_o;
pub(crate) mod shape_u;
pub(crate) mod swept_edges;
