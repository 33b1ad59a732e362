//! The leaves of an operand as parts of one shape.

use std::sync::Arc;

use crate::geometry::mesh::Mesh;
use crate::geometry::trace::Trace;
use crate::material::Material;
use crate::run::env::Env;
use crate::shape::Shape;
use crate::shape::look::Look;
use crate::shape::state::{State, StateRef};

/// Drops leaves that `NIL` has removed, and leaves without faces if another leaf has some. `leaf` gives the shape of an
/// element.
pub(in crate::op) fn retain_parts<T>(list: &mut Vec<T>, leaf: impl Fn(&T) -> &Shape) {
    list.retain(|own| !leaf(own).trace().is_some_and(Trace::is_gone));
    if list.iter().any(|own| leaf(own).geometry.has_surface()) {
        list.retain(|own| leaf(own).geometry.has_surface());
    }
}

/// Replaces the current shape by a leaf, except for its place in the derivation.
pub(in crate::op) fn replace_by(shape: &mut Shape, leaf: Shape) {
    let Shape { seed, split, comp, ref selector, .. } = *shape;
    let selector = selector.clone();
    *shape = Shape { seed, split, comp, selector, ..leaf };
}

/// The meshes of leaves in the scope of a shape. If the materials of leaves differ, faces have the material of their leaf.
pub(in crate::op) fn part_meshes<'l>(shape: &Shape, leaves: &'l [Shape]) -> impl Iterator<Item = Mesh> + use<'l> {
    let is_common = leaves.iter().all(|leaf| leaf.material() == leaves[0].material());
    let to_scope = shape.scope.placement().inverse();
    leaves.iter().map(move |leaf| {
        let mesh = Arc::unwrap_or_clone(leaf.to_mesh()).into_mapped(&(to_scope * leaf.scope.placement()));
        if is_common { mesh } else { with_material(&mesh, leaf.material()) }
    })
}

/// The units of work of a leaf besides its corners.
const LEAF: usize = 256;

/// All of these meshes. `None` if the run has ended.
pub(in crate::op) fn all_part_meshes(env: &mut Env, shape: &Shape, leaves: &[Shape]) -> Option<Vec<Mesh>> {
    let mut in_time = |mesh: Mesh| env.spend(LEAF + mesh.corners().len()).is_continue().then_some(mesh);
    part_meshes(shape, leaves).map(&mut in_time).collect()
}

/// The mesh whose faces have a material over their own.
fn with_material(mesh: &Mesh, material: &Material) -> Mesh {
    let mut materials: Vec<Material> = mesh.materials().iter().map(|own| material.over(own)).collect();
    let plain = materials.len() as u32;
    materials.push(material.clone());
    mesh.with_materials(materials, |number| number.min(plain))
}

/// The state of the sum: what all leaves have in common, otherwise what the current shape has. Faces have their material
/// if it is not common.
pub(in crate::op) fn joined_state(shape: &Shape, first: &Shape, others: &[Shape]) -> StateRef {
    let unset = State::default();
    let first = first.state.get().unwrap_or(&unset);
    let others = || others.iter().map(|leaf| leaf.state.get().unwrap_or(&unset));
    let mut sum = shape.state.clone();
    let state = sum.change();
    let is_common = others().all(|other| other.look.material == first.look.material);
    let material = if is_common { first.look.material.clone() } else { Arc::default() };
    state.look = Arc::new(Look { material, ..Look::default() });
    if others().all(|other| other.projections == first.projections) {
        state.projections.clone_from(&first.projections);
    }
    if others().all(|other| other.attributes == first.attributes) {
        state.attributes.clone_from(&first.attributes);
    }
    if others().all(|other| other.trim == first.trim) {
        state.trim = first.trim;
    }
    state.foreign = first.foreign || others().any(|other| other.foreign);
    sum
}
