//! Numbers of vertices, edges, faces and holes; the names of groups and materials.

use super::readable::placed;
use crate::geometry::mesh::{FaceTag, Mesh};
use crate::geometry::small_sort::SmallSort;
use crate::geometry::wire::Wire;
use crate::material::Material;
use crate::run::env::Env;
use crate::shape::{Placed, Shape};
use crate::value::array::Array;
use crate::value::text::Text;

/// `geometry.nVertices()` (*geometry.nVertices function*): a shared vertex counts once.
pub fn geometry_n_vertices(shape: &Shape) -> f64 {
    count(shape, |wire| wire.points.len(), |mesh| mesh.points().len())
}

/// `geometry.nFaces()` (*geometry.nFaces function*).
pub fn geometry_n_faces(shape: &Shape) -> f64 {
    count(shape, |_| 0, Mesh::face_count)
}

/// `geometry.nEdges()` (*geometry.nEdges function*): a shared edge counts once.
pub fn geometry_n_edges(shape: &Shape) -> f64 {
    count(shape, |wire| wire.edges.len(), |mesh| mesh.adjacency().edge_count())
}

/// `geometry.nHoles()`: the number of holes in faces (*geometry.nHoles function*).
pub fn geometry_n_holes(shape: &Shape) -> f64 {
    count(shape, |_| 0, |mesh| mesh.faces().map(|face| face.holes().len()).sum())
}

fn count(shape: &Shape, of_wire: fn(&Wire) -> usize, of_mesh: fn(&Mesh) -> usize) -> f64 {
    let count = match placed(shape) {
        Some(placed) => of_mesh(&placed.mesh),
        None => shape.to_wire().map_or(0, |wire| of_wire(&wire)),
    };
    count as f64
}

/// `geometry.groups()`: the names of the groups that have faces, in their order; faces without a group come last
/// (*geometry.groups function*). Such faces of the initial shape have its name (*CGA changelog 2021.0*), inserted
/// ones an empty name.
pub fn geometry_groups(env: &mut Env, shape: &Shape) -> Array<Text> {
    let is_foreign = shape.state.get().is_some_and(|state| state.foreign);
    let nameless = if is_foreign { Text::default() } else { env.initial.name.clone() };
    names(env, shape, |tag| tag.group, |mesh, id| mesh.groups().get(id).map(|name| Text::from(name.as_str())), nameless)
}

/// `geometry.materials()`: the names of the materials that faces have, in their order; faces without a material come
/// last, with an empty name (*geometry.materials function*).
pub fn geometry_materials(env: &mut Env, shape: &Shape) -> Array<Text> {
    let name = |mesh: &Mesh, id: usize| mesh.materials::<Material>().get(id).and_then(|look| look.name.clone());
    names(env, shape, |tag| tag.material, name, Text::default())
}

fn names(
    env: &mut Env,
    shape: &Shape,
    id: fn(&FaceTag) -> u32,
    name: fn(&Mesh, usize) -> Option<Text>,
    nameless: Text,
) -> Array<Text> {
    let Some(Placed { mesh, .. }) = placed(shape) else { return Array::default() };
    let mut used: Vec<u32> = mesh.face_attributes().map(|tag| id(&tag)).collect();
    used.small_sort_unstable();
    used.dedup();
    if !env.may_hold(used.len()) {
        return Array::default();
    }
    used.into_iter().map(|id| name(&mesh, id as usize).unwrap_or_else(|| nameless.clone())).collect()
}
