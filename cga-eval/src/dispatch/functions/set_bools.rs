//! Calls of `setElems` on arrays of truth values.
//!
//! Generated from the tables of `cga-lang`; write it again with `CGA_BLESS=1 cargo test -p cga-lang --test dispatch`.

use crate::dispatch::FunctionCall;
use cga_lang::ir::Expr;
use cga_runtime::rt::func;

/// The call of a function of this group, by the key of its row.
pub(super) fn call(key: &str, _: &[Expr]) -> Option<FunctionCall> {
    Some(match key {
        "set_elements(bools, bools, bool)" => FunctionCall::new(move |stack, env, _| {
            let a2 = stack.bool();
            let a1 = stack.bools();
            let a0 = stack.bools();
            let value = func::set_elements(env, a0, a1, a2);
            stack.push_bools(value);
        }),
        "set_elements(bools, bools, bools)" => FunctionCall::new(move |stack, env, _| {
            let a2 = stack.bools();
            let a1 = stack.bools();
            let a0 = stack.bools();
            let value = func::set_elements(env, a0, a1, a2);
            stack.push_bools(value);
        }),
        "set_elements(bools, float, bool)" => FunctionCall::new(move |stack, env, _| {
            let a2 = stack.bool();
            let a1 = stack.float();
            let a0 = stack.bools();
            let value = func::set_elements(env, a0, a1, a2);
            stack.push_bools(value);
        }),
        "set_elements(bools, float, bools)" => FunctionCall::new(move |stack, env, _| {
            let a2 = stack.bools();
            let a1 = stack.float();
            let a0 = stack.bools();
            let value = func::set_elements(env, a0, a1, a2);
            stack.push_bools(value);
        }),
        "set_elements(bools, floats, bool)" => FunctionCall::new(move |stack, env, _| {
            let a2 = stack.bool();
            let a1 = stack.floats();
            let a0 = stack.bools();
            let value = func::set_elements(env, a0, a1, a2);
            stack.push_bools(value);
        }),
        "set_elements(bools, floats, bools)" => FunctionCall::new(move |stack, env, _| {
            let a2 = stack.bools();
            let a1 = stack.floats();
            let a0 = stack.bools();
            let value = func::set_elements(env, a0, a1, a2);
            stack.push_bools(value);
        }),
        "set_elements_at(bools, bools, bools, bool)" => FunctionCall::new(move |stack, env, _| {
            let a3 = stack.bool();
            let a2 = stack.bools();
            let a1 = stack.bools();
            let a0 = stack.bools();
            let value = func::set_elements_at(env, a0, a1, a2, a3);
            stack.push_bools(value);
        }),
        "set_elements_at(bools, bools, bools, bools)" => FunctionCall::new(move |stack, env, _| {
            let a3 = stack.bools();
            let a2 = stack.bools();
            let a1 = stack.bools();
            let a0 = stack.bools();
            let value = func::set_elements_at(env, a0, a1, a2, a3);
            stack.push_bools(value);
        }),
        "set_elements_at(bools, bools, float, bool)" => FunctionCall::new(move |stack, env, _| {
            let a3 = stack.bool();
            let a2 = stack.float();
            let a1 = stack.bools();
            let a0 = stack.bools();
            let value = func::set_elements_at(env, a0, a1, a2, a3);
            stack.push_bools(value);
        }),
        "set_elements_at(bools, bools, float, bools)" => FunctionCall::new(move |stack, env, _| {
            let a3 = stack.bools();
            let a2 = stack.float();
            let a1 = stack.bools();
            let a0 = stack.bools();
            let value = func::set_elements_at(env, a0, a1, a2, a3);
            stack.push_bools(value);
        }),
        "set_elements_at(bools, bools, floats, bool)" => FunctionCall::new(move |stack, env, _| {
            let a3 = stack.bool();
            let a2 = stack.floats();
            let a1 = stack.bools();
            let a0 = stack.bools();
            let value = func::set_elements_at(env, a0, a1, a2, a3);
            stack.push_bools(value);
        }),
        "set_elements_at(bools, bools, floats, bools)" => FunctionCall::new(move |stack, env, _| {
            let a3 = stack.bools();
            let a2 = stack.floats();
            let a1 = stack.bools();
            let a0 = stack.bools();
            let value = func::set_elements_at(env, a0, a1, a2, a3);
            stack.push_bools(value);
        }),
        "set_elements_at(bools, float, bools, bool)" => FunctionCall::new(move |stack, env, _| {
            let a3 = stack.bool();
            let a2 = stack.bools();
            let a1 = stack.float();
            let a0 = stack.bools();
            let value = func::set_elements_at(env, a0, a1, a2, a3);
            stack.push_bools(value);
        }),
        "set_elements_at(bools, float, bools, bools)" => FunctionCall::new(move |stack, env, _| {
            let a3 = stack.bools();
            let a2 = stack.bools();
            let a1 = stack.float();
            let a0 = stack.bools();
            let value = func::set_elements_at(env, a0, a1, a2, a3);
            stack.push_bools(value);
        }),
        "set_elements_at(bools, float, float, bool)" => FunctionCall::new(move |stack, env, _| {
            let a3 = stack.bool();
            let a2 = stack.float();
            let a1 = stack.float();
            let a0 = stack.bools();
            let value = func::set_elements_at(env, a0, a1, a2, a3);
            stack.push_bools(value);
        }),
        "set_elements_at(bools, float, float, bools)" => FunctionCall::new(move |stack, env, _| {
            let a3 = stack.bools();
            let a2 = stack.float();
            let a1 = stack.float();
            let a0 = stack.bools();
            let value = func::set_elements_at(env, a0, a1, a2, a3);
            stack.push_bools(value);
        }),
        "set_elements_at(bools, float, floats, bool)" => FunctionCall::new(move |stack, env, _| {
            let a3 = stack.bool();
            let a2 = stack.floats();
            let a1 = stack.float();
            let a0 = stack.bools();
            let value = func::set_elements_at(env, a0, a1, a2, a3);
            stack.push_bools(value);
        }),
        "set_elements_at(bools, float, floats, bools)" => FunctionCall::new(move |stack, env, _| {
            let a3 = stack.bools();
            let a2 = stack.floats();
            let a1 = stack.float();
            let a0 = stack.bools();
            let value = func::set_elements_at(env, a0, a1, a2, a3);
            stack.push_bools(value);
        }),
        "set_elements_at(bools, floats, bools, bool)" => FunctionCall::new(move |stack, env, _| {
            let a3 = stack.bool();
            let a2 = stack.bools();
            let a1 = stack.floats();
            let a0 = stack.bools();
            let value = func::set_elements_at(env, a0, a1, a2, a3);
            stack.push_bools(value);
        }),
        "set_elements_at(bools, floats, bools, bools)" => FunctionCall::new(move |stack, env, _| {
            let a3 = stack.bools();
            let a2 = stack.bools();
            let a1 = stack.floats();
            let a0 = stack.bools();
            let value = func::set_elements_at(env, a0, a1, a2, a3);
            stack.push_bools(value);
        }),
        "set_elements_at(bools, floats, float, bool)" => FunctionCall::new(move |stack, env, _| {
            let a3 = stack.bool();
            let a2 = stack.float();
            let a1 = stack.floats();
            let a0 = stack.bools();
            let value = func::set_elements_at(env, a0, a1, a2, a3);
            stack.push_bools(value);
        }),
        "set_elements_at(bools, floats, float, bools)" => FunctionCall::new(move |stack, env, _| {
            let a3 = stack.bools();
            let a2 = stack.float();
            let a1 = stack.floats();
            let a0 = stack.bools();
            let value = func::set_elements_at(env, a0, a1, a2, a3);
            stack.push_bools(value);
        }),
        "set_elements_at(bools, floats, floats, bool)" => FunctionCall::new(move |stack, env, _| {
            let a3 = stack.bool();
            let a2 = stack.floats();
            let a1 = stack.floats();
            let a0 = stack.bools();
            let value = func::set_elements_at(env, a0, a1, a2, a3);
            stack.push_bools(value);
        }),
        "set_elements_at(bools, floats, floats, bools)" => FunctionCall::new(move |stack, env, _| {
            let a3 = stack.bools();
            let a2 = stack.floats();
            let a1 = stack.floats();
            let a0 = stack.bools();
            let value = func::set_elements_at(env, a0, a1, a2, a3);
            stack.push_bools(value);
        }),
        _ => return None,
    })
}
