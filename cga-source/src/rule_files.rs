//! The rule files of a program: in memory, or in a folder.

use std::cell::OnceCell;
use std::collections::{BTreeMap, HashMap};
use std::io::ErrorKind;
use std::path::{Component, Path, PathBuf};

use cga_lang::compile::Dialect;
use cga_lang::link::{Files, Unit, candidates, folder, normal};
use cga_lang::snippet::{Lines, Quote};
use cga_lang::syntax::lex::{Lexed, lex};

use crate::file_list::FileList;
use crate::read::read_text;
use crate::root::Root;

/// The name in messages of rules that come as text.
const TEXT: &str = "rules.cga";

/// The reason why a file that is not in memory cannot be read.
const NOT_IN_MEMORY: &str = "no file in memory has this name; add it with `with_file`";

/// A file that was read.
#[derive(Debug)]
struct LoadedFile {
    /// The path from where files that it names are looked for, with forward slashes.
    name: String,
    /// The name in messages; `None` for the same.
    shown: Option<String>,
    dialect: Dialect,
    text: String,
    lexed: Lexed,
}

/// The rule files so far, each read once, and where others are looked for.
#[derive(Debug, Default)]
pub struct RuleFiles {
    /// Files in memory by their names.
    memory: BTreeMap<String, String>,
    /// True if files are read from the disk.
    reads_disk: bool,
    /// The folder that names are relative to; `None` for the current folder.
    base: Option<PathBuf>,
    /// The folder that paths and links must not lead out of.
    root: Option<Root>,
    entries: Vec<LoadedFile>,
    known: HashMap<String, usize>,
    list: FileList,
}

impl RuleFiles {
    /// Files in memory alone. Nothing is read from the disk.
    pub fn in_memory(files: BTreeMap<String, String>) -> Self {
        let memory = files.into_iter().map(|(name, text)| (normal(&name), text)).collect();
        RuleFiles { memory, ..RuleFiles::default() }
    }

    /// Reads files from the disk, too. Their names are relative to the current folder.
    #[must_use]
    pub fn with_disk(self) -> Self {
        RuleFiles { reads_disk: true, ..self }
    }

    /// Does not read files outside of a folder.
    ///
    /// # Errors
    /// A sentence about a folder that cannot be read.
    pub fn inside(self, folder: &Path) -> Result<Self, String> {
        let name = format!("`{}`", folder.display());
        let root = Root::new(folder, name).map_err(|why| unreadable(folder, why))?;
        Ok(RuleFiles { root: Some(root), ..self.with_disk() })
    }

    /// Does not read files outside of a folder, and names files relative to it.
    ///
    /// # Errors
    /// As [`inside`](RuleFiles::inside).
    pub fn below(self, folder: &Path) -> Result<Self, String> {
        let files = self.inside(folder)?;
        let base = files.root.as_ref().map(|root| root.folder().to_owned());
        Ok(RuleFiles { base, ..files })
    }

    /// The number of a file in memory.
    ///
    /// # Errors
    /// A sentence: no file has this name.
    pub fn memory_file(&mut self, name: &str) -> Result<usize, String> {
        self.remembered(&normal(name)).ok_or_else(|| unreadable(Path::new(name), NOT_IN_MEMORY))
    }

    /// Adds rules that are not in a file, and returns their number.
    pub fn add_text(&mut self, text: String) -> usize {
        // Another file may have the name, and rules must not import themselves in its place.
        let is_taken = |name: &str| {
            self.memory.contains_key(name)
                || self.reads_disk && self.base.as_deref().is_some_and(|base| base.join(name).exists())
        };
        let name = if is_taken(TEXT) { format!("{TEXT} (text)") } else { TEXT.to_owned() };
        self.add_text_file(name, text)
    }

    fn add_text_file(&mut self, name: String, text: String) -> usize {
        let lexed = lex(&text);
        self.add(LoadedFile { name, shown: None, dialect: Dialect::Text, text, lexed })
    }

    fn add(&mut self, file: LoadedFile) -> usize {
        self.known.insert(file.name.clone(), self.entries.len());
        self.entries.push(file);
        self.entries.len() - 1
    }

    /// Reads the rules of a grammar in a Rust file, and returns their number and the rest of what the file has. Files that the rules name
    /// are looked for from the base, as the macro does.
    ///
    /// # Errors
    /// A sentence about a file that cannot be read, or has no such rules.
    #[cfg(feature = "rust")]
    pub fn load_rust(&mut self, path: &Path, grammar: &str) -> Result<(usize, crate::rust::RustRules), String> {
        let path = match &self.base {
            Some(base) => base.join(path),
            None => path.to_owned(),
        };
        let shown = self.written(&path);
        let refused = |why: String| format!("cannot read the rules of `{grammar}` in `{shown}`: {why}");
        let text = read_text(&path).map_err(|why| reason(&why));
        self.list.add(&path, text.is_ok());
        let text = text.map_err(refused)?;
        let rules = crate::rust::find_rules(&text, grammar).map_err(refused)?;
        let lexed = Lexed { tokens: rules.tokens.clone(), ranges: rules.ranges.clone(), diags: rules.found.clone() };
        let file = LoadedFile { name: String::new(), shown: Some(shown), dialect: rules.dialect, text, lexed };
        Ok((self.add(file), rules))
    }

    /// Reads a file from the disk, unless it was read, and returns its number.
    ///
    /// # Errors
    /// A sentence about a file that cannot be read.
    pub fn load(&mut self, path: &Path) -> Result<usize, String> {
        self.read(path).map_err(|why| unreadable(path, why))
    }

    fn read(&mut self, path: &Path) -> Result<usize, String> {
        let path = match &self.base {
            Some(base) => base.join(path),
            None => path.to_owned(),
        };
        let name = self.written(&path);
        if let Some(&number) = self.known.get(&name) {
            return Ok(number);
        }
        let text = self.resolved(&path).and_then(|path| read_text(&path).map_err(|why| reason(&why)));
        self.list.add(&path, text.is_ok());
        Ok(self.add_text_file(name, text?))
    }

    /// Returns true if the first file has inline rules: messages about it have the spelling of Rust code.
    pub fn is_inline(&self) -> bool {
        self.entries.first().is_some_and(|file| file.dialect == Dialect::Inline)
    }

    /// A file, by its number, as the compiler takes it.
    pub fn unit(&self, number: usize) -> Unit {
        let LoadedFile { name, lexed, dialect, .. } = &self.entries[number];
        let (tokens, found) = (lexed.tokens.clone(), lexed.diags.clone());
        Unit { name: name.clone(), tokens, dialect: *dialect, found }
    }

    /// The text of a file, by its number.
    pub fn text(&self, number: usize) -> &str {
        &self.entries[number].text
    }

    /// The names and texts of all files so far, sorted by name.
    pub fn into_texts(self) -> Vec<(String, String)> {
        let mut texts: Vec<_> = self.entries.into_iter().map(|file| (file.name, file.text)).collect();
        texts.sort_unstable();
        texts
    }

    /// The files on the disk that the rules so far depend on.
    pub fn list(&self) -> &FileList {
        &self.list
    }

    /// The file of a name as messages quote it. `lines` is filled at the first call.
    pub fn quote<'t>(&'t self, name: &str, lines: &'t OnceCell<Lines<'t>>) -> Option<Quote<'t>> {
        let entry = &self.entries[*self.known.get(name)?];
        let lines = lines.get_or_init(|| Lines::new(&entry.text));
        Some(Quote { name: entry.shown.as_ref().unwrap_or(&entry.name), lines, ranges: &entry.lexed.ranges })
    }

    /// The number of a file that was read, or that is in memory.
    fn remembered(&mut self, name: &str) -> Option<usize> {
        if let Some(&number) = self.known.get(name) {
            return Some(number);
        }
        let text = self.memory.remove(name)?;
        Some(self.add_text_file(name.to_owned(), text))
    }

    /// The path with links resolved, if there is a folder that it must not lead out of.
    fn resolved(&self, path: &Path) -> Result<PathBuf, String> {
        let Some(root) = &self.root else { return Ok(path.to_owned()) };
        // A relative path counts from the current folder, not from the root.
        let path = std::path::absolute(path).map_err(|why| why.to_string())?;
        root.resolved(&path).map_err(|why| why.to_string())
    }

    /// A path as messages show it, and from where files that it names are looked for: the same for one file, however it was reached, if
    /// no links are in the way.
    fn written(&self, path: &Path) -> String {
        let base = self.base.clone().or_else(|| std::env::current_dir().ok()).unwrap_or_default();
        let short = path.strip_prefix(&base).unwrap_or(path);
        let parts: PathBuf = short.components().filter(|part| *part != Component::CurDir).collect();
        parts.to_string_lossy().replace('\\', "/")
    }

    /// An absolute path for the name of a file: folders above the current one count, too.
    fn absolute(&self, name: &str) -> Option<String> {
        let path = match &self.base {
            Some(base) => base.join(name),
            None => std::path::absolute(name).ok()?,
        };
        Some(path.to_string_lossy().into_owned())
    }
}

impl Files for RuleFiles {
    fn open(&mut self, path: &str, from: &str) -> Result<Unit, String> {
        if !self.reads_disk {
            let found = candidates(path, from).into_iter().find_map(|name| self.remembered(&name));
            let found = found.ok_or(NOT_IN_MEMORY)?;
            return Ok(self.unit(found));
        }
        let from = self.absolute(from).ok_or("the current folder cannot be read")?;
        for path in candidates(path, &from) {
            let path = Path::new(&path);
            let number = match self.remembered(&self.written(path)) {
                Some(number) => number,
                None if path.is_file() => self.read(path)?,
                None => {
                    self.list.add(path, false);
                    continue;
                }
            };
            return Ok(self.unit(number));
        }
        Err(match &self.root {
            Some(root) => root.outside(),
            None => "the file is neither beside this one nor in a folder above".into(),
        })
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
            let entries = std::fs::read_dir(folder).into_iter().flatten().flatten();
            names.extend(entries.filter_map(|entry| entry.file_name().into_string().ok()));
        }
        names
    }
}

/// The sentence about a file or folder that cannot be read.
fn unreadable(path: &Path, why: impl std::fmt::Display) -> String {
    format!("cannot read `{}`: {why}", path.display())
}

/// The reason why a file cannot be read, in the words of all messages.
fn reason(why: &std::io::Error) -> String {
    match why.kind() {
        ErrorKind::NotFound => "there is no such file".to_owned(),
        _ => why.to_string(),
    }
}
