//! Findings that hold in every instance of a declaration.
//!
//! A file has an instance for each style and import, and a declaration for each further tuple of types. What the checks know
//! differs from instance to instance; what is reported of the text must hold in all of them.

use crate::diag::Diag;
use crate::resolve::globals::Item;
use std::collections::HashMap;

/// Findings by the declaration they are about.
#[derive(Default)]
pub(crate) struct Agreed {
    by_name: HashMap<u32, Vec<Vec<Diag>>>,
}

impl Agreed {
    /// Adds the findings of one instance of a declaration.
    pub(crate) fn add(&mut self, item: &Item, list: Vec<Diag>) {
        self.by_name.entry(item.decl.name.id()).or_default().push(list);
    }

    /// The findings that all instances agree on.
    pub(crate) fn finish(self) -> Vec<Diag> {
        let same = |a: &Diag, b: &Diag| a.code == b.code && a.span == b.span;
        let mut all = Vec::new();
        for mut instances in self.by_name.into_values() {
            let Some(first) = instances.pop() else { continue };
            let in_all = |diag: &Diag| instances.iter().all(|others| others.iter().any(|other| same(diag, other)));
            all.extend(first.into_iter().filter(in_all));
        }
        all
    }
}
