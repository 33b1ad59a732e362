//! Operations on materials and texture coordinates.

pub(crate) mod material;
pub(crate) mod texture;
