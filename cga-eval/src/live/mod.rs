//! Compiled grammars that follow their rules while the program runs.

use std::collections::BTreeSet;
use std::fmt;
use std::io::Write as _;
use std::path::{Path, PathBuf};

use cga_runtime::fault::Error;
use cga_runtime::grammar::attribute::Attribute;
use cga_runtime::grammar::session::DynSession;
use cga_runtime::grammar::{Grammar, RuleSource};
use cga_runtime::rt::{Shape, Text, Value};
use cga_runtime::run::report::Report;
use cga_runtime::run::settings::Settings;
use cga_runtime::run::sink::Sink;
use cga_runtime::run::start_rule::StartRule;

use crate::error::RuleFileError;
use crate::rule_file::RuleFile;
use crate::rule_loader::RuleLoader;
use crate::watch::FileWatcher;

/// The most times that rules are loaded after one change. Files in folders that were not watched before may have changed meanwhile.
const MOST_LOADS: usize = 4;

/// A grammar whose rules are loaded again when their file changes: a rule file, or the Rust file with the macro.
///
/// Until the first change the compiled rules run, and then the loaded ones, with the same bytes. Attributes keep the values that were set,
/// by name. With a mistake in the rules the last good ones stay. Rust values and functions in rules are the compiled ones; others need a
/// build, or are [registered](Live::with_loader). New attributes have no field in the struct that `cga!` makes, so programs set them by name.
///
/// ```no_run
/// # fn run<Tower: cga_runtime::grammar::Grammar + Clone + Default + Send + Sync + 'static>() -> Result<(), Box<dyn std::error::Error>> {
/// # use cga_eval::facade as cga;
/// use cga::{Grammar, Live, Shape};
///
/// // `cga! { pub grammar Tower; Lot --> … }`
/// let mut tower = Live::new(Tower::default())?;
/// loop {
///     tower.generate(&Shape::rectangle(20.0, 15.0))?;
///     while !tower.wait() {} // mistakes are written to standard error
/// }
/// # }
/// ```
#[derive(Clone)]
pub struct Live {
    current: Box<dyn Grammar + Send + Sync>,
    source: RuleSource,
    loader: RuleLoader,
    watcher: FileWatcher,
    error: Option<RuleFileError>,
    /// The names of attributes that the program has set after it began to follow the rules.
    set: BTreeSet<String>,
}

impl fmt::Debug for Live {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Live").field("source", &self.source).field("error", &self.error).finish_non_exhaustive()
    }
}

/// The reason why a grammar cannot follow its rules.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum LiveError {
    /// The rules have no name or are outside of their package, or the feature `live` was off when they were compiled.
    NoSource {
        /// The name of the grammar.
        grammar: String,
    },
    /// The files cannot be watched.
    Watch(String),
}

impl fmt::Display for LiveError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            LiveError::NoSource { grammar } => write!(
                f,
                "the source of the rules of `{grammar}` is not known: give the rules a name, as in `cga! {{ grammar Tower; … }}`, in a file \
                 of the package, and switch the feature `live` of the package `cga` on"
            ),
            LiveError::Watch(why) => write!(f, "the rule files cannot be watched: {why}"),
        }
    }
}

impl std::error::Error for LiveError {}

impl Live {
    /// Follows the rules of a compiled grammar, in the folder of its package.
    ///
    /// # Errors
    /// The file with the rules is not known, or the system cannot watch it.
    pub fn new(grammar: impl Grammar + Send + Sync + 'static) -> Result<Self, LiveError> {
        let source = source(&grammar)?;
        Live::from_source(grammar, source, Path::new(source.folder))
    }

    /// Follows a copy of the rules in another folder, for programs that have their rules beside them. The path of the file from `folder` is
    /// its path from the folder of the package. The compiled rules run until a file changes there.
    ///
    /// # Errors
    /// As [`new`](Live::new).
    pub fn in_folder(
        grammar: impl Grammar + Send + Sync + 'static,
        folder: impl AsRef<Path>,
    ) -> Result<Self, LiveError> {
        let source = source(&grammar)?;
        Live::from_source(grammar, source, folder.as_ref())
    }

    fn from_source(
        grammar: impl Grammar + Send + Sync + 'static,
        source: RuleSource,
        folder: &Path,
    ) -> Result<Self, LiveError> {
        if !folder.is_dir() {
            return Err(LiveError::Watch(format!("the folder `{}` does not exist", folder.display())));
        }
        let mut loader = RuleLoader::new().named(source.name).root(folder).with_compiled(source.calls);
        for &(code, level) in source.levels {
            loader = match level {
                "deny" => loader.deny(code),
                "warn" => loader.warn(code),
                _ => loader.allow(code),
            };
        }
        let mut watcher = FileWatcher::new().map_err(LiveError::Watch)?;
        let files: Vec<PathBuf> = source.files.iter().map(|file| folder.join(file)).collect();
        watcher.follow_files(files.iter().map(PathBuf::as_path)).map_err(LiveError::Watch)?;
        Ok(Live { current: Box::new(grammar), source, loader, watcher, error: None, set: BTreeSet::new() })
    }

    /// Changes the loader, to register the Rust functions that the rules call.
    #[must_use]
    pub fn with_loader(mut self, change: impl FnOnce(RuleLoader) -> RuleLoader) -> Self {
        self.loader = change(self.loader);
        self
    }

    /// Loads the rules again if a rule file has changed. Returns true if other rules run now. Mistakes are written to standard error, and
    /// [`error`](Live::error) has them.
    pub fn refresh(&mut self) -> bool {
        self.watcher.has_changed() && self.load()
    }

    /// Waits until a rule file changes, and loads the rules again. Returns true if other rules run now, false after a mistake.
    pub fn wait(&mut self) -> bool {
        self.watcher.wait();
        self.load()
    }

    /// The mistakes in the rules, if they could not be loaded after the last change.
    pub fn error(&self) -> Option<&RuleFileError> {
        self.error.as_ref()
    }

    fn load(&mut self) -> bool {
        match self.read() {
            Ok(rules) => {
                self.take(rules);
                true
            }
            Err(error) => {
                say(&error);
                self.error = Some(error);
                false
            }
        }
    }

    /// Loads the rules, and watches the files that they are in.
    fn read(&mut self) -> Result<RuleFile, RuleFileError> {
        let mut left = MOST_LOADS;
        loop {
            let RuleSource { path, name, is_rust, .. } = self.source;
            let loaded = if is_rust { self.loader.open_rust(path, name) } else { self.loader.open(path) };
            let files = loaded.as_ref().map_or_else(RuleFileError::files, RuleFile::files);
            left -= 1;
            match self.watcher.follow(files) {
                Ok(true) if left != 0 => {}
                Ok(_) => return loaded,
                Err(why) => {
                    say(why);
                    return loaded;
                }
            }
        }
    }

    /// Runs other rules. Attributes keep the values that were set; values that the new rules refuse are dropped, with a line on standard
    /// error.
    fn take(&mut self, mut rules: RuleFile) {
        for (name, error) in rules.take_some_values(&*self.current, &|name| self.set.contains(name)) {
            say(format_args!("the value of `{name}` is dropped: {error}"));
            self.set.remove(name.as_str());
        }
        self.current = Box::new(rules);
        self.error = None;
    }
}

/// Writes a line to standard error, which may be closed.
fn say(line: impl fmt::Display) {
    let _ = writeln!(std::io::stderr().lock(), "{line}");
}

/// The rules of a compiled grammar.
fn source(grammar: &dyn Grammar) -> Result<RuleSource, LiveError> {
    grammar.rule_source().ok_or_else(|| LiveError::NoSource { grammar: grammar.name().to_owned() })
}

impl Grammar for Live {
    fn name(&self) -> &str {
        self.current.name()
    }

    fn attributes(&self) -> &[Attribute] {
        self.current.attributes()
    }

    fn about(&self) -> &str {
        self.current.about()
    }

    fn start_rules(&self) -> &[StartRule] {
        self.current.start_rules()
    }

    fn attribute_get(&self, index: usize) -> Option<Value> {
        self.current.attribute_get(index)
    }

    fn attribute_set(&mut self, index: usize, value: Value) {
        if let Some(attribute) = self.current.attributes().get(index) {
            self.set.insert(attribute.name.to_string());
        }
        self.current.attribute_set(index, value);
    }

    fn attribute_reset(&mut self, index: usize) {
        if let Some(attribute) = self.current.attributes().get(index) {
            self.set.remove(attribute.name.as_str());
        }
        self.current.attribute_reset(index);
    }

    fn boxed(&self) -> Box<dyn Grammar + Send + Sync> {
        self.current.boxed()
    }

    fn used_values(&self, shape: &Shape, settings: &Settings) -> Result<Vec<(Text, Value)>, Error> {
        self.current.used_values(shape, settings)
    }

    fn run(&self, shape: &Shape, settings: &Settings, sink: &mut dyn Sink) -> Result<Report, Error> {
        self.current.run(shape, settings, sink)
    }

    fn session<'g>(&'g self, settings: &Settings) -> Result<Box<dyn DynSession + 'g>, Error> {
        self.current.session(settings)
    }
}
