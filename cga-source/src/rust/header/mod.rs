//! The tokens before the rules: `#[doc] @Allow(…) pub grammar Tower`.

mod read;

use cga_lang::diag::Level;
use cga_lang::diag::code::Code;
use proc_macro2::{Ident, Literal, TokenStream};
use quote::format_ident;

pub use read::read;

/// The header of a grammar.
#[derive(Clone, Debug)]
pub struct Header {
    /// Outer attributes, doc comments among them.
    pub attributes: TokenStream,
    /// The attributes among them that decide whether the grammar exists.
    pub conditions: TokenStream,
    /// True with a doc comment.
    pub has_doc: bool,
    /// `pub` and the like; empty for the expression form.
    pub visibility: TokenStream,
    /// The struct; `None` for the expression form.
    pub name: Option<Ident>,
    /// Path to the runtime's hidden module.
    pub runtime: TokenStream,
    /// `@Allow(code)` and its like before the header: levels for the whole grammar.
    pub levels: Vec<(Code, Level)>,
}

/// The rules that follow a header.
#[derive(Clone, Debug)]
pub enum RulesText {
    /// Inline tokens; annotations that stood before the header come first.
    Inline(TokenStream),
    /// String literals, one after the other.
    Text(Vec<Literal>),
    /// A string literal that names a file.
    File(Literal),
}

impl Header {
    /// The struct's name. Rust code in the rules must not take the one of the expression form for its own.
    pub fn ident(&self) -> Ident {
        self.name.clone().unwrap_or_else(|| format_ident!("CgaGrammar"))
    }

    /// The grammar's name for the user; empty for the expression form.
    pub fn label(&self) -> String {
        self.name.as_ref().map(|name| name.to_string().trim_start_matches("r#").to_owned()).unwrap_or_default()
    }
}
