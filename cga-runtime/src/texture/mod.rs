//! Texture space: how points of the world become texture coordinates, and which images materials show there.

pub(crate) mod builtin;
pub(crate) mod files;
pub(crate) mod layer;
pub(crate) mod leaf_uvs;
pub mod map;
pub(crate) mod source;
