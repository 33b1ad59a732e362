//! Tokens, trees and the parser.

pub mod ast;
pub mod lex;
pub mod parse;
pub mod token;
pub mod walk;
pub(crate) mod words;
pub(crate) mod written;
