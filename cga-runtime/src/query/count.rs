//! Numbers of vertices, edges, faces and holes; the names of groups and materials.

use crate::geometry::mesh::{FaceTag, Mesh};
use crate::run::env::Env;
use crate::shape::{Geometry, Shape};
use crate::value::array::Array;
use crate::value::text::Text;

/// `geometry.nVertices()` (*geometry.nVertices function*): a shared vertex counts once.
pub fn geometry_n_vertices(shape: &Shape) -> f64 {
    match &shape.geometry {
        Geometry::Empty => 0.0,
        Geometry::Vertex => 1.0,
        Geometry::Edge => 2.0,
        Geometry::Wire(placed) => placed.wire.points.len() as f64,
        Geometry::Rect(..) => 4.0,
        Geometry::Box(_) => 8.0,
        Geometry::Mesh(placed) => placed.mesh.points().len() as f64,
    }
}

/// `geometry.nFaces()` (*geometry.nFaces function*).
pub fn geometry_n_faces(shape: &Shape) -> f64 {
    match &shape.geometry {
        Geometry::Empty | Geometry::Vertex | Geometry::Edge | Geometry::Wire(_) => 0.0,
        Geometry::Rect(..) => 1.0,
        Geometry::Box(_) => 6.0,
        Geometry::Mesh(placed) => placed.mesh.face_count() as f64,
    }
}

/// `geometry.nEdges()` (*geometry.nEdges function*): a shared edge counts once.
pub fn geometry_n_edges(shape: &Shape) -> f64 {
    match &shape.geometry {
        Geometry::Empty | Geometry::Vertex => 0.0,
        Geometry::Edge => 1.0,
        Geometry::Wire(placed) => placed.wire.edges.len() as f64,
        Geometry::Rect(..) => 4.0,
        Geometry::Box(_) => 12.0,
        Geometry::Mesh(placed) => placed.mesh.adjacency().edge_count() as f64,
    }
}

/// `geometry.nHoles()`: the number of holes in faces (*geometry.nHoles function*).
pub fn geometry_n_holes(shape: &Shape) -> f64 {
    match &shape.geometry {
        Geometry::Mesh(placed) => placed.mesh.faces().map(|face| face.holes().len()).sum::<usize>() as f64,
        _ => 0.0,
    }
}

/// `geometry.groups()`: the names of the groups that have faces, in their order; faces without a group come last
/// (*geometry.groups function*). Such faces of the initial shape have its name (*CGA changelog 2021.0*), inserted
/// ones an empty name.
pub fn geometry_groups(env: &Env, shape: &Shape) -> Array<Text> {
    let is_foreign = shape.state.get().is_some_and(|state| state.foreign);
    let nameless = if is_foreign { Text::default() } else { env.initial.name.clone() };
    names(shape, |tag| tag.group, |mesh, id| mesh.groups().get(id).map(|name| Text::from(name.as_str())), nameless)
}

/// `geometry.materials()`: the names of the materials that faces have, in their order; faces without a material come
/// last, with an empty name (*geometry.materials function*).
pub fn geometry_materials(shape: &Shape) -> Array<Text> {
    let name = |mesh: &Mesh, id: usize| mesh.materials().get(id).and_then(|look| look.name.clone());
    names(shape, |tag| tag.material, name, Text::default())
}

fn names(
    shape: &Shape,
    id: fn(&FaceTag) -> u32,
    name: fn(&Mesh, usize) -> Option<Text>,
    nameless: Text,
) -> Array<Text> {
    match &shape.geometry {
        Geometry::Empty | Geometry::Vertex | Geometry::Edge | Geometry::Wire(_) => Array::default(),
        Geometry::Rect(..) | Geometry::Box(_) => Array::from([nameless]),
        Geometry::Mesh(placed) => {
            let mut used: Vec<u32> = placed.mesh.tags.runs().iter().map(|(_, tag)| id(tag)).collect();
            used.sort_unstable();
            used.dedup();
            used.into_iter().map(|id| name(&placed.mesh, id as usize).unwrap_or_else(|| nameless.clone())).collect()
        }
    }
}
