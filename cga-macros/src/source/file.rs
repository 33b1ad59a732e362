//! `in "rules/tower.cga"`: rules in a file below the package.

use std::io::{Error, ErrorKind};
use std::path::{Component, Path};

use cga_lang::link::stray_character;
use cga_lang::syntax::lex::lex;
use cga_source::rust::{Problem, QuotedText, TextTokens, value};
use proc_macro2::Literal;

use super::package::{text, tracking};
use super::rules::Source;

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
    // A build that has failed is done again anyway, so nothing has to be tracked here.
    let text = text(Path::new(&folder), &path).map_err(|error| problem(unreadable(&path, &error)))?;
    let lexed = lex(&text);
    let quoted = QuotedText { name: path.replace('\\', "/"), written: text, ranges: lexed.ranges };
    let tokens = TextTokens { tokens: lexed.tokens, found: lexed.diags, span, quoted };
    Ok(Source::text(tokens, tracking(literal)))
}

/// The message about a rule file that cannot be read.
fn unreadable(path: &str, error: &Error) -> String {
    match error.kind() {
        ErrorKind::IsADirectory => format!("`{path}` is a folder\nhelp: name the rule file in it"),
        ErrorKind::NotFound => format!("there is no file `{path}`\nhelp: {FROM_PACKAGE}"),
        _ => format!("`{path}` cannot be read: {error}"),
    }
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

#[cfg(all(test, unix))]
mod tests {
    use super::{text, unreadable};
    use cga_lang::syntax::lex::MOST_BYTES;
    use std::os::unix::fs::symlink;
    use std::{env, fs, process};

    #[test]
    fn a_file_of_many_bytes_is_refused() {
        let package = env::temp_dir().join(format!("cga-file-long-{}", process::id()));
        fs::create_dir_all(&package).unwrap();
        let rules = |bytes: usize| fs::write(package.join("lot.cga"), " ".repeat(bytes)).unwrap();
        rules(MOST_BYTES);
        assert_eq!(text(&package, "lot.cga").unwrap().len(), MOST_BYTES);
        rules(MOST_BYTES + 1);
        let message = unreadable("lot.cga", &text(&package, "lot.cga").expect_err("too long"));
        let why = "it has more than 1 MB; divide the rules into files that are imported";
        assert_eq!(message, format!("`lot.cga` cannot be read: {why}"));
        fs::remove_dir_all(&package).unwrap();
    }

    #[test]
    fn a_link_does_not_lead_out_of_the_package() {
        let root = env::temp_dir().join(format!("cga-file-links-{}", process::id()));
        let package = root.join("package");
        fs::create_dir_all(package.join("rules")).unwrap();
        fs::write(root.join("secret.cga"), "secret").unwrap();
        fs::write(package.join("rules/lot.cga"), "Lot --> X.").unwrap();
        symlink(root.join("secret.cga"), package.join("file.cga")).unwrap();
        symlink(&root, package.join("folder")).unwrap();
        symlink("rules/lot.cga", package.join("inside.cga")).unwrap();
        let message = |path: &str| unreadable(path, &text(&package, path).expect_err(path));
        for path in ["file.cga", "folder/secret.cga", "folder", "folder/package/../secret.cga"] {
            let why = "it is not a file in the package, and paths and links that lead out of it are not followed";
            assert_eq!(message(path), format!("`{path}` cannot be read: {why}"));
        }
        assert!(message("rules").contains("is a folder"));
        assert!(message("lot.cga").contains("there is no file"));
        assert_eq!(text(&package, "inside.cga").unwrap(), "Lot --> X.");
        // The package itself may be reached through a link.
        assert_eq!(text(&package.join("folder/package"), "rules/lot.cga").unwrap(), "Lot --> X.");
        fs::remove_dir_all(&root).unwrap();
    }
}
