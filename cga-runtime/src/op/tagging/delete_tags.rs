//! `deleteTags`: removes tags of components.

use crate::geometry::mesh::TaggedComponents;
use crate::run::env::Env;
use crate::shape::{Geometry, Shape};
use crate::value::text::Text;

/// `deleteTags()`: removes all tags (*deleteTags operation*).
pub fn delete_tags(env: &mut Env, shape: &mut Shape) {
    delete(env, shape, None, TaggedComponents::All);
}

/// `deleteTags(tagQuery, all | faces | edges | vertices)`: removes the tags that a query matches from these components.
pub fn delete_tags_of(env: &mut Env, shape: &mut Shape, query: Text, components: TaggedComponents) {
    delete(env, shape, Some(query.as_str()), components);
}

fn delete(env: &mut Env, shape: &mut Shape, query: Option<&str>, components: TaggedComponents) {
    if shape.found_tags(query, components).next().is_none() {
        return;
    }
    if let Geometry::Mesh(placed) = &shape.geometry
        && env.count_vertices(&placed.mesh).is_break()
    {
        return;
    }
    shape.remove_tags(query, components);
}
