//! `setbackToArea`: chosen edges set back until an area is left.

use std::ops::ControlFlow;

use crate::comp::select::Word;
use crate::comp::{Arms, Faces};
use crate::fault::FaultKind;
use crate::geometry::each::Each;
use crate::geometry::mesh::FaceRef;
use crate::geometry::offset::to_area::{Rest, offset_for};
use crate::geometry::work;
use crate::op::face::setback::{finite, selected};
use crate::op::face::swept_edges::{divided, turns};
use crate::run::env::Env;
use crate::value::array::Array;

/// The name in messages.
const NAME: &str = "setbackToArea";

/// `setbackToArea(area, uvSet) { selector : … | remainder : … }`: the edges that arms select are set back by one common
/// distance, such that the remainders of all faces together have an area in square metres (*setbackToArea operation*).
/// It has the selectors and parts of [`setback`](fn@crate::op::setback).
///
/// If the faces are not larger, nothing is set back. If the edges cannot take enough, they take all that they reach. An
/// area that is not positive leaves a fault and sets nothing back.
pub fn setback_to_area(env: &mut Env, arms: &mut Arms<'_>, area: f64, uv_set: f64) -> ControlFlow<(), Faces> {
    to_area(env, arms, area, &[], None, uv_set)
}

/// `setbackToArea(area, minDistances, uvSet) { … }`: the same with distances in metres for the edges of each face, in the
/// order of `comp(fe)`, which all grow by a common offset. Without an element, an edge begins at 0. If already the smallest
/// distances leave less than the area, these are used.
pub fn setback_to_area_from(
    env: &mut Env,
    arms: &mut Arms<'_>,
    area: f64,
    least: Array<f64>,
    uv_set: f64,
) -> ControlFlow<(), Faces> {
    let least = finite(env, &least, NAME);
    to_area(env, arms, area, &least, None, uv_set)
}

/// `setbackToArea(area, minDistances, maxDistances, uvSet) { … }`: the same, and no distance becomes larger than its
/// element of `maxDistances`, also if the smallest one is. An edge without such an element stays. If the largest distances
/// leave more than the area, these are used.
pub fn setback_to_area_between(
    env: &mut Env,
    arms: &mut Arms<'_>,
    area: f64,
    least: Array<f64>,
    most: Array<f64>,
    uv_set: f64,
) -> ControlFlow<(), Faces> {
    let [least, most] = [least, most].each(|distances| finite(env, &distances, NAME));
    to_area(env, arms, area, &least, Some(&most), uv_set)
}

fn to_area(
    env: &mut Env,
    arms: &mut Arms<'_>,
    area: f64,
    least: &[f64],
    most: Option<&[f64]>,
    uv_set: f64,
) -> ControlFlow<(), Faces> {
    let area = env.finite(area, format_args!("the area of `{NAME}`"));
    if !arms.shape().geometry.has_surface() {
        return ControlFlow::Continue(Faces::default());
    }
    let mut edges = selected(env, arms, NAME, uv_set)?;
    if area <= 0.0 {
        env.fault(FaultKind::Value, format!("`{NAME}`: an area of {area} is not above 0; nothing is set back"));
        edges.fill(None);
    }
    let mesh = arms.shape().to_mesh();
    let of = |distances: &[f64], corner: usize| distances.get(corner).copied().unwrap_or(0.0);
    let most_of = |corner: usize| most.map_or(f64::INFINITY, |most| of(most, corner));
    let distance = |offset: f64, corner: usize| (of(least, corner).max(0.0) + offset).min(most_of(corner));
    // No edge needs to go farther than through all faces.
    let far = 2.0 * mesh.bounds().size().length();
    let farthest = (0..edges.len()).filter(|&corner| edges[corner].is_some());
    let farthest = farthest.map(|corner| (most_of(corner) - of(least, corner).max(0.0)).min(far)).fold(0.0, f64::max);
    let left = |offset: f64| -> Rest {
        let face = |face: FaceRef<'_>| {
            let turns = turns(&face, &edges, |corner| distance(offset, corner));
            let turns: Vec<&[f64]> = turns.iter().map(|turn| &turn.distances[..]).collect();
            let first = face.corner_range().start;
            let moves = |piece: usize| {
                edges[first + piece].is_some() && distance(offset, first + piece) < most_of(first + piece)
            };
            Rest::of(&face, &turns, moves)
        };
        mesh.faces().take_while(|_| work::spend(0)).map(face).sum()
    };
    let offset = offset_for(area, farthest, left);
    let turns = |face: &FaceRef<'_>| turns(face, &edges, |corner| distance(offset, corner));
    ControlFlow::Continue(divided(env, &mesh, arms.of(Word::Remainder), &format!("`{NAME}`"), &turns))
}

#[cfg(test)]
mod tests;
