//! Calls of operations with arms.
//!
//! Generated from the tables of `cga-lang`; write it again with `CGA_BLESS=1 cargo test -p cga-lang --test dispatch`.

use crate::dispatch::{ArmsCall, Known as _, words};
use cga_lang::ir::Arg;
use cga_runtime::rt::{self, op};

/// The call of an operation of this form, by the key of its row.
pub(crate) fn call(key: &str, known: &[Arg]) -> Option<ArmsCall> {
    Some(match key {
        "inner_rectangle(RectangleAlignment)" => {
            let a0 = words::op_rectangle_alignment(known.word(0)?)?;
            ArmsCall::new(move |_, cx, shape, number, arms, when, visit| {
                rt::divide(cx, shape, number, arms, when, |env, arms| op::inner_rectangle(env, arms, a0), visit)
            })
        }
        "setback(float, float)" => ArmsCall::new(move |stack, cx, shape, number, arms, when, visit| {
            let a1 = stack.float();
            let a0 = stack.float();
            rt::divide(cx, shape, number, arms, when, |env, arms| op::setback(env, arms, a0, a1), visit)
        }),
        "setback_each(floats, float)" => ArmsCall::new(move |stack, cx, shape, number, arms, when, visit| {
            let a1 = stack.float();
            let a0 = stack.floats();
            rt::divide(cx, shape, number, arms, when, |env, arms| op::setback_each(env, arms, a0, a1), visit)
        }),
        "setback_per_edge(floats, float)" => ArmsCall::new(move |stack, cx, shape, number, arms, when, visit| {
            let a1 = stack.float();
            let a0 = stack.floats();
            rt::divide(cx, shape, number, arms, when, |env, arms| op::setback_per_edge(env, arms, a0, a1), visit)
        }),
        "setback_to_area(float, float)" => ArmsCall::new(move |stack, cx, shape, number, arms, when, visit| {
            let a1 = stack.float();
            let a0 = stack.float();
            rt::divide(cx, shape, number, arms, when, |env, arms| op::setback_to_area(env, arms, a0, a1), visit)
        }),
        "setback_to_area_between(float, floats, floats, float)" => {
            ArmsCall::new(move |stack, cx, shape, number, arms, when, visit| {
                let a3 = stack.float();
                let a2 = stack.floats();
                let a1 = stack.floats();
                let a0 = stack.float();
                rt::divide(
                    cx,
                    shape,
                    number,
                    arms,
                    when,
                    |env, arms| op::setback_to_area_between(env, arms, a0, a1, a2, a3),
                    visit,
                )
            })
        }
        "setback_to_area_from(float, floats, float)" => {
            ArmsCall::new(move |stack, cx, shape, number, arms, when, visit| {
                let a2 = stack.float();
                let a1 = stack.floats();
                let a0 = stack.float();
                rt::divide(
                    cx,
                    shape,
                    number,
                    arms,
                    when,
                    |env, arms| op::setback_to_area_from(env, arms, a0, a1, a2),
                    visit,
                )
            })
        }
        "shape_l(float, float)" => ArmsCall::new(move |stack, cx, shape, number, arms, when, visit| {
            let a1 = stack.float();
            let a0 = stack.float();
            rt::divide(cx, shape, number, arms, when, |env, arms| op::shape_l(env, arms, a0, a1), visit)
        }),
        "shape_o(float, float, float, float)" => ArmsCall::new(move |stack, cx, shape, number, arms, when, visit| {
            let a3 = stack.float();
            let a2 = stack.float();
            let a1 = stack.float();
            let a0 = stack.float();
            rt::divide(cx, shape, number, arms, when, |env, arms| op::shape_o(env, arms, a0, a1, a2, a3), visit)
        }),
        "shape_u(float, float, float)" => ArmsCall::new(move |stack, cx, shape, number, arms, when, visit| {
            let a2 = stack.float();
            let a1 = stack.float();
            let a0 = stack.float();
            rt::divide(cx, shape, number, arms, when, |env, arms| op::shape_u(env, arms, a0, a1, a2), visit)
        }),
        _ => return None,
    })
}
