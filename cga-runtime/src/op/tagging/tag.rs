//! `tag`: gives components a tag.

use std::sync::Arc;

use cga_split::tags::{self, WILDCARDS};

use crate::fault::FaultKind;
use crate::run::env::Env;
use crate::shape::{Geometry, Inserted, Placed, PlacedWire, Shape};
use crate::value::text::Text;

/// The components that get a tag.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TagTarget {
    /// The components of the highest dimension: faces; without faces edges; without edges vertices.
    Auto,
    /// Faces.
    Faces,
    /// Edges.
    Edges,
    /// Vertices.
    Vertices,
}

/// `tag(name, auto | faces | edges | vertices)`: gives all these components a tag (*tag operation*). The wildcards of queries
/// are left out of the name; a name without other characters leaves a fault and tags nothing.
pub fn tag(env: &mut Env, shape: &mut Shape, name: Text, target: TagTarget) {
    let name = tag_name(&name);
    if name.is_empty() {
        env.fault(FaultKind::Value, "the name of `tag` has no characters except wildcards; nothing is tagged");
        return;
    }
    let has_edges = match &shape.geometry {
        Geometry::Empty => return,
        Geometry::Edge => true,
        Geometry::Vertex => false,
        Geometry::Wire(placed) => !placed.wire.edges.is_empty(),
        Geometry::Rect(..) | Geometry::Box(_) | Geometry::Mesh(_) => return tag_mesh(env, shape, &name, target),
    };
    if target == TagTarget::Faces || (target == TagTarget::Edges && !has_edges) {
        return;
    }
    shape.hold_as_points();
    let Geometry::Wire(placed) = &shape.geometry else { return };
    let mut wire = placed.wire.clone();
    wire.tags = match target {
        TagTarget::Edges => wire.tags.with_edges(wire.edges.iter().copied(), &name),
        TagTarget::Auto if has_edges => wire.tags.with_edges(wire.edges.iter().copied(), &name),
        _ => wire.tags.with_vertices(wire.points.len(), &name),
    };
    shape.geometry = Geometry::Wire(Arc::new(PlacedWire { wire, ..PlacedWire::clone(placed) }));
}

fn tag_mesh(env: &mut Env, shape: &mut Shape, name: &Text, target: TagTarget) {
    shape.hold_as_mesh();
    let Geometry::Mesh(placed) = &shape.geometry else { return };
    if env.count_vertices(&placed.mesh).is_break() {
        return;
    }
    let mesh = Arc::new(match target {
        TagTarget::Auto | TagTarget::Faces => placed.mesh.with_tagged_faces(name),
        TagTarget::Edges => placed.mesh.with_tagged_edges(name),
        TagTarget::Vertices => placed.mesh.with_tagged_vertices(name),
    });
    // A tagged geometry differs from the asset that it was.
    shape.geometry = Geometry::Mesh(Arc::new(Placed { mesh, inserted: Inserted::No, ..Placed::clone(placed) }));
}

/// The name of a tag: text without the wildcards of queries.
pub(in crate::op) fn tag_name(name: &Text) -> Text {
    if name.contains(WILDCARDS) { Text::from(tags::name(name)) } else { name.clone() }
}

#[cfg(test)]
mod tests;
