//! The three sources of rules: Rust tokens, string literals and files. A source knows where token n is; nothing else does.

mod content;
mod file;
mod import;
mod literal;
mod quoted;
mod rules;
pub(crate) mod tokens;

use proc_macro2::{Ident, Span};

pub(crate) use import::Imports;
pub(crate) use rules::{Host, Source};

use crate::header::{Header, RulesText};
use crate::problem::Problem;

/// Opens the source that the header names.
pub(crate) fn open(header: &Header, body: RulesText) -> Result<Source, Problem> {
    match body {
        RulesText::Inline(stream) => {
            let end = header.name.as_ref().map_or_else(Span::call_site, Ident::span);
            Ok(tokens::read(stream, end))
        }
        RulesText::Text(literals) => literal::read(&literals),
        RulesText::File(literal) => file::read(&literal),
    }
}
