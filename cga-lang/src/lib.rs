//! The CGA language: tokens, parser, checks, lowering. Knows nothing of Rust macros and does no IO.
//!
//! ```text
//! door ─► Tokens ─► parse ─► Ast ─► link ─► check ─► Checked ─► lower ─► ir::Grammar
//! ```
//!
//! - A door (this crate's [`lex`](lex::lex), or a macro's token stream) brings [`Tokens`](token::Tokens). Only the door
//!   knows where a token is on screen; everything here speaks of tokens by index ([`Span`](span::Span)).
//! - [`parse`](parse::parse) never fails, never panics and always ends: it returns the tree it could build.
//! - [`link`] reads what is imported: a file once for each place and style it is used in.
//! - [`check`] reads the trees and writes side tables. It makes a [`Checked`](check::Checked) only when there was no
//!   error, and only that can be lowered.
//! - lowering turns names into indices and blocks into rules.
//!
//! [`compile`](compile::compile) is the whole way in one call.
//!
//! ```
//! use cga_lang::compile::compile_text;
//!
//! let source = compile_text("attr h = 3  Lot --> extrude(h) Wall.");
//! assert!(source.compiled.diags.is_empty());
//! assert_eq!(source.compiled.grammar.unwrap().rules.len(), 1);
//! ```
#![forbid(unsafe_code)]

mod analysis;
mod annotations;
pub mod ast;
pub mod ast_walk;
pub mod check;
pub mod code;
pub mod compile;
pub mod diag;
mod diagnostics;
mod door;
pub mod facts;
mod fold;
pub mod graph;
mod hash;
pub mod index;
mod infer;
pub mod ir;
pub mod ir_print;
pub mod ir_walk;
pub mod lex;
pub mod link;
mod lower;
pub mod ops;
pub mod parse;
mod resolve;
pub mod skeleton;
pub mod snippet;
pub mod span;
pub mod token;
mod types;
mod words;

use cga_split::suggest;
