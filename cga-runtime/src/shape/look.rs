//! The look of a leaf: its material and its texture coordinates.

use std::sync::Arc;

use crate::material::Material;
use crate::shape::texture::Coordinates;

/// The material and the implicit texture coordinates set by rules. Operations with constant arguments change them, so
/// few looks serve many leaves.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Look {
    pub(crate) material: Arc<Material>,
    pub(crate) coordinates: Coordinates,
}
