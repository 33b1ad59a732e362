//! How rules are loaded: names, imports, Rust functions.

use std::cell::OnceCell;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use cga_lang::compile::{Compiled, compile};
use cga_lang::diag::code::Code;
use cga_lang::diag::{Diag, Level};
use cga_lang::ir::plan::RunPlan;
use cga_lang::link::Unit;
use cga_lang::snippet::{Lines, render_in};
use cga_runtime::rt::{Shape, Text, Value};

use crate::compile::{Registered, program};
use crate::error::RuleFileError;
use crate::rule_file::{Loaded, RuleFile};
use crate::sources::Sources;
use crate::tables::{attributes, tables};

/// Loads rules with files in memory and functions of the program.
///
/// ```
/// use cga_eval::RuleLoader;
/// use cga_runtime::value::Value;
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
        self.registered.operations.insert(path.into(), Arc::new(operation));
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
        let mut sources = Sources::new(self.memory.clone(), true, self.root.as_deref()).map_err(RuleFileError::one)?;
        let unit =
            sources.read(path).map_err(|why| RuleFileError::one(format!("cannot read `{}`: {why}", path.display())))?;
        let stem = path.file_stem().map(|stem| stem.to_string_lossy().into_owned()).unwrap_or_default();
        self.load(unit, sources, self.name.as_deref().unwrap_or(&stem))
    }

    /// Loads rules from text. Only files in memory can be imported, unless the loader has a folder.
    ///
    /// # Errors
    /// The rules have errors.
    pub fn text(&self, text: &str) -> Result<RuleFile, RuleFileError> {
        let (memory, root) = (self.memory.clone(), self.root.as_deref());
        let mut sources = Sources::new(memory, root.is_some(), root).map_err(RuleFileError::one)?;
        let unit = sources.add("rules.cga", text.to_owned());
        self.load(unit, sources, self.name.as_deref().unwrap_or_default())
    }

    fn load(&self, unit: Unit, mut sources: Sources, name: &str) -> Result<RuleFile, RuleFileError> {
        let level = |(name, level): &(String, Level)| match Code::from_name(name) {
            Some(code) => Ok((code, *level)),
            None => Err(RuleFileError::one(format!(
                "there are no diagnostics of the name `{name}`; the guide lists the names"
            ))),
        };
        let levels = self.levels.iter().map(level).collect::<Result<Vec<_>, _>>()?;
        let compiled = compile(unit, &mut sources, &levels);
        let shown = |diags: &[Diag]| shown(&compiled, &sources, diags);
        let Some(grammar) = &compiled.grammar else {
            return Err(RuleFileError { diagnostics: shown(&compiled.diags) });
        };
        let plan = RunPlan::new(grammar);
        let program = program(grammar, &plan, &self.registered)
            .map_err(|problems| RuleFileError { diagnostics: shown(&problems) })?;
        let defaults: Vec<Option<Value>> = program.fields.iter().map(|field| field.known.clone()).collect();
        let attributes = attributes(grammar, &defaults);
        let warnings: Vec<Diag> = compiled.diags.iter().filter(|diag| diag.level == Level::Warning).cloned().collect();
        Ok(RuleFile {
            values: defaults.as_slice().into(),
            loaded: Arc::new(Loaded {
                tables: tables(grammar, &plan, name, &attributes),
                attributes,
                about: Text::from(grammar.about.as_str()),
                program: Arc::new(program),
                warnings: shown(&warnings),
                files: sources.files(),
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

/// Diagnostics as text, as the compiler shows them.
fn shown(compiled: &Compiled, sources: &Sources, diags: &[Diag]) -> Vec<String> {
    let lines: Vec<OnceCell<Lines<'_>>> = compiled.files.iter().map(|_| OnceCell::new()).collect();
    let quote = |file: usize| sources.quote(&compiled.files.get(file)?.name, lines.get(file)?);
    diags.iter().filter(|diag| diag.level != Level::Allow).map(|diag| render_in(compiled, &quote, diag)).collect()
}
