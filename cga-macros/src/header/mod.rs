//! The tokens before the rules: `#[doc] @Allow(…) pub grammar Tower`.

mod read;

use cga_lang::diag::Level;
use cga_lang::diag::code::Code;
use proc_macro2::{Ident, Literal, TokenStream};
use quote::format_ident;

pub(crate) use read::read;

/// The header of a grammar.
pub(crate) struct Header {
    /// Outer attributes, doc comments among them.
    pub(crate) attributes: TokenStream,
    /// The attributes among them that decide whether the grammar exists.
    pub(crate) conditions: TokenStream,
    /// True with a doc comment.
    pub(crate) has_doc: bool,
    /// `pub` and the like; empty for the expression form.
    pub(crate) visibility: TokenStream,
    /// The struct; `None` for the expression form.
    pub(crate) name: Option<Ident>,
    /// Path to the runtime's hidden module.
    pub(crate) runtime: TokenStream,
    /// `@Allow(code)` and its like before the header: levels for the whole grammar.
    pub(crate) levels: Vec<(Code, Level)>,
}

/// The rules that follow a header.
pub(crate) enum RulesText {
    /// Inline tokens; annotations that stood before the header come first.
    Inline(TokenStream),
    /// String literals, one after the other.
    Text(Vec<Literal>),
    /// A string literal that names a file.
    File(Literal),
}

impl Header {
    /// The struct's name. Rust code in the rules must not take the one of the expression form for its own.
    pub(crate) fn ident(&self) -> Ident {
        self.name.clone().unwrap_or_else(|| format_ident!("CgaGrammar"))
    }

    /// The grammar's name for the user; empty for the expression form.
    pub(crate) fn label(&self) -> String {
        self.name.as_ref().map(|name| name.to_string().trim_start_matches("r#").to_owned()).unwrap_or_default()
    }
}
