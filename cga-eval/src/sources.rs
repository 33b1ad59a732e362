//! The rule files of a program: in memory, or in a folder.

use std::cell::OnceCell;
use std::collections::{BTreeMap, HashMap};
use std::fs::{self, File};
use std::io::Read as _;
use std::path::{Component, Path, PathBuf};

use cga_lang::compile::Dialect;
use cga_lang::link::{Files, Unit, candidates, folder};
use cga_lang::snippet::{Lines, Quote};
use cga_lang::syntax::lex::{Lexed, MOST_BYTES, TOO_LONG, decode, lex};

/// A file that was read.
#[derive(Debug)]
struct LoadedFile {
    /// The name in messages, with forward slashes.
    name: String,
    text: String,
    lexed: Lexed,
}

/// The files so far, and where others are looked for.
#[derive(Debug, Default)]
pub(crate) struct Sources {
    /// Files in memory by their names.
    memory: BTreeMap<String, String>,
    /// True if files are read from the disk.
    reads_disk: bool,
    /// The folder that names are relative to, and that paths and links must not lead out of.
    root: Option<PathBuf>,
    entries: Vec<LoadedFile>,
    known: HashMap<String, usize>,
}

impl Sources {
    /// Files in memory, and files on the disk if `reads_disk`.
    pub(crate) fn new(memory: BTreeMap<String, String>, reads_disk: bool, root: Option<&Path>) -> Result<Self, String> {
        let root = root.map(|root| {
            root.canonicalize().map_err(|why| format!("cannot read the folder `{}`: {why}", root.display()))
        });
        Ok(Sources { memory, reads_disk, root: root.transpose()?, ..Sources::default() })
    }

    /// Adds a text as a file.
    pub(crate) fn add(&mut self, name: &str, text: String) -> Unit {
        let lexed = lex(&text);
        self.known.insert(name.to_owned(), self.entries.len());
        self.entries.push(LoadedFile { name: name.to_owned(), text, lexed });
        self.unit(self.entries.len() - 1)
    }

    /// Reads a file from the disk.
    pub(crate) fn read(&mut self, path: &Path) -> Result<Unit, String> {
        let path = match &self.root {
            Some(root) => root.join(path),
            None => path.to_owned(),
        };
        let name = self.written(&path);
        if let Some(&number) = self.known.get(&name) {
            return Ok(self.unit(number));
        }
        let path = self.resolved(&path)?;
        // A device never ends.
        if !fs::metadata(&path).map_err(|why| why.to_string())?.is_file() {
            return Err("it is not a regular file".into());
        }
        let mut bytes = Vec::new();
        let file = File::open(&path).map_err(|why| why.to_string())?;
        file.take(MOST_BYTES as u64 + 1).read_to_end(&mut bytes).map_err(|why| why.to_string())?;
        if MOST_BYTES < bytes.len() {
            return Err(TOO_LONG.into());
        }
        Ok(self.add(&name, decode(&bytes).into_owned()))
    }

    fn unit(&self, number: usize) -> Unit {
        let entry = &self.entries[number];
        Unit {
            name: entry.name.clone(),
            tokens: entry.lexed.tokens.clone(),
            dialect: Dialect::Text,
            found: entry.lexed.diags.clone(),
        }
    }

    /// The path with links resolved, if there is a folder that it must not lead out of.
    fn resolved(&self, path: &Path) -> Result<PathBuf, String> {
        let Some(root) = &self.root else { return Ok(path.to_owned()) };
        let outside = || {
            "it is not a file in the folder of the rules, and paths and links that lead out of it are not followed"
                .to_owned()
        };
        path.canonicalize().ok().filter(|real| real.starts_with(root)).ok_or_else(outside)
    }

    /// A path as messages show it, and from where files that it names are looked for.
    fn written(&self, path: &Path) -> String {
        let base = self.root.clone().or_else(|| std::env::current_dir().ok()).unwrap_or_default();
        let short = path.strip_prefix(&base).unwrap_or(path);
        let parts: PathBuf = short.components().filter(|part| *part != Component::CurDir).collect();
        parts.to_string_lossy().replace('\\', "/")
    }

    /// An absolute path for the name of a file.
    fn absolute(&self, name: &str) -> Option<String> {
        let path = match &self.root {
            Some(root) => root.join(name),
            None => std::path::absolute(name).ok()?,
        };
        Some(path.to_string_lossy().into_owned())
    }

    /// The names and texts of the files that were read, sorted by name.
    pub(crate) fn files(&self) -> Vec<(String, String)> {
        let mut files: Vec<_> = self.entries.iter().map(|file| (file.name.clone(), file.text.clone())).collect();
        files.sort_unstable();
        files
    }

    /// The file of a name as findings quote it. `lines` is filled at the first call.
    pub(crate) fn quote<'t>(&'t self, name: &str, lines: &'t OnceCell<Lines<'t>>) -> Option<Quote<'t>> {
        let entry = &self.entries[*self.known.get(name)?];
        let lines = lines.get_or_init(|| Lines::new(&entry.text));
        Some(Quote { name: &entry.name, lines, ranges: &entry.lexed.ranges })
    }
}

impl Files for Sources {
    fn open(&mut self, path: &str, from: &str) -> Result<Unit, String> {
        for name in candidates(path, from) {
            if let Some(&number) = self.known.get(&name) {
                return Ok(self.unit(number));
            }
            if let Some(text) = self.memory.remove(&name) {
                return Ok(self.add(&name, text));
            }
        }
        if !self.reads_disk {
            return Err("there is no file of that name; add it with `with_file`".into());
        }
        let from = self.absolute(from).ok_or("the folder of the program is not known")?;
        let found = candidates(path, &from).into_iter().map(PathBuf::from).find(|path| path.is_file());
        let found = found.ok_or("there is no such file beside this one or in a folder above")?;
        self.read(&found)
    }

    fn beside(&mut self, path: &str, from: &str) -> Vec<String> {
        let near = folder(path, from);
        let in_memory = self.memory.keys().filter_map(|name| match name.rsplit_once('/') {
            Some((folder, file)) => (folder == near).then_some(file),
            None => near.is_empty().then_some(name.as_str()),
        });
        let mut names: Vec<String> = in_memory.map(str::to_owned).collect();
        if self.reads_disk
            && let Some(from) = self.absolute(from)
            && let Ok(folder) = self.resolved(Path::new(&folder(path, &from)))
        {
            let entries = fs::read_dir(folder).into_iter().flatten().flatten();
            names.extend(entries.filter_map(|entry| entry.file_name().into_string().ok()));
        }
        names
    }
}
