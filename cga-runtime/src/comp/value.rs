//! `comp` as a value: an array with an element a component.

use std::ops::ControlFlow;

use super::{Align, Arm, Candidate, Components, Parts};
use crate::array::{Array, Element};
use crate::env::Env;
use crate::shape::ShapeRef;
use crate::sink::Flow;

/// `comp(…) { selector : value | … }`: an element for each component by number; those that no arm takes have the default,
/// those that are put together the same value (*comp function*). `value` gets the number of the arm and the shape.
pub fn comp_values<T: Element>(
    env: &mut Env,
    shape: &mut ShapeRef<'_>,
    components: Components,
    align: Align,
    arms: &[Arm],
    when: impl FnMut(&mut Env, u32, &mut Candidate<'_>) -> bool,
    mut value: impl FnMut(&mut Env, u32, &mut ShapeRef<'_>) -> T,
) -> Array<T> {
    let ControlFlow::Continue(parts) = Parts::of(env, shape, components, align, arms, when) else {
        return Array::default();
    };
    if !env.may_hold(parts.owners.len()) {
        return Array::default();
    }
    let mut values = vec![T::default(); parts.owners.len()];
    let _: Flow = parts.each(|arm, members, part| {
        let own = value(env, arm, part);
        members.iter().for_each(|&member| values[member as usize] = own.clone());
        Flow::Continue(())
    });
    Array::from(values)
}
