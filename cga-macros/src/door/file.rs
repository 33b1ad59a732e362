//! `in "rules/tower.cga"`: rules in a file below the package.

use cga_lang::lex::lex;
use proc_macro2::{Literal, TokenStream};
use quote::quote;

use super::literal::{source, value};
use super::{Problem, Source, TextPlace};

pub(super) fn read(literal: &Literal) -> Result<Source, Problem> {
    let span = literal.span();
    let path = value(literal).ok_or_else(|| Problem::new(span, "the path of a rule file is a plain string"))?;
    // By the package and not by the calling file: editors' macro servers don't know that one.
    let folder = std::env::var("CARGO_MANIFEST_DIR").unwrap_or_default();
    let tracking = tracking(literal);
    let bytes = std::fs::read(std::path::Path::new(&folder).join(&path)).map_err(|error| Problem {
        span,
        message: format!("`{path}` cannot be read: {error}\nhelp: paths count from the folder of the package"),
        tracking: tracking.clone(),
    })?;
    // Survives any bytes: what is no UTF-8 becomes a character that the lexer names.
    let text = String::from_utf8_lossy(&bytes).into_owned();
    let lexed = lex(&text);
    let place = TextPlace { name: path, written: text, ranges: lexed.ranges };
    Ok(source(lexed.tokens, lexed.diags, span, place, tracking))
}

/// Makes the build follow the file, in the error case as well; the user's own literal keeps machine paths out.
fn tracking(literal: &Literal) -> TokenStream {
    quote! {
        const _: &[u8] = ::core::include_bytes!(::core::concat!(::core::env!("CARGO_MANIFEST_DIR"), "/", #literal));
    }
}
