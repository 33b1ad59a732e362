//! `setback`: chosen edges set back.

use std::ops::ControlFlow;

use crate::comp::select::Word;
use crate::comp::{Arms, Faces};
use crate::geometry::mesh::FaceRef;
use crate::op::face::swept_edges::{divided, turns};
use crate::run::env::Env;
use crate::shape::texture::SETS;
use crate::value::array::Array;

/// `setback(distance, uvSet) { selector : … | remainder : … }`: the edges of each face that an arm selects are set back by
/// a distance in metres (*setback operation*). Each connected part that the edges of one arm sweep goes to the arm, the
/// rest of the face to `remainder`. A distance that is not positive sets nothing back, and a face without setbacks is a
/// remainder. Selectors in texture space mean the coordinates of `uvSet`; without coordinates they select nothing.
///
/// Where the edges of two arms meet, the arm that comes first keeps the corner. For the ends of setbacks and for faces
/// that cannot be divided see [`shape_l`](fn@crate::op::shape_l).
pub fn setback(env: &mut Env, arms: &mut Arms<'_>, distance: f64, uv_set: f64) -> ControlFlow<(), Faces> {
    let distance = env.finite(distance, "the distance of `setback`");
    edges_back(env, arms, "setback", &|_| distance, uv_set)
}

/// `setback(distances, uvSet) { … }`: the same with a distance for each edge of each face, in the order of `comp(fe)`.
/// Edges without an element stay, and further elements count for nothing.
pub fn setback_each(env: &mut Env, arms: &mut Arms<'_>, distances: Array<f64>, uv_set: f64) -> ControlFlow<(), Faces> {
    edges_back_each(env, arms, "setback", &distances, uv_set)
}

/// `setbackPerEdge(distance, uvSet) { … }`: the same with the distances that were computed on each edge of each face
/// (*setbackPerEdge operation*).
pub fn setback_per_edge(
    env: &mut Env,
    arms: &mut Arms<'_>,
    distances: Array<f64>,
    uv_set: f64,
) -> ControlFlow<(), Faces> {
    edges_back_each(env, arms, "setbackPerEdge", &distances, uv_set)
}

fn edges_back_each(
    env: &mut Env,
    arms: &mut Arms<'_>,
    name: &str,
    distances: &Array<f64>,
    uv_set: f64,
) -> ControlFlow<(), Faces> {
    let distances = finite(env, distances, name);
    edges_back(env, arms, name, &|corner| distances.get(corner).copied().unwrap_or(0.0), uv_set)
}

/// The elements of an array of distances. Those that are not finite become 0, with one fault.
pub(in crate::op) fn finite(env: &mut Env, distances: &Array<f64>, name: &str) -> Vec<f64> {
    let distances = distances.as_slice();
    if let Some(odd) = distances.iter().find(|distance| !distance.is_finite()) {
        env.finite(*odd, format_args!("a distance of `{name}`"));
    }
    distances.iter().map(|distance| if distance.is_finite() { *distance } else { 0.0 }).collect()
}

/// Sets the edges that arms select back. `distance` gives the distance in metres of an edge by its corner.
fn edges_back(
    env: &mut Env,
    arms: &mut Arms<'_>,
    name: &str,
    distance: &dyn Fn(usize) -> f64,
    uv_set: f64,
) -> ControlFlow<(), Faces> {
    if !arms.shape().geometry.has_surface() {
        return ControlFlow::Continue(Faces::default());
    }
    let edges = selected(env, arms, name, uv_set)?;
    let (mesh, remainder) = (arms.shape().to_mesh(), arms.of(Word::Remainder));
    let turns = |face: &FaceRef<'_>| turns(face, &edges, distance);
    ControlFlow::Continue(divided(env, &mesh, remainder, &format!("`{name}`"), &turns))
}

/// The arm of each edge, by corner.
pub(in crate::op) fn selected(
    env: &mut Env,
    arms: &mut Arms<'_>,
    name: &str,
    uv_set: f64,
) -> ControlFlow<(), Vec<Option<u32>>> {
    let set = env.uv_set(uv_set, name).map_or(SETS, usize::from);
    arms.edges(env, set)
}

#[cfg(test)]
pub(in crate::op) mod tests;
