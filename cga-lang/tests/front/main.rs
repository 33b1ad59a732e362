//! The tests of the front half of the compiler: fixtures in `tests/data`, laws, and texts that must do no harm.

mod check;
mod common;
mod diagnostics;
mod facts;
mod ir_print;
mod lex;
mod link;
mod link_laws;
mod lower;
mod mistakes;
mod ops;
mod parse;
mod plan;
mod print;
mod reference;
mod robust;
