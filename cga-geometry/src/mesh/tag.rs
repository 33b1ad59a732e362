//! Tags of components: names that operations give, keep and renew.

use crate::small_sort::sort_owned_by;
use std::cell::RefCell;
use std::collections::BTreeMap;
use std::sync::Arc;

/// The components whose tags are meant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TaggedComponents {
    /// All components.
    All,
    /// Faces.
    Faces,
    /// Edges.
    Edges,
    /// Vertices.
    Vertices,
}

impl TaggedComponents {
    /// Returns true if faces are meant.
    pub fn faces(self) -> bool {
        matches!(self, TaggedComponents::All | TaggedComponents::Faces)
    }

    /// Returns true if edges are meant.
    pub(crate) fn edges(self) -> bool {
        matches!(self, TaggedComponents::All | TaggedComponents::Edges)
    }

    /// Returns true if vertices are meant.
    pub(crate) fn vertices(self) -> bool {
        matches!(self, TaggedComponents::All | TaggedComponents::Vertices)
    }
}

/// The tags of a component, sorted and without duplicates. Names have parts, as in `extrude.side.outer`.
#[derive(Clone, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub struct TagSet(Arc<[Arc<str>]>);

impl TagSet {
    /// A set of tags with the given names.
    pub fn new<N: Into<Arc<str>>>(names: impl IntoIterator<Item = N>) -> Self {
        let mut names: Vec<Arc<str>> = names.into_iter().map(N::into).collect();
        sort_owned_by(&mut names, Ord::cmp);
        names.dedup();
        TagSet(names.into())
    }

    /// The names.
    pub fn names(&self) -> &[Arc<str>] {
        &self.0
    }

    /// Returns true if it has the tag with a name, or one below it: `roof` has `roof.side` below it.
    pub fn has(&self, name: &str) -> bool {
        self.0.iter().any(|own| is_below(own, name))
    }

    /// The tags of both sets.
    pub(crate) fn union(&self, other: &TagSet) -> Self {
        TagSet::new(self.0.iter().chain(&*other.0).cloned())
    }

    /// The tags and one more.
    pub(crate) fn with(&self, name: &str) -> Self {
        TagSet::new(self.0.iter().cloned().chain([name.into()]))
    }

    /// The tags except some.
    pub(crate) fn without(&self, goes: impl Fn(&str) -> bool) -> Self {
        TagSet::new(self.0.iter().filter(|name| !goes(name)).cloned())
    }

    /// The tags except one and all below it.
    pub(crate) fn without_below(&self, above: &str) -> Self {
        self.without(|name| is_below(name, above))
    }

    /// The one tag of an operation, such as `extrude.top`. Each thread makes it once.
    pub(crate) fn of_operation(name: &'static str) -> Self {
        thread_local! {
            static KNOWN: RefCell<Vec<(&'static str, TagSet)>> = const { RefCell::new(Vec::new()) };
        }
        KNOWN.with_borrow_mut(|known| match known.iter().find(|entry| entry.0 == name) {
            Some(entry) => entry.1.clone(),
            None => {
                let set = TagSet::new([name]);
                known.push((name, set.clone()));
                set
            }
        })
    }

    /// The tags with a tag of an operation, such as `extrude.top`, in place of the other tags below its first word.
    pub(crate) fn renewed(&self, name: &'static str) -> Self {
        let operation = name.split('.').next().unwrap_or_default();
        if self.0.iter().all(|own| is_below(own, operation)) {
            return TagSet::of_operation(name);
        }
        TagSet::new(self.0.iter().filter(|own| !is_below(own, operation)).cloned().chain([name.into()]))
    }
}

/// Returns true if a name is a tag or below it.
fn is_below(name: &str, above: &str) -> bool {
    name.strip_prefix(above).is_some_and(|rest| rest.is_empty() || rest.starts_with('.'))
}

/// Distinct sets of tags, numbered in the order of their first use.
#[derive(Clone, Debug, Default)]
pub(crate) struct TagSetTable {
    sets: Vec<TagSet>,
    /// The numbers of the sets, if they are more than [`FEW`](TagSetTable::FEW).
    numbers: BTreeMap<TagSet, u32>,
    /// The numbers of unions, by the numbers of both sets.
    unions: BTreeMap<[u32; 2], u32>,
}

impl TagSetTable {
    /// The number of sets up to which they are compared one by one.
    const FEW: usize = 8;

    /// Returns true if it has no sets.
    pub(crate) fn is_empty(&self) -> bool {
        self.sets.is_empty()
    }

    /// The number of a set.
    pub(crate) fn number(&mut self, set: &TagSet) -> u32 {
        let known = match self.sets.len() <= Self::FEW {
            true => self.sets.iter().position(|own| own == set).map(|at| at as u32),
            false => self.numbers.get(set).copied(),
        };
        known.unwrap_or_else(|| self.add(set.clone()))
    }

    /// Adds a set that is new.
    fn add(&mut self, set: TagSet) -> u32 {
        let number = self.sets.len() as u32;
        self.sets.push(set);
        if self.sets.len() == Self::FEW + 1 {
            self.numbers = self.sets.iter().cloned().zip(0..).collect();
        } else if Self::FEW < self.sets.len() {
            self.numbers.insert(self.sets[number as usize].clone(), number);
        }
        number
    }

    /// The number of the union of two sets.
    pub(crate) fn union(&mut self, a: u32, b: u32) -> u32 {
        if let Some(union) = self.unions.get(&[a, b]) {
            return *union;
        }
        let union = self.number(&self.sets[a as usize].union(&self.sets[b as usize]));
        self.unions.insert([a, b], union);
        union
    }

    /// The sets by number.
    pub(crate) fn into_sets(self) -> Arc<[TagSet]> {
        self.sets.into()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_set_is_renewed() {
        let set = TagSet::new(["roof.top", "extrude.top", "extrudes", "roof.top"]);
        assert_eq!(set.names().len(), 3);
        let set = set.renewed("extrude.side.outer");
        assert!(set.has("extrude.side") && set.has("roof") && set.has("extrudes") && !set.has("extrude.top"));
    }
}
