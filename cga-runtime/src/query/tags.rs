//! Tags of components (*geometry.tags*, *geometry.hasTags function*).

use std::collections::BTreeSet;
use std::sync::Arc;

use super::readable::may_read;
use crate::geometry::mesh::TaggedComponents;
use crate::run::env::Env;
use crate::shape::Shape;
use crate::value::array::Array;
use crate::value::text::Text;

/// `geometry.tags()`: the tags of all components, sorted.
pub fn geometry_tags(env: &mut Env, shape: &Shape) -> Array<Text> {
    sorted(env, found_tags(shape, None, TaggedComponents::All))
}

/// `geometry.tags(tagQuery, all | faces | edges | vertices)`: the tags of these components that a query matches, sorted.
pub fn geometry_tags_of(env: &mut Env, shape: &Shape, query: Text, components: TaggedComponents) -> Array<Text> {
    sorted(env, found_tags(shape, Some(&query), components))
}

/// `geometry.hasTags()`: whether a component has a tag.
pub fn geometry_has_tags(shape: &Shape) -> bool {
    found_tags(shape, None, TaggedComponents::All).next().is_some()
}

/// `geometry.hasTags(tagQuery, all | faces | edges | vertices)`: whether one of these components has a tag that a query
/// matches. Tags that a component inherits do not count.
pub fn geometry_has_tags_of(shape: &Shape, query: Text, components: TaggedComponents) -> bool {
    found_tags(shape, Some(&query), components).next().is_some()
}

/// The tags of components; without any if the run has ended.
fn found_tags<'s>(
    shape: &'s Shape,
    query: Option<&'s str>,
    components: TaggedComponents,
) -> impl Iterator<Item = &'s Arc<str>> {
    may_read(shape).then(|| shape.found_tags(query, components)).into_iter().flatten()
}

fn sorted<'t>(env: &mut Env, tags: impl Iterator<Item = &'t Arc<str>>) -> Array<Text> {
    let tags: BTreeSet<&Arc<str>> = tags.collect();
    if !env.may_hold(tags.len()) {
        return Array::default();
    }
    tags.into_iter().map(|tag| Text::from(tag.clone())).collect()
}
