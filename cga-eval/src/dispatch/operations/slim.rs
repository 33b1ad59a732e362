//! Calls of operations that change a slim shape.
//!
//! Generated from the tables of `cga-lang`; write it again with `CGA_BLESS=1 cargo test -p cga-lang --test dispatch`.

use crate::dispatch::{Known as _, SlimCall};
use cga_lang::ir::Arg;
use cga_runtime::rt::slim;

/// The call of an operation of this form, by the key of its row.
pub(crate) fn call(key: &str, known: &[Arg]) -> Option<SlimCall> {
    Some(match key {
        "extrude(length)" => {
            let length0 = known.length(0);
            SlimCall::new(move |stack, env, shape, bases, own| {
                let a0 = length0.of(stack.float());
                slim::extrude(env, shape, bases, own, a0)
            })
        }
        "size(length, length, length)" => {
            let length0 = known.length(0);
            let length1 = known.length(1);
            let length2 = known.length(2);
            SlimCall::new(move |stack, env, shape, bases, own| {
                let a2 = length2.of(stack.float());
                let a1 = length1.of(stack.float());
                let a0 = length0.of(stack.float());
                slim::size(env, shape, bases, own, a0, a1, a2)
            })
        }
        "translate(length, length, length)" => {
            let length0 = known.length(0);
            let length1 = known.length(1);
            let length2 = known.length(2);
            SlimCall::new(move |stack, env, shape, bases, own| {
                let a2 = length2.of(stack.float());
                let a1 = length1.of(stack.float());
                let a0 = length0.of(stack.float());
                slim::translate(env, shape, bases, own, a0, a1, a2)
            })
        }
        _ => return None,
    })
}
