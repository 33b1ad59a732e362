//! Calls of operations with the same successor for each part.
//!
//! Generated from the tables of `cga-lang`; write it again with `CGA_BLESS=1 cargo test -p cga-lang --test dispatch`.

use crate::dispatch::{EachCall, Known as _, words};
use cga_lang::ir::Arg;
use cga_runtime::rt::{self, op};

/// The call of an operation of this form, by the key of its row.
pub(crate) fn call(key: &str, known: &[Arg]) -> Option<EachCall> {
    Some(match key {
        "scatter(ScatterDomain, float, Distribution)" => {
            let a0 = words::op_scatter_domain(known.word(0)?)?;
            let a2 = words::op_distribution(known.word(2)?)?;
            EachCall::new(move |stack, cx, shape, number, visit| {
                let a1 = stack.float();
                rt::each(cx, shape, number, |env, shape| op::scatter(env, shape, a0, a1, a2), visit)
            })
        }
        "scatter_around(ScatterDomain, float, Distribution, ScatterMean, length)" => {
            let a0 = words::op_scatter_domain(known.word(0)?)?;
            let a2 = words::op_distribution(known.word(2)?)?;
            let a3 = words::op_scatter_mean(known.word(3)?)?;
            let length4 = known.length(4);
            EachCall::new(move |stack, cx, shape, number, visit| {
                let a4 = length4.of(stack.float());
                let a1 = stack.float();
                rt::each(cx, shape, number, |env, shape| op::scatter_around(env, shape, a0, a1, a2, a3, a4), visit)
            })
        }
        _ => return None,
    })
}
