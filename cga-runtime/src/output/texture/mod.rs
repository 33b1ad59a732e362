//! Textures of leaves: their coordinates and their images.

pub(crate) mod leaf_uvs;
pub(crate) mod source;
