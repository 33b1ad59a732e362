//! The words of parameters and selectors, as variants of enums of the runtime.

mod func;
mod op;
mod rt;

pub(crate) use func::*;
pub(crate) use op::*;
pub(crate) use rt::*;
