//! `union`, `subtract`, `intersect` and `inline(unify)`: boolean operations on the leaves of operands.

use std::sync::Arc;

use glam::DVec3;

use crate::fault::FaultKind;
use crate::geometry::boolean::{BooleanError, BooleanOp, combine};
use crate::geometry::mesh::Mesh;
use crate::geometry::mesh::join::join;
use crate::geometry::unbent::bent_along;
use crate::op::mesh::joined::{all_part_meshes, joined_state, replace_by, retain_parts};
use crate::run::env::Env;
use crate::shape::look::Look;
use crate::shape::{Geometry, Shape};

/// The operand that the current shape is, in the old form of boolean operations (*CGA changelog 2025.0*).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SwapMode {
    /// The first one.
    NoSwap,
    /// The second one.
    Swap,
}

/// `union { A | B }`: whatever is in the leaves of one of the operands (*Boolean operations*).
///
/// The leaves of an operand are united first. Closed meshes are solids. An open surface counts as the outline of a solid below
/// its front, unless its border meets the other operand. If all faces lie in one plane, their areas are combined.
///
/// The first operand gives the scope's axes, the attributes, and the material of faces that coincide. Faces have the tags
/// `bool.A` and `bool.B` of their operands. If the materials of leaves differ, each face has the material of its leaf. Leaves
/// without faces are left out.
///
/// The operation fails, with a fault, if the faces of the operands cross so often that the result would take seconds, or
/// if faces that are nearly at one place cannot be told apart. Then nothing is lost: a union has all faces of all leaves, and
/// other operations have the first operand's faces.
pub fn union(env: &mut Env, shape: &mut Shape, operands: [Vec<Shape>; 2]) {
    boolean(env, shape, operands, BooleanOp::Union);
}

/// `subtract { A | B }`: whatever is in the leaves of the first operand and not in the leaves of the second; see [`union`].
pub fn subtract(env: &mut Env, shape: &mut Shape, operands: [Vec<Shape>; 2]) {
    boolean(env, shape, operands, BooleanOp::Subtract);
}

/// `intersect { A | B }`: whatever is in the leaves of both operands; see [`union`].
pub fn intersect(env: &mut Env, shape: &mut Shape, operands: [Vec<Shape>; 2]) {
    boolean(env, shape, operands, BooleanOp::Intersect);
}

/// `union Rule`, the old form, in which the current shape is an operand (*CGA changelog 2025.0*).
pub fn union_current(env: &mut Env, shape: &mut Shape, [leaves]: [Vec<Shape>; 1], swap: SwapMode) {
    boolean(env, shape, with_current(shape, leaves, swap), BooleanOp::Union);
}

/// `subtract Rule`, the old form; see [`union_current`].
pub fn subtract_current(env: &mut Env, shape: &mut Shape, [leaves]: [Vec<Shape>; 1], swap: SwapMode) {
    boolean(env, shape, with_current(shape, leaves, swap), BooleanOp::Subtract);
}

/// `intersect Rule`, the old form; see [`union_current`].
pub fn intersect_current(env: &mut Env, shape: &mut Shape, [leaves]: [Vec<Shape>; 1], swap: SwapMode) {
    boolean(env, shape, with_current(shape, leaves, swap), BooleanOp::Intersect);
}

fn with_current(shape: &Shape, leaves: Vec<Shape>, swap: SwapMode) -> [Vec<Shape>; 2] {
    match swap {
        SwapMode::NoSwap => [vec![shape.clone()], leaves],
        SwapMode::Swap => [leaves, vec![shape.clone()]],
    }
}

fn boolean(env: &mut Env, shape: &mut Shape, mut operands: [Vec<Shape>; 2], op: BooleanOp) {
    let word = match op {
        BooleanOp::Unify | BooleanOp::Union => "union",
        BooleanOp::Subtract => "subtract",
        BooleanOp::Intersect => "intersect",
    };
    for leaves in &mut operands {
        retain_parts(leaves, |leaf| leaf);
        leaves.retain(|leaf| leaf.geometry.has_surface());
    }
    let mut sum = shape.clone();
    match operands[0].as_slice() {
        [] => {}
        [only] => replace_by(&mut sum, only.clone()),
        [first, others @ ..] => sum.state = joined_state(shape, first, others),
    }
    let [first, second] = operands;
    let firsts = first.len();
    let leaves: Vec<Shape> = first.into_iter().chain(second).collect();
    let is_common = leaves.iter().all(|leaf| leaf.material() == leaves[0].material());
    let material =
        leaves.first().filter(|_| is_common).map_or_else(Arc::default, |leaf| Arc::new(leaf.material().clone()));
    sum.state.change().look = Arc::new(Look { material, ..Look::default() });
    let Some(meshes) = all_part_meshes(env, &sum, &leaves) else { return };
    let (first, second) = meshes.split_at(firsts);
    if let Some(mesh) = combined(env, op, word, [first, second], &leaves) {
        *shape = sum;
        set(shape, mesh);
    }
}

/// The union of all leaves, which have faces. One leaf whose faces do not meet stays as it is.
pub(in crate::op) fn unify(env: &mut Env, shape: &mut Shape, leaves: Vec<Shape>) {
    if let [only] = leaves.as_slice() {
        if let Geometry::Rect(..) | Geometry::Box(_) = only.geometry {
            return replace_by(shape, only.clone());
        }
        let mesh = only.to_mesh();
        if let Some(made) = combined(env, BooleanOp::Unify, "inline(unify)", [&[Mesh::clone(&mesh)], &[]], &leaves) {
            replace_by(shape, only.clone());
            if made.points() != mesh.points() || made.corners() != mesh.corners() {
                set(shape, made);
            }
        }
        return;
    }
    let Some(meshes) = all_part_meshes(env, shape, &leaves) else { return };
    if let Some(made) = combined(env, BooleanOp::Unify, "inline(unify)", [&meshes, &[]], &leaves) {
        shape.state = joined_state(shape, &leaves[0], &leaves[1..]);
        set(shape, made);
    }
}

fn set(shape: &mut Shape, mesh: Mesh) {
    if mesh.is_empty() {
        shape.geometry = Geometry::Empty;
    } else {
        shape.set_mesh(mesh);
    }
}

/// The result of an operation. If it cannot be done, it leaves a fault and has the faces of the operands that it keeps. `None` if
/// the run has ended.
fn combined(env: &mut Env, op: BooleanOp, word: &str, meshes: [&[Mesh]; 2], leaves: &[Shape]) -> Option<Mesh> {
    let count = |mesh: &Mesh| mesh.corners().len() as u64;
    let given: u64 = meshes.into_iter().flatten().map(count).sum();
    if env.count_corners(given).is_break() {
        return None;
    }
    // Coordinates in the world are rounded before they are relative to a scope.
    let far = leaves.iter().map(|leaf| (leaf.scope.origin.abs() + leaf.scope.size.abs()).max_element());
    let rounding = far.fold(0.0, f64::max) * f64::EPSILON;
    let why = match combine(op, meshes, rounding) {
        Ok(made) => return env.count_corners(count(&made).saturating_sub(given)).is_continue().then_some(made),
        Err(BooleanError::TooMany) => "too many faces cross",
        Err(BooleanError::Tangled) => "faces are too near to each other",
        Err(BooleanError::NotFinite) => "a coordinate is not finite",
    };
    let is_union = matches!(op, BooleanOp::Union | BooleanOp::Unify);
    let instead = if is_union { "its faces are joined as they are" } else { "its first operand stays as it is" };
    env.fault(FaultKind::Geometry, format!("`{word}`: {why}; {instead}"));
    // An operation that was ended needs no result.
    if env.ended() {
        return None;
    }
    let kept = meshes.into_iter().take(if is_union { 2 } else { 1 }).flatten();
    let mut direction = DVec3::ZERO;
    let kept: Vec<Mesh> = kept.map(|mesh| bent_along(mesh.clone(), &mut direction)).collect();
    Some(join(kept.iter()))
}
