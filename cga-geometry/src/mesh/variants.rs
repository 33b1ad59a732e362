//! Forms of a mesh that are made once, as a program may use the same mesh again and again.

use std::sync::{Arc, OnceLock};

use super::Mesh;
use crate::work;

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

impl Variants {
    /// Forgets all forms.
    pub(crate) fn forget(&mut self) {
        self.0.iter_mut().for_each(|form| _ = form.take());
    }
}

impl Mesh {
    /// A form of the mesh. If it was not made before, it is made now; `None` makes the mesh itself. A form that was made while the work is to
    /// end is not kept, as others may hold this mesh.
    pub fn variant(self: &Arc<Mesh>, variant: Variant, make: impl FnOnce(&Mesh) -> Option<Mesh>) -> Arc<Mesh> {
        let Variants(made) = &self.derived.variants;
        let slot = &made[variant as usize];
        if let Some(known) = slot.get() {
            return known.as_ref().unwrap_or(self).clone();
        }
        let form = make(self).map(Arc::new);
        match work::spend(0) {
            true => slot.get_or_init(|| form).as_ref().unwrap_or(self).clone(),
            false => form.unwrap_or_else(|| self.clone()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::primitive::cube;
    use crate::work::Supervisor;

    #[test]
    fn a_form_of_a_run_that_has_ended_is_not_kept() {
        let mesh = Arc::new(cube());
        let ended = |mesh: &Mesh| {
            assert!(!work::ask());
            Some(mesh.clone())
        };
        {
            let _supervisor = Supervisor::new(|_| false);
            let early = mesh.variant(Variant::Cleaned, ended);
            assert!(!Arc::ptr_eq(&early, &mesh));
        }
        assert!(Arc::ptr_eq(&mesh.variant(Variant::Cleaned, |_| None), &mesh));
        // The first form that is kept stays.
        assert!(Arc::ptr_eq(&mesh.variant(Variant::Cleaned, |mesh| Some(mesh.clone())), &mesh));
    }
}
