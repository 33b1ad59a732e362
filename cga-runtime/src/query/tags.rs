//! Tags of components (*geometry.tags*, *geometry.hasTags function*).

use std::collections::BTreeSet;
use std::sync::Arc;

use crate::geometry::mesh::TaggedComponents;
use crate::shape::Shape;
use crate::value::array::Array;
use crate::value::text::Text;

/// `geometry.tags()`: the tags of all components, sorted.
pub fn geometry_tags(shape: &Shape) -> Array<Text> {
    sorted(shape.found_tags(None, TaggedComponents::All))
}

/// `geometry.tags(tagQuery, all | faces | edges | vertices)`: the tags of these components that a query matches, sorted.
pub fn geometry_tags_of(shape: &Shape, query: Text, components: TaggedComponents) -> Array<Text> {
    sorted(shape.found_tags(Some(&query), components))
}

/// `geometry.hasTags()`: whether a component has a tag.
pub fn geometry_has_tags(shape: &Shape) -> bool {
    shape.found_tags(None, TaggedComponents::All).next().is_some()
}

/// `geometry.hasTags(tagQuery, all | faces | edges | vertices)`: whether one of these components has a tag that a query
/// matches. Tags that a component inherits do not count.
pub fn geometry_has_tags_of(shape: &Shape, query: Text, components: TaggedComponents) -> bool {
    shape.found_tags(Some(&query), components).next().is_some()
}

fn sorted<'t>(tags: impl Iterator<Item = &'t Arc<str>>) -> Array<Text> {
    let tags: BTreeSet<&Arc<str>> = tags.collect();
    tags.into_iter().map(|tag| Text::from(tag.clone())).collect()
}
