//! Forms of a mesh that are made once, as a program may use the same mesh again and again.

use std::sync::{Arc, OnceLock};

use super::Mesh;

/// A form of a mesh.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Variant {
    /// Without very short edges.
    Cleaned,
    /// With its z axis turned up.
    Raised,
    /// With its faces turned over.
    Reversed,
}

/// The forms that were made. `None` for a form that is the mesh itself.
#[derive(Debug, Default)]
pub(crate) struct Variants([OnceLock<Option<Arc<Mesh>>>; 3]);

/// A copy is about to be changed, so it has no forms yet.
impl Clone for Variants {
    fn clone(&self) -> Self {
        Variants::default()
    }
}

impl Mesh {
    /// A form of the mesh. If it was not made before, it is made now; `None` makes the mesh itself.
    pub fn variant(self: &Arc<Mesh>, variant: Variant, make: impl FnOnce(&Mesh) -> Option<Mesh>) -> Arc<Mesh> {
        let Variants(made) = &self.derived.variants;
        made[variant as usize].get_or_init(|| make(self).map(Arc::new)).as_ref().unwrap_or(self).clone()
    }
}
