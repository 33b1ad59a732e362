//! CGA rules that are loaded at run time.
#![forbid(unsafe_code)]

mod call;
mod code;
mod compile;
mod current;
mod dispatch;
mod intern;
mod object;
mod program;
mod run;
mod stack;
mod steps;
