//! What the macro makes of its input, without a compiler around it.

mod doors;
mod errors;
mod expand;
mod mistakes;
mod rows;
mod ui;
