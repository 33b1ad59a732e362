//! Calls of operations with operands.
//!
//! Generated from the tables of `cga-lang`; write it again with `CGA_BLESS=1 cargo test -p cga-lang --test dispatch`.

use crate::dispatch::{Known as _, OperandsCall, words};
use cga_lang::ir::Arg;
use cga_runtime::rt::op;

/// The call of an operation of this form, by the key of its row.
pub(crate) fn call(key: &str, known: &[Arg]) -> Option<OperandsCall> {
    Some(match key {
        "inline(MergeStrategy)" => {
            let a0 = words::op_merge_strategy(known.word(0)?)?;
            OperandsCall::new(move |_, env, shape, operands| {
                op::inline(env, shape, operands.try_into().unwrap_or_default(), a0)
            })
        }
        "intersect()" => OperandsCall::new(move |_, env, shape, operands| {
            op::intersect(env, shape, operands.try_into().unwrap_or_default())
        }),
        "intersect_current(SwapMode)" => {
            let a0 = words::op_swap_mode(known.word(0)?)?;
            OperandsCall::new(move |_, env, shape, operands| {
                op::intersect_current(env, shape, operands.try_into().unwrap_or_default(), a0)
            })
        }
        "modify(Components, Align)" => {
            let a0 = words::op_components(known.word(0)?)?;
            let a1 = words::op_align(known.word(1)?)?;
            OperandsCall::new(move |_, env, shape, operands| {
                op::modify(env, shape, operands.try_into().unwrap_or_default(), a0, a1)
            })
        }
        "subtract()" => OperandsCall::new(move |_, env, shape, operands| {
            op::subtract(env, shape, operands.try_into().unwrap_or_default())
        }),
        "subtract_current(SwapMode)" => {
            let a0 = words::op_swap_mode(known.word(0)?)?;
            OperandsCall::new(move |_, env, shape, operands| {
                op::subtract_current(env, shape, operands.try_into().unwrap_or_default(), a0)
            })
        }
        "union()" => OperandsCall::new(move |_, env, shape, operands| {
            op::union(env, shape, operands.try_into().unwrap_or_default())
        }),
        "union_current(SwapMode)" => {
            let a0 = words::op_swap_mode(known.word(0)?)?;
            OperandsCall::new(move |_, env, shape, operands| {
                op::union_current(env, shape, operands.try_into().unwrap_or_default(), a0)
            })
        }
        _ => return None,
    })
}
