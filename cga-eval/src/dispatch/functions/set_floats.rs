//! Calls of `setElems` on arrays of numbers.
//!
//! Generated from the tables of `cga-lang`; write it again with `CGA_BLESS=1 cargo test -p cga-lang --test dispatch`.

use crate::dispatch::FunctionCall;
use cga_lang::ir::Expr;
use cga_runtime::rt::func;

/// The call of a function of this group, by the key of its row.
pub(super) fn call(key: &str, _: &[Expr]) -> Option<FunctionCall> {
    Some(match key {
        "set_elements(floats, bools, float)" => FunctionCall::new(move |stack, env, _| {
            let a2 = stack.float();
            let a1 = stack.bools();
            let a0 = stack.floats();
            let value = func::set_elements(env, a0, a1, a2);
            stack.push_floats(value);
        }),
        "set_elements(floats, bools, floats)" => FunctionCall::new(move |stack, env, _| {
            let a2 = stack.floats();
            let a1 = stack.bools();
            let a0 = stack.floats();
            let value = func::set_elements(env, a0, a1, a2);
            stack.push_floats(value);
        }),
        "set_elements(floats, float, float)" => FunctionCall::new(move |stack, env, _| {
            let a2 = stack.float();
            let a1 = stack.float();
            let a0 = stack.floats();
            let value = func::set_elements(env, a0, a1, a2);
            stack.push_floats(value);
        }),
        "set_elements(floats, float, floats)" => FunctionCall::new(move |stack, env, _| {
            let a2 = stack.floats();
            let a1 = stack.float();
            let a0 = stack.floats();
            let value = func::set_elements(env, a0, a1, a2);
            stack.push_floats(value);
        }),
        "set_elements(floats, floats, float)" => FunctionCall::new(move |stack, env, _| {
            let a2 = stack.float();
            let a1 = stack.floats();
            let a0 = stack.floats();
            let value = func::set_elements(env, a0, a1, a2);
            stack.push_floats(value);
        }),
        "set_elements(floats, floats, floats)" => FunctionCall::new(move |stack, env, _| {
            let a2 = stack.floats();
            let a1 = stack.floats();
            let a0 = stack.floats();
            let value = func::set_elements(env, a0, a1, a2);
            stack.push_floats(value);
        }),
        "set_elements_at(floats, bools, bools, float)" => FunctionCall::new(move |stack, env, _| {
            let a3 = stack.float();
            let a2 = stack.bools();
            let a1 = stack.bools();
            let a0 = stack.floats();
            let value = func::set_elements_at(env, a0, a1, a2, a3);
            stack.push_floats(value);
        }),
        "set_elements_at(floats, bools, bools, floats)" => FunctionCall::new(move |stack, env, _| {
            let a3 = stack.floats();
            let a2 = stack.bools();
            let a1 = stack.bools();
            let a0 = stack.floats();
            let value = func::set_elements_at(env, a0, a1, a2, a3);
            stack.push_floats(value);
        }),
        "set_elements_at(floats, bools, float, float)" => FunctionCall::new(move |stack, env, _| {
            let a3 = stack.float();
            let a2 = stack.float();
            let a1 = stack.bools();
            let a0 = stack.floats();
            let value = func::set_elements_at(env, a0, a1, a2, a3);
            stack.push_floats(value);
        }),
        "set_elements_at(floats, bools, float, floats)" => FunctionCall::new(move |stack, env, _| {
            let a3 = stack.floats();
            let a2 = stack.float();
            let a1 = stack.bools();
            let a0 = stack.floats();
            let value = func::set_elements_at(env, a0, a1, a2, a3);
            stack.push_floats(value);
        }),
        "set_elements_at(floats, bools, floats, float)" => FunctionCall::new(move |stack, env, _| {
            let a3 = stack.float();
            let a2 = stack.floats();
            let a1 = stack.bools();
            let a0 = stack.floats();
            let value = func::set_elements_at(env, a0, a1, a2, a3);
            stack.push_floats(value);
        }),
        "set_elements_at(floats, bools, floats, floats)" => FunctionCall::new(move |stack, env, _| {
            let a3 = stack.floats();
            let a2 = stack.floats();
            let a1 = stack.bools();
            let a0 = stack.floats();
            let value = func::set_elements_at(env, a0, a1, a2, a3);
            stack.push_floats(value);
        }),
        "set_elements_at(floats, float, bools, float)" => FunctionCall::new(move |stack, env, _| {
            let a3 = stack.float();
            let a2 = stack.bools();
            let a1 = stack.float();
            let a0 = stack.floats();
            let value = func::set_elements_at(env, a0, a1, a2, a3);
            stack.push_floats(value);
        }),
        "set_elements_at(floats, float, bools, floats)" => FunctionCall::new(move |stack, env, _| {
            let a3 = stack.floats();
            let a2 = stack.bools();
            let a1 = stack.float();
            let a0 = stack.floats();
            let value = func::set_elements_at(env, a0, a1, a2, a3);
            stack.push_floats(value);
        }),
        "set_elements_at(floats, float, float, float)" => FunctionCall::new(move |stack, env, _| {
            let a3 = stack.float();
            let a2 = stack.float();
            let a1 = stack.float();
            let a0 = stack.floats();
            let value = func::set_elements_at(env, a0, a1, a2, a3);
            stack.push_floats(value);
        }),
        "set_elements_at(floats, float, float, floats)" => FunctionCall::new(move |stack, env, _| {
            let a3 = stack.floats();
            let a2 = stack.float();
            let a1 = stack.float();
            let a0 = stack.floats();
            let value = func::set_elements_at(env, a0, a1, a2, a3);
            stack.push_floats(value);
        }),
        "set_elements_at(floats, float, floats, float)" => FunctionCall::new(move |stack, env, _| {
            let a3 = stack.float();
            let a2 = stack.floats();
            let a1 = stack.float();
            let a0 = stack.floats();
            let value = func::set_elements_at(env, a0, a1, a2, a3);
            stack.push_floats(value);
        }),
        "set_elements_at(floats, float, floats, floats)" => FunctionCall::new(move |stack, env, _| {
            let a3 = stack.floats();
            let a2 = stack.floats();
            let a1 = stack.float();
            let a0 = stack.floats();
            let value = func::set_elements_at(env, a0, a1, a2, a3);
            stack.push_floats(value);
        }),
        "set_elements_at(floats, floats, bools, float)" => FunctionCall::new(move |stack, env, _| {
            let a3 = stack.float();
            let a2 = stack.bools();
            let a1 = stack.floats();
            let a0 = stack.floats();
            let value = func::set_elements_at(env, a0, a1, a2, a3);
            stack.push_floats(value);
        }),
        "set_elements_at(floats, floats, bools, floats)" => FunctionCall::new(move |stack, env, _| {
            let a3 = stack.floats();
            let a2 = stack.bools();
            let a1 = stack.floats();
            let a0 = stack.floats();
            let value = func::set_elements_at(env, a0, a1, a2, a3);
            stack.push_floats(value);
        }),
        "set_elements_at(floats, floats, float, float)" => FunctionCall::new(move |stack, env, _| {
            let a3 = stack.float();
            let a2 = stack.float();
            let a1 = stack.floats();
            let a0 = stack.floats();
            let value = func::set_elements_at(env, a0, a1, a2, a3);
            stack.push_floats(value);
        }),
        "set_elements_at(floats, floats, float, floats)" => FunctionCall::new(move |stack, env, _| {
            let a3 = stack.floats();
            let a2 = stack.float();
            let a1 = stack.floats();
            let a0 = stack.floats();
            let value = func::set_elements_at(env, a0, a1, a2, a3);
            stack.push_floats(value);
        }),
        "set_elements_at(floats, floats, floats, float)" => FunctionCall::new(move |stack, env, _| {
            let a3 = stack.float();
            let a2 = stack.floats();
            let a1 = stack.floats();
            let a0 = stack.floats();
            let value = func::set_elements_at(env, a0, a1, a2, a3);
            stack.push_floats(value);
        }),
        "set_elements_at(floats, floats, floats, floats)" => FunctionCall::new(move |stack, env, _| {
            let a3 = stack.floats();
            let a2 = stack.floats();
            let a1 = stack.floats();
            let a0 = stack.floats();
            let value = func::set_elements_at(env, a0, a1, a2, a3);
            stack.push_floats(value);
        }),
        _ => return None,
    })
}
