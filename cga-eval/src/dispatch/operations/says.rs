//! Calls of operations that give information to the run.
//!
//! Generated from the tables of `cga-lang`; write it again with `CGA_BLESS=1 cargo test -p cga-lang --test dispatch`.

use crate::current::view;
use crate::dispatch::{FunctionCall, Known as _};
use cga_lang::ir::Arg;
use cga_runtime::rt::op;

/// The call of an operation of this form, by the key of its row.
pub(crate) fn call(key: &str, known: &[Arg]) -> Option<FunctionCall> {
    Some(match key {
        "label(text)" => FunctionCall::new(move |stack, env, current| {
            let a0 = stack.text();
            view!(env, current, |shape| op::label(env, shape, a0,))
        }),
        "print(any)" => {
            let type0 = known.ty(0)?;
            FunctionCall::new(move |stack, env, current| {
                let a0 = stack.value(type0);
                view!(env, current, |shape| op::print(env, shape, a0,))
            })
        }
        "report(text, bool)" => FunctionCall::new(move |stack, env, current| {
            let a1 = stack.bool();
            let a0 = stack.text();
            view!(env, current, |shape| op::report(env, shape, a0, a1,))
        }),
        "report(text, float)" => FunctionCall::new(move |stack, env, current| {
            let a1 = stack.float();
            let a0 = stack.text();
            view!(env, current, |shape| op::report(env, shape, a0, a1,))
        }),
        "report(text, text)" => FunctionCall::new(move |stack, env, current| {
            let a1 = stack.text();
            let a0 = stack.text();
            view!(env, current, |shape| op::report(env, shape, a0, a1,))
        }),
        _ => return None,
    })
}
