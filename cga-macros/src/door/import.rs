//! Files that rules import: looked for below the package, like the file behind `in`.

use std::path::PathBuf;

use cga_lang::compile::Door;
use cga_lang::lex::lex;
use cga_lang::link::{Files, Unit, candidates, folder};
use proc_macro2::{Literal, TokenStream};

use super::TextPlace;
use super::file::{text, tracking};

/// Opens imported files and remembers them: findings quote from them, and the build follows them.
pub(crate) struct Imports {
    /// The package's folder.
    root: PathBuf,
    /// In the order in which they were opened first.
    opened: Vec<Imported>,
}

/// A file that was imported.
pub(crate) struct Imported {
    pub(super) text: TextPlace,
    /// The path behind the `import` of the rules themselves that led to it.
    pub(super) path: String,
}

impl Imports {
    pub(crate) fn new() -> Self {
        let root = std::env::var_os("CARGO_MANIFEST_DIR").map(PathBuf::from).unwrap_or_default();
        Imports { root, opened: Vec::new() }
    }

    /// The files.
    pub(crate) fn opened(self) -> Vec<Imported> {
        self.opened
    }
}

impl Files for Imports {
    fn open(&mut self, path: &str, from: &str) -> Result<Unit, String> {
        // A machine's own paths have no place in a package.
        let inside = |name: &String| !name.starts_with("..") && !name.starts_with('/');
        let names: Vec<String> = candidates(path, from).into_iter().filter(inside).collect();
        let found = names.iter().find(|name| self.root.join(name).is_file());
        let Some(name) = found else {
            let first = names.first().map_or(path, String::as_str);
            return Err(format!("there is no file `{first}` in the package"));
        };
        let text = text(&self.root.join(name)).map_err(|error| error.to_string())?;
        let lexed = lex(&text);
        let named = |name: &str| self.opened.iter().find(|file| file.text.name == name);
        if named(name).is_none() {
            let path = named(from).map_or(path, |file| &file.path).to_owned();
            let text = TextPlace { name: name.clone(), written: text, ranges: lexed.ranges };
            self.opened.push(Imported { text, path });
        }
        Ok(Unit { name: name.clone(), tokens: lexed.tokens, door: Door::Text, found: lexed.diags })
    }

    fn beside(&mut self, path: &str, from: &str) -> Vec<String> {
        let folder = folder(path, from);
        if folder.starts_with("..") || folder.starts_with('/') {
            return Vec::new();
        }
        let entries = std::fs::read_dir(self.root.join(folder)).into_iter().flatten().flatten();
        entries.filter_map(|entry| entry.file_name().into_string().ok()).collect()
    }
}

/// Makes the build follow the imported files.
pub(super) fn follow(files: &[Imported]) -> TokenStream {
    files.iter().map(|file| tracking(&Literal::string(&file.text.name))).collect()
}
