//! The state of a shape that is made of several.

use std::sync::Arc;

use crate::shape::Shape;
use crate::shape::look::Look;
use crate::shape::state::{State, StateRef};

/// The state of the sum: what all leaves have in common, otherwise what the current shape has. Faces have their material
/// if it is not common.
pub(super) fn joined_state(shape: &Shape, first: &Shape, others: &[Shape]) -> StateRef {
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
