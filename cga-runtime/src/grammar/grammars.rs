//! Several grammars with names, for lists of lots of different kinds.

use std::collections::BTreeSet;
use std::fmt;
use std::sync::Arc;

use crate::fault::{Error, Fault};
use crate::grammar::parallel::{Runs, Stretch, alone, generate_by, run_by};
use crate::grammar::session::DynSession;
use crate::grammar::{Grammar, lots};
use crate::output::batches::{Batches, RunError};
use crate::output::model::Model;
use crate::run::derive::{self, NoResult, RunOutcome};
use crate::run::ghost::{Collect, Ghost};
use crate::run::queries::Queries;
use crate::run::report::Report;
use crate::run::settings::Settings;
use crate::run::sink::Sink;
use crate::run::surroundings::Neighbours;
use crate::shape::Shape;
use crate::value::shown::shown;
use crate::value::text::Text;

/// Several grammars with names. Each lot runs the grammar that it names with [`Shape::grammar`], and a lot without a name the first one.
///
/// ```
/// # // Rules are compiled by the crate `cga`; its tests run an example.
/// # use cga_runtime::facade as cga;
/// use cga::{Error, Grammars, Shape};
///
/// let lot = Shape::rectangle(20.0, 15.0).named("Mill Street 4").grammar("House");
/// let error = Grammars::new().generate(&lot).unwrap_err();
/// assert_eq!(error.to_string(), "lot `Mill Street 4`: the set has no grammars");
/// ```
#[derive(Clone, Default)]
pub struct Grammars {
    list: Vec<(Text, Box<dyn Grammar + Send + Sync>)>,
    /// The names that two grammars were added under.
    shared: BTreeSet<Text>,
}

impl fmt::Debug for Grammars {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_list().entries(self.names()).finish()
    }
}

impl Grammars {
    /// No grammars.
    pub fn new() -> Self {
        Grammars::default()
    }

    /// Adds a grammar under the name of its header. If the set has a grammar of that name, no lot can name either of them:
    /// [`with_named`](Grammars::with_named) gives one of them another name. Grammars without a header have no name.
    pub fn with(self, grammar: impl Grammar + Send + Sync + 'static) -> Self {
        self.with_boxed(Box::new(grammar))
    }

    /// Adds a boxed grammar under the name of its header, as [`with`](Grammars::with) does.
    pub fn with_boxed(mut self, grammar: Box<dyn Grammar + Send + Sync>) -> Self {
        let name = Text::from(grammar.name());
        if self.get(&name).is_some() {
            self.shared.insert(name);
            return self;
        }
        self.put(name, grammar)
    }

    /// Adds a grammar under another name, as a map may have it. It replaces a grammar of that name.
    pub fn with_named(self, name: impl Into<Text>, grammar: impl Grammar + Send + Sync + 'static) -> Self {
        self.put(name.into(), Box::new(grammar))
    }

    fn put(mut self, name: Text, grammar: Box<dyn Grammar + Send + Sync>) -> Self {
        self.shared.remove(&name);
        match self.list.iter_mut().find(|(known, _)| *known == name) {
            Some(own) => own.1 = grammar,
            None => self.list.push((name, grammar)),
        }
        self
    }

    /// The names, in the order in which they were added.
    pub fn names(&self) -> impl ExactSizeIterator<Item = &str> {
        self.list.iter().map(|(name, _)| name.as_str())
    }

    /// The grammar with a name.
    pub fn get(&self, name: &str) -> Option<&(dyn Grammar + Send + Sync)> {
        self.list.iter().find(|(known, _)| known.as_str() == name).map(|(_, grammar)| &**grammar)
    }

    /// Runs the grammar of a lot and collects a model, with default settings.
    ///
    /// # Errors
    /// [`Error::Lot`] for a grammar that does not exist, and the errors of a run.
    pub fn generate(&self, lot: &Shape) -> Result<Model, Error> {
        self.generate_with(lot, &Settings::default())
    }

    /// Runs the grammar of a lot with settings, and collects a model.
    ///
    /// # Errors
    /// As [`generate`](Grammars::generate).
    pub fn generate_with(&self, lot: &Shape, settings: &Settings) -> Result<Model, Error> {
        let mut model = Model::new();
        let report = self.session(settings).run(lot, &mut model)?;
        Ok(model.with_report(report).with_assets(settings.assets.clone()))
    }

    /// Runs the grammar of a lot and hands the leaves to a sink.
    ///
    /// # Errors
    /// As [`generate`](Grammars::generate).
    pub fn run(&self, lot: &Shape, settings: &Settings, sink: &mut dyn Sink) -> Result<Report, Error> {
        self.session(settings).run(lot, sink)
    }

    /// Opens a session: several runs with the same settings. Each grammar is checked at its first lot.
    pub fn session(&self, settings: &Settings) -> Box<dyn DynSession + '_> {
        let sessions = self.list.iter().map(|_| None).collect();
        let own = Settings { echo: false, start: None, ..settings.clone() };
        let (start, echo) = (settings.start.clone(), settings.echo);
        Box::new(GrammarsSession { grammars: self, settings: own, start, echo, sessions })
    }

    /// Runs on many lots, in parallel with the feature `rayon`, and collects a model of each.
    ///
    /// # Errors
    /// The first error in the order of the lots.
    pub fn generate_all(&self, lots: &[Shape], settings: &Settings) -> Result<Batches<Model>, RunError> {
        let open = |settings: &Settings| Ok(self.session(settings));
        generate_by(&Runs { open: &open, count: lots.len(), run: &alone(lots) }, settings)
    }

    /// Runs on many lots, in parallel with the feature `rayon`, with a sink for each stretch of lots.
    ///
    /// # Errors
    /// The first error in the order of the lots.
    pub fn run_all<S: Sink + Send>(
        &self,
        lots: &[Shape],
        settings: &Settings,
        sink: impl Fn(&Stretch) -> S + Sync,
    ) -> Result<Batches<S>, RunError> {
        let open = |settings: &Settings| Ok(self.session(settings));
        run_by(&Runs { open: &open, count: lots.len(), run: &alone(lots) }, settings, sink)
    }
}

/// The sessions of the grammars that had a lot so far.
struct GrammarsSession<'g> {
    grammars: &'g Grammars,
    /// Without echo, and without the start rule.
    settings: Settings,
    start: Option<String>,
    echo: bool,
    sessions: Vec<Option<Box<dyn DynSession + 'g>>>,
}

impl GrammarsSession<'_> {
    /// The number of a lot's grammar, and what is wrong with its name. The first grammar takes the place of an unknown one.
    fn number_of(&self, lot: &Shape) -> (usize, Option<String>) {
        let first = || self.grammars.names().next();
        let Some(name) = lot.grammar_name().or_else(first) else { return (0, None) };
        let number = self.grammars.names().position(|known| known == name);
        if let (Some(number), true) = (number, self.grammars.shared.contains(name)) {
            let name = shown(name);
            let problem =
                format!("the set has several grammars of the name `{name}`; add one of them with `with_named`");
            return (number, Some(problem));
        }
        let problem = || {
            let known: Vec<&str> = self.grammars.names().collect();
            format!("`{}` is not a grammar of the set; the grammars are {}", shown(name), known.join(", "))
        };
        (number.unwrap_or_default(), number.is_none().then(problem))
    }

    /// Passes a lot with its start rule to the session of its grammar. Returns the result, and the faults of the lot.
    ///
    /// # Errors
    /// The lot is refused, or its grammar is.
    fn of_lot<T>(
        &mut self,
        lot: &Shape,
        run: impl FnOnce(&mut (dyn DynSession + '_), &Shape) -> T,
    ) -> Result<(T, Vec<Fault>), Error> {
        let (number, problem) = self.number_of(lot);
        let Some((_, grammar)) = self.grammars.list.get(number) else {
            let problems = vec!["the set has no grammars".to_owned()];
            return Err(Error::Lot { lot: lot.name().to_owned(), problems });
        };
        let faults = lots::faults(lot, problem.as_slice(), self.settings.wrong_lots)?;
        let session = match &mut self.sessions[number] {
            Some(session) => session,
            none => none.insert(grammar.session(&self.settings)?),
        };
        // The rule of the settings need not be in all grammars, so each lot without a rule of its own gets it.
        let started = match (&self.start, lot.start_name()) {
            (Some(start), None) => &lot.with_start(Some(start)),
            _ => lot,
        };
        Ok((run(&mut **session, started), faults))
    }
}

impl DynSession for GrammarsSession<'_> {
    fn run(&mut self, shape: &Shape, sink: &mut dyn Sink) -> Result<Report, Error> {
        let RunOutcome { report, error, .. } = self.outcome(shape, None, sink);
        if self.echo {
            derive::echo(&report.prints);
        }
        error.map_or(Ok(report), Err)
    }

    fn outcome(&mut self, shape: &Shape, neighbours: Option<&Arc<Neighbours>>, sink: &mut dyn Sink) -> RunOutcome {
        if let Some(stopped) = RunOutcome::stopped(&self.settings) {
            return stopped;
        }
        let run = |session: &mut (dyn DynSession + '_), lot: &Shape| session.outcome(lot, neighbours, sink);
        match self.of_lot(shape, run) {
            Ok((mut outcome, faults)) => {
                outcome.report.begin_with(faults);
                outcome
            }
            Err(error) => RunOutcome::failed(error),
        }
    }

    fn queries(&mut self, shape: &Shape) -> Queries {
        self.of_lot(shape, |session, lot| session.queries(lot))
            .map_or_else(|_| Queries::default(), |(queries, _)| queries)
    }

    fn ghost(&mut self, shape: &Shape, collect: Collect) -> Result<Ghost, NoResult> {
        let found = self.of_lot(shape, |session, lot| session.ghost(lot, collect)).map_err(NoResult::Failed)?;
        found.0
    }
}
