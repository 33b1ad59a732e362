//! The CGA language: tokens, parser, checks, lowering. It is independent of Rust macros and does no IO.
//!
//! ```text
//! source ─► tokens ─► parse ─► trees ─► link ─► resolve ─► infer ─► analysis ─► diagnostics ─► lower ─► IR
//! ```
//!
//! - A source (this crate's [`lex`](syntax::lex::lex), or a macro's token stream) makes [`Tokens`](syntax::token::Tokens). Only
//!   the source knows the place of a token on the screen; this crate refers to tokens by index ([`Span`](span::Span)).
//! - [`parse`](syntax::parse::parse) never fails, never panics and always ends: it returns the tree that it could build.
//! - [`link`] reads imports: each file once, with an instance for each style and import site.
//! - `resolve` finds the meaning of names, `infer` the types of values, `analysis` the possible values and shapes.
//!   `diagnostics` reports what follows from these.
//! - [`check`] makes a [`Checked`](check::Checked) only for a program without errors, and only that can be lowered.
//! - Lowering turns names into indices and blocks into rules.
//!
//! [`compile`](compile::compile) runs all stages.
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
pub mod check;
pub mod compile;
pub mod diag;
mod diagnostics;
mod dialect;
pub mod editor;
pub mod graph;
mod hash;
mod infer;
pub mod ir;
pub mod link;
mod lower;
pub mod ops;
pub mod reference;
mod resolve;
pub mod snippet;
pub mod span;
pub mod syntax;
mod types;

use cga_split::suggest;
