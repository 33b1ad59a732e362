//! `in "rules/tower.cga"`: rules in a file below the package.

use std::fs::File;
use std::io::{Error, ErrorKind, Read};
use std::path::{Component, Path};

use cga_lang::lex::{decode, lex};
use cga_lang::link::stray_character;
use proc_macro2::{Literal, TokenStream};
use quote::quote;

use super::content::value;
use super::literal::source;
use super::rules::{QuotedText, Source};
use crate::problem::Problem;

pub(super) fn read(literal: &Literal) -> Result<Source, Problem> {
    let span = literal.span();
    let problem = |message: String| Problem::new(span, span, message);
    let path = value(literal).ok_or_else(|| problem("the path of a rule file is a plain string".into()))?;
    if !stays_inside(Path::new(&path)) {
        // Whoever gets the package would not have the file.
        return Err(problem(format!("`{path}` is no path inside the package\nhelp: {FROM_PACKAGE}")));
    }
    if let Some(stray) = stray_character(&path) {
        return Err(problem(format!("the name of a rule file has no `{stray}`\nhelp: rename the file")));
    }
    // By the package and not by the calling file: editors' macro servers don't know that one.
    let folder = std::env::var("CARGO_MANIFEST_DIR").unwrap_or_default();
    let file = Path::new(&folder).join(&path);
    let text = text(&file).map_err(|error| {
        // A build that has failed is done again anyway, so nothing has to be tracked here.
        problem(match error.kind() {
            _ if file.is_dir() => format!("`{path}` is a folder\nhelp: name the rule file in it"),
            ErrorKind::NotFound => format!("there is no file `{path}`\nhelp: {FROM_PACKAGE}"),
            _ => format!("`{path}` cannot be read: {error}"),
        })
    })?;
    let lexed = lex(&text);
    let place = QuotedText { name: path.replace('\\', "/"), written: text, ranges: lexed.ranges };
    Ok(source(lexed.tokens, lexed.diags, span, place, tracking(literal)))
}

const FROM_PACKAGE: &str = "paths count from the folder that has the package's Cargo.toml";

/// Whether a path leads to no place outside the folder it counts from, as far as its words tell.
fn stays_inside(path: &Path) -> bool {
    let mut depth = 0_usize;
    path.components().all(|part| match part {
        Component::Normal(_) => {
            depth += 1;
            true
        }
        Component::CurDir => true,
        Component::ParentDir => {
            let inside = 0 < depth;
            depth = depth.saturating_sub(1);
            inside
        }
        Component::RootDir | Component::Prefix(_) => false,
    })
}

/// Most bytes of a rule file. The largest ones people have published have less than a hundredth of it.
const MOST_BYTES: u64 = 64 << 20;

/// The text of a file, if it is one: a device never ends.
pub(super) fn text(file: &Path) -> Result<String, Error> {
    let about = std::fs::metadata(file)?;
    if !about.is_file() {
        return Err(Error::other("it is no regular file"));
    }
    let mut bytes = Vec::new();
    File::open(file)?.take(MOST_BYTES + 1).read_to_end(&mut bytes)?;
    if MOST_BYTES < bytes.len() as u64 {
        return Err(Error::other("it has more than 64 MB"));
    }
    Ok(decode(&bytes).into_owned())
}

/// Makes the build follow the file, in the error case as well; the user's own literal keeps machine paths out.
pub(super) fn tracking(literal: &Literal) -> TokenStream {
    quote! {
        const _: &[u8] = ::core::include_bytes!(::core::concat!(::core::env!("CARGO_MANIFEST_DIR"), "/", #literal));
    }
}
