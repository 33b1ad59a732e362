//! Texture space: how points of the world become texture coordinates.

pub(crate) mod leaf_uvs;
pub mod map;
