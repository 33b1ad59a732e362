//! `inline`: the leaves of a rule as one shape (*Rule inlining*).

use glam::DVec3;

use crate::geometry::each::Each;
use crate::geometry::mesh::join::join;
use crate::geometry::mesh::{Mesh, SubcomponentTagsBuilder};
use crate::geometry::unbent::bent_along;
use crate::geometry::wire::Wire;
use crate::op::mesh::boolean::unify;
use crate::op::mesh::joined::{all_part_meshes, joined_state, replace_by, retain_parts};
use crate::op::mesh::recompose::recompose;
use crate::run::env::Env;
use crate::shape::{Geometry, Shape};

/// The way in which the geometry of leaves is combined.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MergeStrategy {
    /// The faces of all leaves, as they are.
    Append,
    /// The boolean union.
    Unify,
    /// One mesh, with the vertices that the parts shared.
    Recompose,
}

/// Replaces the current shape by the leaves of a rule, which was derived from a copy of it (*Rule inlining*).
///
/// One leaf is taken as it is. Several leaves become one mesh: the faces of all, one after the other, without merged
/// vertices, with `recompose` reconnected (*Shape recomposition*), or with `unify` their boolean union. `unify` also unites the
/// parts of one leaf. The scope keeps its axes and becomes their bounding
/// box, and the pivot stays. If their materials differ, each face gets the material of its leaf. Attributes and projections
/// that all leaves have in common are taken, otherwise the attributes and projections of the current shape stay. Leaves
/// without faces are left out, unless no leaf has faces. Without leaves, the shape has no geometry.
pub fn inline(env: &mut Env, shape: &mut Shape, [mut leaves]: [Vec<Shape>; 1], strategy: MergeStrategy) {
    if strategy == MergeStrategy::Recompose {
        if leaves.len() != 1 {
            return recompose(env, shape, leaves);
        }
        leaves.iter_mut().for_each(|leaf| _ = env.end_trace(leaf));
        env.end_recomposition();
        let depth = env.recomposed_depth();
        leaves.iter_mut().for_each(|leaf| leaf.change_trace(|trace| trace.cut_to(depth)));
    }
    retain_parts(&mut leaves, |leaf| leaf);
    if strategy == MergeStrategy::Unify && leaves.iter().any(|leaf| leaf.geometry.has_surface()) {
        return unify(env, shape, leaves);
    }
    match leaves.as_slice() {
        [] => shape.geometry = Geometry::Empty,
        [_] => leaves.drain(..).for_each(|leaf| replace_by(shape, leaf)),
        [first, others @ ..] => {
            shape.state = joined_state(shape, first, others);
            if first.geometry.has_surface() {
                join_faces(env, shape, &leaves);
            } else {
                join_wires(shape, &leaves);
            }
        }
    }
}

fn join_faces(env: &mut Env, shape: &mut Shape, leaves: &[Shape]) {
    let Some(meshes) = all_part_meshes(env, shape, leaves) else { return };
    let mut direction = DVec3::ZERO;
    let meshes: Vec<Mesh> = meshes.into_iter().map(|mesh| bent_along(mesh, &mut direction)).collect();
    let count: u64 = meshes.iter().map(|mesh| mesh.corners().len() as u64).sum();
    if env.count_corners(count).is_continue() {
        let joined = join(meshes.iter());
        if env.spend(0).is_continue() {
            shape.set_mesh(joined);
        }
    }
}

fn join_wires(shape: &mut Shape, leaves: &[Shape]) {
    let (mut sum, mut tagger) = (Wire::default(), SubcomponentTagsBuilder::default());
    let wires = || leaves.iter().filter_map(|leaf| Some((leaf, leaf.to_wire()?)));
    let has_edges = wires().any(|(_, wire)| !wire.edges.is_empty());
    for (leaf, wire) in wires().filter(|(_, wire)| !has_edges || !wire.edges.is_empty()) {
        let first = sum.points.len() as u32;
        let frame = shape.scope.frame();
        tagger.append(&wire.tags, &|point| first + point);
        sum.points.extend(wire.points.iter().map(|point| frame.to_local(leaf.scope.frame().to_world(*point))));
        sum.edges.extend(wire.edges.iter().map(|edge| edge.each(|point| first + point)));
        sum.normals.extend(wire.normals.iter().map(|normal| frame.axes.transpose() * (leaf.scope.axes * *normal)));
    }
    sum.tags = tagger.finish();
    shape.set_wire(sum);
}
