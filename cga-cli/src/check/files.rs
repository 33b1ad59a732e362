//! Rule files on disk: found, read once and remembered.

use cga_lang::compile::Dialect;
use cga_lang::diag::Diags;
use cga_lang::link::{Files, Unit, candidates, folder};
use cga_lang::snippet::{Lines, Quote};
use cga_lang::syntax::lex::{Lexed, MOST_BYTES, TOO_LONG, decode, lex};
use cga_lang::syntax::parse::parse;
use std::cell::OnceCell;
use std::collections::{HashMap, HashSet};
use std::fs::{self, File};
use std::io::Read as _;
use std::path::{Component, Path, PathBuf};

/// The rule files among some paths, in order, each once; and what could not be read.
pub(crate) fn find(paths: &[PathBuf]) -> (Vec<PathBuf>, Vec<String>) {
    let (mut list, mut unread) = (Vec::new(), Vec::new());
    for path in paths {
        if path.is_dir() { walk(path, &mut list, &mut unread) } else { list.push(path.clone()) }
    }
    let mut seen = std::collections::HashSet::new();
    list.retain(|path| seen.insert(path.clone()));
    (list, unread)
}

fn walk(top: &Path, list: &mut Vec<PathBuf>, unread: &mut Vec<String>) {
    let mut folders = vec![top.to_owned()];
    while let Some(folder) = folders.pop() {
        let entries = match fs::read_dir(&folder).and_then(|entries| entries.collect::<Result<Vec<_>, _>>()) {
            Ok(entries) => entries,
            Err(why) => {
                unread.push(format!("{}: {why}", folder.display()));
                continue;
            }
        };
        let mut inner = Vec::new();
        let mut own = Vec::new();
        for entry in entries {
            let path = entry.path();
            // A link to a folder is not followed: it may lead back.
            if entry.file_type().is_ok_and(|kind| kind.is_dir()) {
                inner.push(path);
            } else if path.extension().is_some_and(|end| end.eq_ignore_ascii_case("cga")) && path.is_file() {
                own.push(path);
            }
        }
        own.sort();
        inner.sort();
        list.extend(own);
        folders.extend(inner.into_iter().rev());
    }
}

/// A file that was read.
struct LoadedFile {
    /// As it is shown.
    name: String,
    text: String,
    lexed: Lexed,
}

/// Every file so far.
#[derive(Default)]
pub(crate) struct LoadedFiles {
    entries: Vec<LoadedFile>,
    /// By name.
    known: HashMap<String, usize>,
    /// The folder that paths and links must not lead out of.
    root: Option<Root>,
}

/// The folder of `--root`.
struct Root {
    /// As it is shown.
    name: String,
    /// With links resolved.
    path: PathBuf,
}

impl Root {
    /// The message about a file that is not read. It is the same for files that do not exist, so rules cannot find out
    /// which files exist outside.
    fn outside(&self) -> String {
        format!(
            "it is not a file in `{}`, and paths and links that lead out of this folder are not followed",
            self.name
        )
    }
}

impl LoadedFiles {
    /// No files yet. `root` is the folder that paths and links must not lead out of.
    pub(crate) fn new(root: Option<&Path>) -> Result<Self, String> {
        let Some(root) = root else { return Ok(LoadedFiles::default()) };
        let name = root.display().to_string();
        let path = root.canonicalize().map_err(|why| format!("{name}: {why}"))?;
        if !path.is_dir() {
            return Err(format!("{name}: it is not a folder"));
        }
        Ok(LoadedFiles { root: Some(Root { name, path }), ..LoadedFiles::default() })
    }

    /// The path with links resolved, if there is a folder that it must not lead out of.
    fn resolved(&self, path: &Path) -> Result<PathBuf, String> {
        let Some(root) = &self.root else { return Ok(path.to_owned()) };
        path.canonicalize().ok().filter(|real| real.starts_with(&root.path)).ok_or_else(|| root.outside())
    }

    /// Reads a file, unless that was done.
    pub(crate) fn load(&mut self, path: &Path) -> Result<usize, String> {
        let name = written(path);
        if let Some(&number) = self.known.get(&name) {
            return Ok(number);
        }
        let path = &self.resolved(path)?;
        // A device never ends.
        if !fs::metadata(path).map_err(|why| why.to_string())?.is_file() {
            return Err("not a regular file".into());
        }
        let mut bytes = Vec::new();
        let file = File::open(path).map_err(|why| why.to_string())?;
        file.take(MOST_BYTES as u64 + 1).read_to_end(&mut bytes).map_err(|why| why.to_string())?;
        if MOST_BYTES < bytes.len() {
            return Err(TOO_LONG.into());
        }
        let text = decode(&bytes).into_owned();
        let lexed = lex(&text);
        self.entries.push(LoadedFile { name: name.clone(), text, lexed });
        self.known.insert(name, self.entries.len() - 1);
        Ok(self.entries.len() - 1)
    }

    pub(crate) fn unit(&self, number: usize) -> Unit {
        let entry = &self.entries[number];
        Unit {
            name: entry.name.clone(),
            tokens: entry.lexed.tokens.clone(),
            dialect: Dialect::Text,
            found: entry.lexed.diags.clone(),
        }
    }

    pub(crate) fn text(&self, number: usize) -> &str {
        &self.entries[number].text
    }

    /// The names of the files that files import. Files that cannot be read import nothing.
    pub(crate) fn imported(&mut self, numbers: &[usize]) -> HashSet<String> {
        let mut imported = HashSet::new();
        for &number in numbers {
            let unit = self.unit(number);
            if !unit.tokens.as_slice().iter().any(|token| token.ident() == Some("import")) {
                continue;
            }
            let mut diags = Diags::new();
            let imports = parse(&unit.tokens, &mut diags).imports;
            // The compiler reports the same.
            diags.finish();
            let opened = imports.iter().filter_map(|import| self.open(&import.path, &unit.name).ok());
            imported.extend(opened.map(|unit| unit.name));
        }
        imported
    }

    /// Returns the file of a name as findings quote it. `lines` is filled at the first call.
    pub(crate) fn quote<'t>(&'t self, name: &str, lines: &'t OnceCell<Lines<'t>>) -> Option<Quote<'t>> {
        let entry = &self.entries[*self.known.get(name)?];
        let lines = lines.get_or_init(|| Lines::new(&entry.text));
        Some(Quote { name: &entry.name, lines, ranges: &entry.lexed.ranges })
    }
}

impl Files for LoadedFiles {
    fn open(&mut self, path: &str, from: &str) -> Result<Unit, String> {
        // From the root, because the folders above the current one count too.
        let from = std::path::absolute(from).map_err(|why| why.to_string())?;
        let names = candidates(path, &from.to_string_lossy());
        let found = names.iter().map(PathBuf::from).find(|path| path.is_file());
        let found = found.ok_or_else(|| match &self.root {
            Some(root) => root.outside(),
            None => "there is no such file beside this one or in a folder above".into(),
        })?;
        let here = std::env::current_dir().unwrap_or_default();
        let number = self.load(found.strip_prefix(here).unwrap_or(&found))?;
        Ok(self.unit(number))
    }

    fn beside(&mut self, path: &str, from: &str) -> Vec<String> {
        let Ok(from) = std::path::absolute(from) else { return Vec::new() };
        let Ok(folder) = self.resolved(Path::new(&folder(path, &from.to_string_lossy()))) else { return Vec::new() };
        let entries = fs::read_dir(folder).into_iter().flatten().flatten();
        entries.filter_map(|entry| entry.file_name().into_string().ok()).collect()
    }
}

/// A path as messages show it: the same for one file, however it was reached, as long as no links are in the way.
fn written(path: &Path) -> String {
    let here = std::env::current_dir().unwrap_or_default();
    let short = path.strip_prefix(here).unwrap_or(path);
    let parts: PathBuf = short.components().filter(|part| *part != Component::CurDir).collect();
    parts.to_string_lossy().replace('\\', "/")
}
