//! Tags of components, and tag queries (*Geometry tagging*).

use std::collections::BTreeMap;
use std::sync::Arc;

use cga_split::tags::matches;

use crate::value::text::Text;

/// The components whose tags are meant (*deleteTags operation*).
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
    pub(crate) fn faces(self) -> bool {
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
pub struct TagSet(Arc<[Text]>);

impl TagSet {
    /// A set of tags with the given names.
    pub fn new(names: impl IntoIterator<Item = Text>) -> Self {
        let mut names: Vec<Text> = names.into_iter().collect();
        names.sort_unstable();
        names.dedup();
        TagSet(names.into())
    }

    /// The names.
    pub fn names(&self) -> &[Text] {
        &self.0
    }

    /// Returns true if a query matches one of the tags.
    pub fn matches(&self, query: &str) -> bool {
        self.0.iter().any(|name| matches(query, name))
    }

    /// The tags of both sets.
    pub(crate) fn union(&self, other: &TagSet) -> Self {
        TagSet::new(self.0.iter().chain(&*other.0).cloned())
    }

    /// The tags and one more.
    pub(crate) fn with(&self, name: &Text) -> Self {
        TagSet::new(self.0.iter().chain([name]).cloned())
    }

    /// The tags without those that a query matches, or no tags without a query.
    pub(crate) fn without(&self, query: Option<&str>) -> Self {
        let Some(query) = query else { return TagSet::default() };
        TagSet::new(self.0.iter().filter(|name| !matches(query, name)).cloned())
    }

    /// The tags that a query matches, or all tags without a query.
    pub(crate) fn found<'s>(&'s self, query: Option<&'s str>) -> impl Iterator<Item = &'s Text> {
        self.0.iter().filter(move |name| query.is_none_or(|query| matches(query, name)))
    }

    /// The tags with a tag of an operation, such as `extrude.top`, in place of the other tags below its first word.
    pub(crate) fn renewed(&self, name: &str) -> Self {
        let operation = name.split('.').next();
        self.without(operation).with(&Text::from(name))
    }
}

/// Distinct sets of tags, numbered in the order of their first use.
#[derive(Clone, Debug, Default)]
pub(crate) struct TagSetTable {
    sets: Vec<TagSet>,
    numbers: BTreeMap<TagSet, u32>,
    /// The numbers of unions, by the numbers of both sets.
    unions: BTreeMap<[u32; 2], u32>,
}

impl TagSetTable {
    /// Returns true if it has no sets.
    pub(crate) fn is_empty(&self) -> bool {
        self.sets.is_empty()
    }

    /// The number of a set.
    pub(crate) fn number(&mut self, set: &TagSet) -> u32 {
        if let Some(number) = self.numbers.get(set) {
            return *number;
        }
        let number = self.sets.len() as u32;
        self.sets.push(set.clone());
        self.numbers.insert(set.clone(), number);
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
        let set = TagSet::new(["roof.top", "extrude.top", "roof.top"].map(Text::from));
        assert_eq!(set.names().len(), 2);
        let set = set.renewed("extrude.side.outer");
        assert!(set.matches("extrude.side") && set.matches("roof") && !set.matches("extrude.top"));
    }
}
