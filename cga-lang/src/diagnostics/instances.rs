//! Diagnostics that hold in every instance of a declaration.
//!
//! A file has an instance for each style and import, and a declaration for each further tuple of types. The known
//! facts differ between instances; a diagnostic about the text must hold in all of them.

use crate::diag::{Diag, Diags};
use crate::resolve::globals::Declared;
use std::collections::HashMap;
use std::collections::hash_map::Entry;

/// The diagnostics that all instances so far agree on, by the name of the declaration they are about.
#[derive(Default)]
pub(crate) struct CommonDiags {
    by_name: HashMap<u32, Vec<Diag>>,
}

impl CommonDiags {
    /// Checks an instance of a declaration. Once an instance has no diagnostics, the remaining ones need no check.
    pub(crate) fn check(&mut self, item: &Declared, check: impl FnOnce(&mut Diags)) {
        let known = self.by_name.entry(item.decl.name.id());
        if matches!(&known, Entry::Occupied(known) if known.get().is_empty()) {
            return;
        }
        let mut diags = Diags::new();
        check(&mut diags);
        let mut list = diags.finish();
        match known {
            Entry::Vacant(entry) => _ = entry.insert(list),
            Entry::Occupied(mut entry) => {
                let same = |a: &Diag, b: &Diag| a.code == b.code && a.span == b.span;
                list.retain(|diag| entry.get().iter().any(|other| same(diag, other)));
                entry.insert(list);
            }
        }
    }

    /// The diagnostics that all instances agree on.
    pub(crate) fn finish(self) -> Vec<Diag> {
        self.by_name.into_values().flatten().collect()
    }
}
