//! The macro's output for its input, without a compiler around it.

mod errors;
mod expand;
#[path = "../../../cga-lang/tests/front/ir_print/mod.rs"]
mod ir_print;
mod mistakes;
#[path = "../../../cga-lang/tests/front/print/mod.rs"]
mod print;
mod rows;
mod rt;
mod sources;
mod ui;
