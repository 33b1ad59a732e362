//! Calls of operations with sections.
//!
//! Generated from the tables of `cga-lang`; write it again with `CGA_BLESS=1 cargo test -p cga-lang --test dispatch`.

use crate::dispatch::{Known as _, SectionsCall};
use cga_lang::ir::Arg;
use cga_runtime::rt::{self, op};

/// The call of an operation of this form, by the key of its row.
pub(crate) fn call(key: &str, known: &[Arg]) -> Option<SectionsCall> {
    Some(match key {
        "perimeter(length)" => {
            let length0 = known.length(0);
            SectionsCall::new(move |stack, cx, shape, number, pattern, rest, depth, visit| {
                let a0 = length0.of(stack.float());
                rt::sections(
                    cx,
                    shape,
                    number,
                    pattern,
                    rest,
                    depth,
                    |env, sections| op::perimeter(env, sections, a0),
                    visit,
                )
            })
        }
        "perimeter_of(length, float, bools)" => {
            let length0 = known.length(0);
            SectionsCall::new(move |stack, cx, shape, number, pattern, rest, depth, visit| {
                let a2 = stack.bools();
                let a1 = stack.float();
                let a0 = length0.of(stack.float());
                rt::sections(
                    cx,
                    shape,
                    number,
                    pattern,
                    rest,
                    depth,
                    |env, sections| op::perimeter_of(env, sections, a0, a1, a2),
                    visit,
                )
            })
        }
        _ => return None,
    })
}
