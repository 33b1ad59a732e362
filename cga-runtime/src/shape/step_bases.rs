//! The bases that the steps of a rule make. Slim shapes borrow from them.

use std::cell::OnceCell;

use super::base::Base;

/// A list of bases. Bases are added while slim shapes borrow from others, and all live as long as the list.
#[derive(Debug, Default)]
pub struct Bases(OnceCell<Box<KeptBase>>);

#[derive(Debug)]
struct KeptBase {
    base: Base,
    rest: Bases,
}

impl Bases {
    /// An empty list.
    #[inline]
    pub const fn new() -> Self {
        Bases(OnceCell::new())
    }

    /// Adds a base at the end.
    pub fn keep(&self, base: Base) -> &Base {
        let mut end = self;
        while let Some(entry) = end.0.get() {
            end = &entry.rest;
        }
        &end.0.get_or_init(|| Box::new(KeptBase { base, rest: Bases::new() })).base
    }
}

impl Drop for Bases {
    /// Drops one base after the other: a rule may have any number of steps.
    #[inline(never)]
    fn drop(&mut self) {
        let mut next = self.0.take();
        while let Some(mut entry) = next {
            next = entry.rest.0.take();
        }
    }
}
