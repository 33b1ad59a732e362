//! `deleteTags`: removes tags of components.

use std::sync::Arc;

use super::tag::retag;
use crate::geometry::mesh::TaggedComponents;
use crate::run::env::Env;
use crate::shape::{Geometry, PlacedWire, Shape};
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
    match &shape.geometry {
        Geometry::Rect(axis, unit) => shape.geometry = Geometry::Rect(*axis, unit.without_tags(query)),
        Geometry::Box(unit) => shape.geometry = Geometry::Box(unit.without_tags(query)),
        Geometry::Mesh(_) => retag(env, shape, |mesh| mesh.without_tags(query, components)),
        Geometry::Wire(placed) => {
            let mut wire = placed.wire.clone();
            wire.tags = wire.tags.without(query, components);
            shape.geometry = Geometry::Wire(Arc::new(PlacedWire { wire, ..PlacedWire::clone(placed) }));
        }
        Geometry::Empty | Geometry::Vertex | Geometry::Edge => {}
    }
}
