//! The three sources of rules: Rust tokens, string literals and files. A source knows where token n is; nothing else does.

mod file;
mod import;
mod package;
mod rules;

use cga_source::rust::{Header, Problem, RulesText, read_inline, read_text};
use proc_macro2::{Ident, Span, TokenStream};

pub(crate) use import::Imports;
pub(crate) use rules::Source;

/// Opens the source that the header names.
pub(crate) fn open(header: &Header, body: RulesText) -> Result<Source, Problem> {
    match body {
        RulesText::Inline(stream) => {
            let end = header.name.as_ref().map_or_else(Span::call_site, Ident::span);
            Ok(Source::inline(read_inline(stream), end))
        }
        RulesText::Text(literals) => Ok(Source::text(read_text(&literals)?, TokenStream::new())),
        RulesText::File(literal) => file::read(&literal),
    }
}
