//! A grammar that was loaded.

use std::sync::Arc;

use cga_runtime::fault::Error;
use cga_runtime::grammar::Grammar;
use cga_runtime::grammar::attribute::{self, Attribute, AttributeError};
use cga_runtime::grammar::session::{self, DynSession, Session};
use cga_runtime::rt::{Checked, Cx, Env, Flow, RuleTables, Rules, Shape, ShapeRef, Text, Value};
use cga_runtime::run::report::Report;
use cga_runtime::run::settings::Settings;
use cga_runtime::run::sink::Sink;
use cga_runtime::run::start_rule::StartRule;
use cga_source::FileList;

use crate::call::Call;
use crate::diagnostic::RuleDiagnostic;
use crate::program::Program;
use crate::run::Values;

/// Rules that were loaded at run time, with the values of their attributes.
///
/// It is a [`Grammar`], so it can do all that a compiled grammar can: sessions, scenes, sinks, parallel runs, JSON. Equal rules make equal
/// bytes, compiled or loaded.
///
/// ```
/// # use cga_eval::facade as cga;
/// use cga::{Grammar, RuleFile, Shape};
///
/// let mut tower = RuleFile::from_text("attr height = 9  Lot --> extrude(height) split(y) { ~3 : Floor }*  Floor --> X.")?;
/// tower.set("height", 12.0.into())?;
/// assert_eq!(tower.generate(&Shape::rectangle(10.0, 8.0))?.len(), 4);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct RuleFile {
    pub(crate) loaded: Arc<Loaded>,
    /// The values of the attributes, `None` where the default is computed.
    pub(crate) values: Arc<[Option<Value>]>,
}

/// The parts of a grammar that its copies share.
#[derive(Debug)]
pub(crate) struct Loaded {
    pub(crate) program: Arc<Program>,
    pub(crate) tables: RuleTables,
    pub(crate) attributes: Vec<Attribute>,
    pub(crate) about: Text,
    pub(crate) warnings: Vec<String>,
    pub(crate) warning_details: Vec<RuleDiagnostic>,
    pub(crate) files: FileList,
    /// The name of the rule file among its texts.
    pub(crate) file: String,
    /// The names and texts of the rule file and of its imports.
    pub(crate) texts: Vec<(String, String)>,
}

impl RuleFile {
    /// The warnings about the rules, as the compiler shows them.
    pub fn warnings(&self) -> &[String] {
        &self.loaded.warnings
    }

    /// The warnings about the rules as data, in the same order.
    pub fn warning_details(&self) -> &[RuleDiagnostic] {
        &self.loaded.warning_details
    }

    /// The files on the disk that the rules depend on: programs that follow their rules watch them.
    pub fn files(&self) -> &FileList {
        &self.loaded.files
    }

    /// The name of the rule file in [`texts`](RuleFile::texts). [`RuleLoader::memory_file`](crate::RuleLoader::memory_file) loads the rules again
    /// from these texts, for example in another process.
    ///
    /// ```
    /// # use cga_eval::facade as cga;
    /// use cga::RuleLoader;
    ///
    /// let rules = RuleLoader::new().with_file("lib.cga", "Wall --> X.").text("import lib : \"lib.cga\"  Lot --> lib.Wall")?;
    /// let loader = rules.texts().fold(RuleLoader::new(), |loader, (name, text)| loader.with_file(name, text));
    /// assert!(loader.memory_file(rules.file())?.texts().eq(rules.texts()));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn file(&self) -> &str {
        &self.loaded.file
    }

    /// The names and texts of the rule file and of the files that it imports, sorted by name. A program that keeps results compares them to
    /// know whether the rules are the same.
    ///
    /// ```
    /// # use cga_eval::facade as cga;
    /// use cga::RuleLoader;
    ///
    /// let loader = RuleLoader::new().with_file("lib.cga", "Wall --> X.");
    /// let rules = loader.text("import lib : \"lib.cga\"  Lot --> extrude(5) lib.Wall")?;
    /// assert_eq!(rules.texts().map(|(name, _)| name).collect::<Vec<_>>(), ["lib.cga", "rules.cga"]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn texts(&self) -> impl ExactSizeIterator<Item = (&str, &str)> {
        self.loaded.texts.iter().map(|(name, text)| (name.as_str(), text.as_str()))
    }

    /// Takes the values of attributes that differ from their defaults in another grammar, by name. Returns the names of the values that
    /// these rules refuse, each with the reason.
    pub fn take_values(&mut self, from: &dyn Grammar) -> Vec<(Text, AttributeError)> {
        self.take_some_values(from, &|_| false)
    }

    /// Takes values that differ from their defaults, and the values of some attributes by name.
    pub(crate) fn take_some_values(
        &mut self,
        from: &dyn Grammar,
        are_set: &dyn Fn(&str) -> bool,
    ) -> Vec<(Text, AttributeError)> {
        let mut refused = Vec::new();
        for (index, attribute) in from.attributes().iter().enumerate() {
            let value = from.attribute_get(index);
            if value == attribute.default && !are_set(&attribute.name) {
                continue;
            }
            if let Some(Err(error)) = value.map(|value| self.set(&attribute.name, value)) {
                refused.push((attribute.name.clone(), error));
            }
        }
        refused
    }

    /// Opens a session: several runs with the same settings, which share what is made once.
    ///
    /// # Errors
    /// An attribute out of its range, no such start rule.
    pub fn session(&self, settings: &Settings) -> Result<Session<'_, Self>, Error> {
        Session::new(self, settings)
    }

    fn set_value(&mut self, index: usize, value: Option<Value>) {
        if let Some(field) = Arc::make_mut(&mut self.values).get_mut(index) {
            *field = value;
        }
    }
}

impl Checked for RuleFile {}

impl Rules for RuleFile {
    type Values = Values;
    type Call = Call;

    fn tables(&self) -> &RuleTables {
        &self.loaded.tables
    }

    fn check(&self) -> Result<(), Error> {
        attribute::check(self)
    }

    fn values(&self, env: &mut Env, shape: &Shape, style: u32) -> Values {
        let mut values = Values::new(self.loaded.program.clone(), self.values.clone(), style);
        values.compute(env, shape);
        values
    }

    fn used(values: &Values, style: u32, each: &mut dyn FnMut(Option<Value>)) {
        values.used(style, each);
    }

    fn start(values: &Values, cx: &mut Cx<'_, Call>, rule: u32, shape: &ShapeRef<'_>) -> Flow {
        values.start(cx, rule as usize, shape)
    }

    fn resume(values: &Values, cx: &mut Cx<'_, Call>, shape: &ShapeRef<'_>, call: Call) -> Flow {
        values.resume(cx, shape, call)
    }
}

impl Grammar for RuleFile {
    fn name(&self) -> &str {
        &self.loaded.tables.name
    }

    fn about(&self) -> &str {
        &self.loaded.about
    }

    fn attributes(&self) -> &[Attribute] {
        &self.loaded.attributes
    }

    fn start_rules(&self) -> &[StartRule] {
        &self.loaded.tables.starts
    }

    fn attribute_get(&self, index: usize) -> Option<Value> {
        self.values.get(index)?.clone()
    }

    fn attribute_set(&mut self, index: usize, value: Value) {
        let has_type = |attribute: &Attribute| attribute.ty == value.ty();
        if self.loaded.attributes.get(index).is_some_and(has_type) {
            self.set_value(index, Some(value));
        }
    }

    fn attribute_reset(&mut self, index: usize) {
        let default = self.loaded.program.fields.get(index).and_then(|field| field.known.clone());
        self.set_value(index, default);
    }

    fn boxed(&self) -> Box<dyn Grammar + Send + Sync> {
        Box::new(self.clone())
    }

    fn used_values(&self, shape: &Shape, settings: &Settings) -> Result<Vec<(Text, Value)>, Error> {
        session::used_values(self, shape, settings)
    }

    fn run(&self, shape: &Shape, settings: &Settings, sink: &mut dyn Sink) -> Result<Report, Error> {
        session::run(self, shape, settings, sink)
    }

    fn session<'g>(&'g self, settings: &Settings) -> Result<Box<dyn DynSession + 'g>, Error> {
        session::open(self, settings)
    }
}
