//! The tags of the components of a shape.

use std::sync::Arc;

use cga_split::tags::matches;

use super::{Geometry, Inserted, Placed, PlacedWire, Shape};
use crate::geometry::mesh::{Mesh, SubcomponentTags, TaggedComponents};

impl Shape {
    /// The tags of some components that a query matches, or all of them without a query, in any order.
    pub(crate) fn found_tags<'s>(
        &'s self,
        query: Option<&'s str>,
        components: TaggedComponents,
    ) -> impl Iterator<Item = &'s Arc<str>> {
        let (mesh, tags): (Option<&Mesh>, Option<&SubcomponentTags>) = match &self.geometry {
            Geometry::Empty | Geometry::Vertex | Geometry::Edge => (None, None),
            Geometry::Rect(_, unit) | Geometry::Box(unit) => (Some(unit.mesh()), None),
            Geometry::Mesh(placed) => (Some(&placed.mesh), Some(placed.mesh.subcomponent_tags())),
            Geometry::Wire(placed) => (None, Some(&placed.wire.tags)),
        };
        let faces = mesh.filter(|_| components.faces()).into_iter().flat_map(Mesh::face_tag_names);
        let names = faces.chain(tags.into_iter().flat_map(move |tags| tags.names(components)));
        names.filter(move |name| tag_query(query)(name))
    }

    /// Removes the tags of some components that a query matches, or all of them if there is no query. Boxes and rectangles stay
    /// such.
    pub(crate) fn remove_tags(&mut self, query: Option<&str>, components: TaggedComponents) {
        match &self.geometry {
            Geometry::Empty | Geometry::Vertex | Geometry::Edge => {}
            Geometry::Rect(axis, unit) if components.faces() => {
                self.geometry = Geometry::Rect(*axis, unit.without_tags(query));
            }
            Geometry::Box(unit) if components.faces() => self.geometry = Geometry::Box(unit.without_tags(query)),
            Geometry::Rect(..) | Geometry::Box(_) => {}
            Geometry::Mesh(placed) => {
                let mesh = Arc::new(placed.mesh.without_tags(&tag_query(query), components));
                let placed = Placed { mesh, inserted: Inserted::No, ..Placed::clone(placed) };
                self.geometry = Geometry::Mesh(Arc::new(placed));
            }
            Geometry::Wire(placed) => {
                let mut wire = placed.wire.clone();
                wire.tags = wire.tags.without(&tag_query(query), components);
                self.geometry = Geometry::Wire(Arc::new(PlacedWire { wire, ..PlacedWire::clone(placed) }));
            }
        }
    }
}

/// The question whether a query matches the name of a tag; without a query, all match.
pub(super) fn tag_query(query: Option<&str>) -> impl Fn(&str) -> bool {
    move |name| query.is_none_or(|query| matches(query, name))
}
