//! Operations that put other geometry in the place of the current one.

pub(crate) mod along_uv;
pub(crate) mod envelope;
pub(crate) mod extrude;
pub(crate) mod footprint;
pub(crate) mod insert;
pub(crate) mod insert_fit;
pub(crate) mod primitive;
pub(crate) mod reset_geometry;
pub(crate) mod roof;
pub(crate) mod scatter;
pub(crate) mod taper;
pub(crate) mod trim;
