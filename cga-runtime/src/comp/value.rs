//! `comp` as a value: an array with an element for each component.

use std::ops::ControlFlow;

use super::{Align, Arm, AssignedComponents, Candidate, Components};
use crate::run::env::Env;
use crate::run::sink::Flow;
use crate::shape::Shape;
use crate::value::array::{Array, Element};

/// `comp(…) { selector : value | … }`: an element for each component by number. Components that no arm takes have the
/// default, and components of one shape have the same value (*comp function*). `value` gets the number of the arm and
/// the shape.
pub fn comp_values<T: Element>(
    env: &mut Env,
    shape: &mut Shape,
    components: Components,
    align: Align,
    arms: &[Arm],
    when: impl FnMut(&mut Env, u32, &mut Candidate<'_>) -> bool,
    mut value: impl FnMut(&mut Env, u32, &mut Shape) -> T,
) -> Array<T> {
    let whole = Shape { seed: shape.seed.branch(), ..shape.clone() };
    let ControlFlow::Continue(parts) = AssignedComponents::of(env, &whole, components, align, arms, when) else {
        return Array::default();
    };
    if !env.may_hold(parts.owners.len()) {
        return Array::default();
    }
    let mut values = vec![T::default(); parts.owners.len()];
    let _: Flow = parts.each(|arm, members, mut part| {
        let own = value(env, arm, &mut part);
        members.iter().for_each(|&member| values[member as usize] = own.clone());
        Flow::Continue(())
    });
    Array::from(values)
}
