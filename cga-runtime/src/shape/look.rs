//! The look of a leaf: its material and its texture coordinates.

use std::sync::Arc;

use crate::material::Material;
use crate::shape::texture::Coordinates;

/// The material and the implicit texture coordinates that rules gave. Both change by operations with constant arguments, so that
/// few looks serve many leaves.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Look {
    pub(crate) material: Arc<Material>,
    pub(crate) coordinates: Coordinates,
}
