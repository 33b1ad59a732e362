//! Diagnostics that hold in every instance of a declaration.
//!
//! A file has an instance for each style and import, and a declaration for each further tuple of types. The known
//! facts differ between instances; a diagnostic about the text must hold in all of them.

use crate::diag::Diag;
use crate::resolve::globals::Item;
use std::collections::HashMap;
use std::collections::hash_map::Entry;

/// The diagnostics that all instances so far agree on, by the name of the declaration they are about.
#[derive(Default)]
pub(crate) struct Agreed {
    by_name: HashMap<u32, Vec<Diag>>,
}

impl Agreed {
    /// Returns true if some instance of a declaration has no diagnostics. The remaining instances need no check.
    pub(crate) fn is_settled(&self, item: &Item) -> bool {
        self.by_name.get(&item.decl.name.id()).is_some_and(Vec::is_empty)
    }

    /// Adds the diagnostics of one instance of a declaration.
    pub(crate) fn add(&mut self, item: &Item, mut list: Vec<Diag>) {
        let same = |a: &Diag, b: &Diag| a.code == b.code && a.span == b.span;
        match self.by_name.entry(item.decl.name.id()) {
            Entry::Vacant(entry) => _ = entry.insert(list),
            Entry::Occupied(mut entry) => {
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
