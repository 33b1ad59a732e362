//! The look of a leaf: its material and its texture coordinates.

use std::hash::Hasher;
use std::sync::Arc;

use crate::fixed_hash::FixedHasher;
use crate::material::Material;
use crate::shape::texture::Coordinates;

/// The material and the implicit texture coordinates set by rules. Operations with constant arguments change them, so
/// few looks serve many leaves.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Look {
    pub(crate) material: Arc<Material>,
    pub(crate) coordinates: Coordinates,
}

impl Look {
    /// A hash; equal looks have equal ones, except for the sign of zero.
    pub(crate) fn hash(&self) -> u64 {
        let mut hasher = FixedHasher::default();
        self.material.hash(&mut hasher);
        self.coordinates.hash(&mut hasher);
        hasher.finish()
    }
}
