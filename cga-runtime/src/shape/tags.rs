//! The tags of the components of a shape.

use super::{Geometry, Shape};
use crate::geometry::mesh::{Mesh, SubcomponentTags, TaggedComponents};
use crate::value::text::Text;

impl Shape {
    /// The tags of some components that a query matches, or all of them without a query, in any order.
    pub(crate) fn found_tags<'s>(
        &'s self,
        query: Option<&'s str>,
        components: TaggedComponents,
    ) -> impl Iterator<Item = &'s Text> {
        let (mesh, tags): (Option<&Mesh>, Option<&SubcomponentTags>) = match &self.geometry {
            Geometry::Empty | Geometry::Vertex | Geometry::Edge => (None, None),
            Geometry::Rect(_, unit) | Geometry::Box(unit) => (Some(unit.mesh()), None),
            Geometry::Mesh(placed) => (Some(&placed.mesh), Some(&placed.mesh.subcomponent_tags)),
            Geometry::Wire(placed) => (None, Some(&placed.wire.tags)),
        };
        let faces = mesh.filter(|_| components.faces()).into_iter().flat_map(move |mesh| mesh.found_face_tags(query));
        faces.chain(tags.into_iter().flat_map(move |tags| tags.found(query, components)))
    }
}
