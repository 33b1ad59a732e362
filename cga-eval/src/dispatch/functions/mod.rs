//! Calls of functions.

mod arrays;
mod plain;
mod run;
mod set_bools;
mod set_floats;
mod set_texts;
mod shape;

use cga_lang::ir::Expr;

use super::FunctionCall;

/// The call of a function, by the key of its row.
pub(super) fn call(key: &str, args: &[Expr]) -> Option<FunctionCall> {
    plain::call(key, args)
        .or_else(|| run::call(key, args))
        .or_else(|| arrays::call(key, args))
        .or_else(|| shape::call(key, args))
        .or_else(|| set_floats::call(key, args))
        .or_else(|| set_bools::call(key, args))
        .or_else(|| set_texts::call(key, args))
}
