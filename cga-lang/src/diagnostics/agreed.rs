//! Findings that hold in every instance of a declaration.
//!
//! A file has an instance for each style and import, and a declaration for each further tuple of types. What the checks know
//! differs from instance to instance; what is reported of the text must hold in all of them.

use crate::diag::Diag;
use crate::resolve::globals::Item;
use std::collections::HashMap;
use std::collections::hash_map::Entry;

/// Findings by the name of the declaration they are about: those that all instances so far agree on.
#[derive(Default)]
pub(crate) struct Agreed {
    by_name: HashMap<u32, Vec<Diag>>,
}

impl Agreed {
    /// Returns true if some instance of a declaration has no findings: the others need no look.
    pub(crate) fn is_settled(&self, item: &Item) -> bool {
        self.by_name.get(&item.decl.name.id()).is_some_and(Vec::is_empty)
    }

    /// Adds the findings of one instance of a declaration.
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

    /// The findings that all instances agree on.
    pub(crate) fn finish(self) -> Vec<Diag> {
        self.by_name.into_values().flatten().collect()
    }
}
