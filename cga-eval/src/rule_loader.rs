//! How rules are loaded: names, imports, Rust functions.

use std::cell::OnceCell;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use cga_lang::compile::{Compiled, compile};
use cga_lang::diag::code::Code;
use cga_lang::diag::{Diag, Level};
use cga_lang::ir::plan::RunPlan;
use cga_lang::snippet::Lines;
use cga_runtime::rt::{Shape, Text, Value};
use cga_source::RuleFiles;

use crate::code::HostOperation;
use crate::compile::{Registered, program};
use crate::diagnostic::RuleDiagnostic;
use crate::error::RuleFileError;
use crate::rule_file::{Loaded, RuleFile};
use crate::tables::{attributes, tables};

/// Loads rules with files in memory and functions of the program.
///
/// ```
/// # use cga_eval::facade as cga;
/// use cga::{RuleLoader, Value};
///
/// let rules = RuleLoader::new()
///     .with_file("lib.cga", "Wall --> color(\"#ffffff\") X.")
///     .with_function("height", |_| Value::Float(7.0))
///     .text("import lib : \"lib.cga\"  Lot --> extrude(crate::height()) lib.Wall");
/// # let _ = rules;
/// ```
#[derive(Clone, Debug, Default)]
pub struct RuleLoader {
    name: Option<String>,
    root: Option<PathBuf>,
    memory: BTreeMap<String, String>,
    registered: Registered,
    /// The levels of diagnostics, by name.
    levels: Vec<(String, Level)>,
}

impl RuleLoader {
    /// A loader without files and functions.
    pub fn new() -> Self {
        RuleLoader::default()
    }

    /// Sets the name of the grammar. Without it, a file has its own name without its folder and ending, and a text has none.
    #[must_use]
    pub fn named(mut self, name: impl Into<String>) -> Self {
        self.name = Some(name.into());
        self
    }

    /// Sets the folder of the rules. Paths of rule files are relative to it, and files outside are not read. Without it, paths are
    /// relative to the current folder.
    #[must_use]
    pub fn root(mut self, folder: impl Into<PathBuf>) -> Self {
        self.root = Some(folder.into());
        self
    }

    /// Adds a rule file that others import. `name` is its path with forward slashes, from the folder of the rules.
    #[must_use]
    pub fn with_file(mut self, name: impl Into<String>, text: impl Into<String>) -> Self {
        self.memory.insert(name.into(), text.into());
        self
    }

    /// Registers a Rust function that rules call by its path: `crate::height(2)`. The rules decide which type its value must have;
    /// another one is a fault, and counts as 0 or empty.
    #[must_use]
    pub fn with_function(
        mut self,
        path: impl Into<String>,
        function: impl Fn(&[Value]) -> Value + Send + Sync + 'static,
    ) -> Self {
        self.registered.functions.insert(path.into(), Arc::new(function));
        self
    }

    /// Registers a Rust function that rules call as an operation by its path: `crate::arch(2)`.
    #[must_use]
    pub fn with_operation(
        mut self,
        path: impl Into<String>,
        operation: impl Fn(&mut Shape, &[Value]) + Send + Sync + 'static,
    ) -> Self {
        self.registered.operations.insert(path.into(), HostOperation::Registered(Arc::new(operation)));
        self
    }

    /// Does not report the diagnostics of a name, such as `unused_attribute`, as `@Allow` in the header of a compiled grammar.
    #[must_use]
    pub fn allow(self, code: impl Into<String>) -> Self {
        self.with_level(code, Level::Allow)
    }

    /// Reports the diagnostics of a name as warnings.
    #[must_use]
    pub fn warn(self, code: impl Into<String>) -> Self {
        self.with_level(code, Level::Warning)
    }

    /// Reports the diagnostics of a name as errors: rules with one cannot be loaded.
    #[must_use]
    pub fn deny(self, code: impl Into<String>) -> Self {
        self.with_level(code, Level::Error)
    }

    fn with_level(mut self, code: impl Into<String>, level: Level) -> Self {
        self.levels.push((code.into(), level));
        self
    }

    /// Loads a rule file and the files that it imports.
    ///
    /// # Errors
    /// The file cannot be read, or its rules have errors.
    pub fn open(&self, path: impl AsRef<Path>) -> Result<RuleFile, RuleFileError> {
        let path = path.as_ref();
        let mut files = match &self.root {
            Some(root) => self.files(root)?,
            None => RuleFiles::in_memory(self.memory.clone()).with_disk(),
        };
        let number = files.load(path).map_err(|why| RuleFileError::one(why).with_files(files.list()))?;
        let stem = path.file_stem().map(|stem| stem.to_string_lossy().into_owned()).unwrap_or_default();
        self.load(number, files, self.name.as_deref().unwrap_or(&stem))
    }

    /// Loads a rule file that [`with_file`](RuleLoader::with_file) has added, and the files that it imports. Programs that read files
    /// themselves, as game engines and web pages do, add them first; [`imports`](RuleLoader::imports) names them.
    ///
    /// ```
    /// # use cga_eval::facade as cga;
    /// use cga::RuleLoader;
    ///
    /// let text = "import walls : \"wall.cga\"  Lot --> walls.Wall";
    /// assert_eq!(RuleLoader::imports("rules/lot.cga", text)[0][..2], ["rules/wall.cga", "rules/assets/wall.cga"]);
    /// let loader = RuleLoader::new().with_file("rules/lot.cga", text).with_file("rules/wall.cga", "Wall --> X.");
    /// assert!(loader.memory_file("rules/lot.cga").is_ok());
    /// ```
    ///
    /// # Errors
    /// The file does not exist, or the rules have errors.
    pub fn memory_file(&self, name: &str) -> Result<RuleFile, RuleFileError> {
        let mut files = RuleFiles::in_memory(self.memory.clone());
        let number = files.memory_file(name).map_err(RuleFileError::one)?;
        let stem = Path::new(name).file_stem().map(|stem| stem.to_string_lossy().into_owned()).unwrap_or_default();
        self.load(number, files, self.name.as_deref().unwrap_or(&stem))
    }

    /// The imports of a rule text with a name, in order. Each has the names that its file may have, the likeliest first.
    pub fn imports(name: &str, text: &str) -> Vec<Vec<String>> {
        cga_source::imports(name, text)
    }

    /// The text of a rule file, from its bytes: in UTF-8, UTF-16 or, for single bytes, Latin-1.
    pub fn decode(bytes: &[u8]) -> String {
        cga_lang::syntax::lex::decode(bytes).into_owned()
    }

    /// Loads rules from text. Only files in memory can be imported, unless the loader has a folder.
    ///
    /// # Errors
    /// The rules have errors.
    pub fn text(&self, text: &str) -> Result<RuleFile, RuleFileError> {
        let mut files = match &self.root {
            Some(root) => self.files(root)?,
            None => RuleFiles::in_memory(self.memory.clone()),
        };
        let number = files.add_text(text.to_owned());
        self.load(number, files, self.name.as_deref().unwrap_or_default())
    }

    /// Loads the rules of a grammar in a Rust file, below the folder of the rules.
    #[cfg(feature = "live")]
    pub(crate) fn open_rust(&self, path: &str, grammar: &str) -> Result<RuleFile, RuleFileError> {
        let mut files = self.files(self.root.as_deref().unwrap_or(Path::new(".")))?;
        let loaded = files.load_rust(Path::new(path), grammar);
        let (number, rules) = loaded.map_err(|why| RuleFileError::one(why).with_files(files.list()))?;
        let values = rules.hosts.iter().map(|host| format!("#{host}")).collect();
        let levels = rules.levels.iter().map(|(code, level)| (code.name().to_owned(), *level)).collect();
        let loader =
            RuleLoader { levels, registered: Registered { values, ..self.registered.clone() }, ..self.clone() };
        loader.load(number, files, grammar)
    }

    /// Takes the Rust code that was compiled with the rules.
    #[cfg(feature = "live")]
    pub(crate) fn with_compiled(mut self, calls: &'static [cga_runtime::rt::RustCall]) -> Self {
        (self.registered.compiled, self.registered.is_live) = (calls, true);
        self
    }

    /// The files in a folder and in memory.
    fn files(&self, root: &Path) -> Result<RuleFiles, RuleFileError> {
        RuleFiles::in_memory(self.memory.clone()).below(root).map_err(RuleFileError::one)
    }

    fn load(&self, number: usize, mut files: RuleFiles, name: &str) -> Result<RuleFile, RuleFileError> {
        let level = |(name, level): &(String, Level)| match Code::from_name(name) {
            Some(code) => Ok((code, *level)),
            None => {
                Err(RuleFileError::one(format!("`{name}` is not the name of a diagnostic; the guide lists the names")))
            }
        };
        let levels = self.levels.iter().map(level).collect::<Result<Vec<_>, _>>()?;
        let unit = files.unit(number);
        let file = unit.name.clone();
        let compiled = compile(unit, &mut files, &levels);
        let shown = |diags: &[Diag]| shown(&compiled, &files, diags);
        let error = |diags: &[Diag]| {
            let details = shown(diags);
            RuleFileError { diagnostics: texts(&details), details, files: files.list().clone() }
        };
        let Some(grammar) = &compiled.grammar else { return Err(error(&compiled.diags)) };
        let plan = RunPlan::new(grammar);
        let program = program(grammar, &plan, &self.registered).map_err(|problems| error(&problems))?;
        let defaults: Vec<Option<Value>> = program.fields.iter().map(|field| field.known.clone()).collect();
        let attributes = attributes(grammar, &defaults);
        let warnings: Vec<Diag> = compiled.diags.iter().filter(|diag| diag.level == Level::Warning).cloned().collect();
        let (warning_details, list) = (shown(&warnings), files.list().clone());
        Ok(RuleFile {
            values: defaults.as_slice().into(),
            loaded: Arc::new(Loaded {
                tables: tables(grammar, &plan, name, &attributes),
                attributes,
                about: Text::from(grammar.about.as_str()),
                program: Arc::new(program),
                warnings: texts(&warning_details),
                warning_details,
                files: list,
                file,
                texts: files.into_texts(),
            }),
        })
    }
}

impl RuleFile {
    /// A loader with more choices: files in memory, functions of the program, a name, the folder of the rules.
    pub fn loader() -> RuleLoader {
        RuleLoader::new()
    }

    /// Loads a rule file and the files that it imports.
    ///
    /// # Errors
    /// The file cannot be read, or its rules have errors.
    pub fn open(path: impl AsRef<Path>) -> Result<Self, RuleFileError> {
        RuleLoader::new().open(path)
    }

    /// Loads rules that import nothing from text.
    ///
    /// # Errors
    /// The rules have errors.
    pub fn from_text(text: &str) -> Result<Self, RuleFileError> {
        RuleLoader::new().text(text)
    }
}

/// Diagnostics as data, with the text that the compiler shows.
fn shown(compiled: &Compiled, files: &RuleFiles, diags: &[Diag]) -> Vec<RuleDiagnostic> {
    let is_inline = |diag: &Diag| files.is_inline() && compiled.locate(diag.span.first).0 == 0;
    let spelled = |diag: &Diag| diag.spelled(if is_inline(diag) { '^' } else { '\'' });
    let lines: Vec<OnceCell<Lines<'_>>> = compiled.files.iter().map(|_| OnceCell::new()).collect();
    let quote = |file: usize| files.quote(&compiled.files.get(file)?.name, lines.get(file)?);
    diags
        .iter()
        .filter(|diag| diag.level != Level::Allow)
        .map(|diag| RuleDiagnostic::new(compiled, &quote, &spelled(diag)))
        .collect()
}

/// Diagnostics as text.
fn texts(details: &[RuleDiagnostic]) -> Vec<String> {
    details.iter().map(|detail| detail.text.clone()).collect()
}
