//! `in "rules/tower.cga"`: rules in a file below the package.

use std::io::ErrorKind;
use std::path::Path;

use cga_lang::lex::{decode, lex};
use proc_macro2::{Literal, TokenStream};
use quote::quote;

use super::content::value;
use super::literal::source;
use super::{Problem, Source, TextPlace};

pub(super) fn read(literal: &Literal) -> Result<Source, Problem> {
    let span = literal.span();
    let problem = |message: String| Problem::new(span, span, message);
    let path = value(literal).ok_or_else(|| problem("the path of a rule file is a plain string".into()))?;
    if Path::new(&path).has_root() {
        // A machine's own paths have no place in a package.
        return Err(problem(format!("`{path}` is no path inside the package\nhelp: {FROM_PACKAGE}")));
    }
    // By the package and not by the calling file: editors' macro servers don't know that one.
    let folder = std::env::var("CARGO_MANIFEST_DIR").unwrap_or_default();
    let file = Path::new(&folder).join(&path);
    let bytes = std::fs::read(&file).map_err(|error| {
        // A build that has failed is done again anyway, so nothing has to be tracked here.
        problem(match error.kind() {
            _ if file.is_dir() => format!("`{path}` is a folder\nhelp: name the rule file in it"),
            ErrorKind::NotFound => format!("there is no file `{path}`\nhelp: {FROM_PACKAGE}"),
            _ => format!("`{path}` cannot be read: {error}"),
        })
    })?;
    let text = decode(&bytes).into_owned();
    let lexed = lex(&text);
    let place = TextPlace { name: path.replace('\\', "/"), written: text, ranges: lexed.ranges };
    Ok(source(lexed.tokens, lexed.diags, span, place, tracking(literal)))
}

const FROM_PACKAGE: &str = "paths count from the folder that has the package's Cargo.toml";

/// Makes the build follow the file, in the error case as well; the user's own literal keeps machine paths out.
pub(super) fn tracking(literal: &Literal) -> TokenStream {
    quote! {
        const _: &[u8] = ::core::include_bytes!(::core::concat!(::core::env!("CARGO_MANIFEST_DIR"), "/", #literal));
    }
}
