//! `in "rules/tower.cga"`: rules in a file below the package.

use std::io::ErrorKind;
use std::path::{Component, Path};

use cga_lang::link::stray_character;
use cga_lang::syntax::lex::lex;
use proc_macro2::Literal;

use super::content::value;
use super::literal::source;
use super::quoted::{QuotedText, text, tracking};
use super::rules::Source;
use crate::problem::Problem;

pub(super) fn read(literal: &Literal) -> Result<Source, Problem> {
    let span = literal.span();
    let problem = |message: String| Problem::new(span, span, message);
    let path = value(literal).ok_or_else(|| problem("the path of a rule file must be a string literal".into()))?;
    if !stays_inside(Path::new(&path)) {
        // Whoever gets the package would not have the file.
        return Err(problem(format!("the path `{path}` leaves the package\nhelp: {FROM_PACKAGE}")));
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

/// Returns true if a path stays inside the folder that it starts from, judged by its components alone.
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
