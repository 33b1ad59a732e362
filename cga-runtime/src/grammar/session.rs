//! Several runs of one grammar with the same settings.
//!
//! A [`Session`] checks the attributes and finds the start rule once, and for lots with data of their own once for equal data. It keeps
//! data that runs can share. The results of its runs equal the results of single runs. A session belongs to one thread; parallel runs have
//! one session each, see [`parallel`](crate::grammar::parallel).
//!
//! If rules ask about shapes of the same initial shape, a run derives it twice. The first derivation leaves out rules whose shapes no query
//! finds, as façades. It leaves no reports, prints and faults, its error ends the run, and Rust functions in its rules are called in both. Queries of other initial shapes give their defaults,
//! unless the run is part of a [`Scene`](crate::grammar::scene::Scene).

use std::borrow::Cow;
use std::fmt;
use std::sync::Arc;

use crate::fault::{Error, Fault};
use crate::grammar::{Grammar, lots};
use crate::output::model::Model;
use crate::run::derive::{self, Derivation, Kept, NoResult, RunOutcome, Start};
use crate::run::ghost::leaf_sink::LeafGhost;
use crate::run::ghost::{Collect, Ghost};
use crate::run::queries::Queries;
use crate::run::report::Report;
use crate::run::rules::Rules;
use crate::run::settings::Settings;
use crate::run::sink::Sink;
use crate::run::surroundings::Neighbours;
use crate::shape::Shape;
use crate::shape::lot::Lot;
use crate::value::Value;
use crate::value::text::Text;

/// Several runs of one grammar with the same settings. Made by `grammar.session(&settings)`.
pub struct Session<'g, G: Rules> {
    setup: Setup<'g, G>,
    kept: Kept<G::Call>,
    /// The grammars of the last lots with data of their own, the last one first.
    of_lots: Vec<LotGrammar<G>>,
}

impl<G: Rules> fmt::Debug for Session<'_, G> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Session").field("settings", &self.setup.settings).finish_non_exhaustive()
    }
}

/// The decisions before the first run.
#[derive(Debug)]
struct Setup<'g, G> {
    grammar: &'g G,
    /// Borrowed by sessions that end before their caller does.
    settings: Cow<'g, Settings>,
    start: Start,
}

/// A grammar with the values of a lot. Lots with equal data share it, and all that its runs keep.
struct LotGrammar<G: Rules> {
    lot: Lot,
    grammar: G,
    start: Start,
    problems: Vec<String>,
    kept: Kept<G::Call>,
}

/// A run that can begin.
struct Prepared<'s, G: Rules> {
    grammar: &'s G,
    start: Start,
    settings: &'s Settings,
    kept: &'s mut Kept<G::Call>,
    /// The faults of a lot, which come first.
    faults: Vec<Fault>,
}

/// The number of [`LotGrammar`]s that a session keeps.
const KEPT_LOTS: usize = 16;

impl<'g, G: Rules + Grammar + Clone> Setup<'g, G> {
    /// Checks the attributes and finds the start rule.
    fn new(grammar: &'g G, settings: Cow<'g, Settings>) -> Result<Self, Error> {
        grammar.check()?;
        let start = Start::find(grammar.tables(), settings.start.as_deref())?;
        Ok(Setup { grammar, settings, start })
    }

    /// The grammar with the values of a lot, its start rule, and what is wrong with them.
    fn of_lot(&self, lot: &Lot) -> (G, Start, Vec<String>) {
        let mut grammar = self.grammar.clone();
        let mut problems = lots::set_values(&mut grammar, lot);
        let tables = self.grammar.tables();
        let start = lot.start.as_deref().map_or(Ok(self.start), |rule| Start::find(tables, Some(rule)));
        let start = start.unwrap_or_else(|error| {
            problems.push(error.to_string());
            self.start
        });
        (grammar, start, problems)
    }
}

impl<'g, G: Rules + Grammar + Clone> Session<'g, G> {
    /// Opens a session. The method `session` of generated grammars does the same.
    ///
    /// # Errors
    /// [`Error::Attribute`] and [`Error::StartRule`], as they do not depend on the initial shape.
    pub fn new(grammar: &'g G, settings: &Settings) -> Result<Self, Error> {
        Ok(Session::of(Setup::new(grammar, Cow::Owned(settings.clone()))?))
    }

    fn of(setup: Setup<'g, G>) -> Self {
        Session { setup, kept: Kept::default(), of_lots: Vec::new() }
    }

    /// The settings of all runs.
    pub fn settings(&self) -> &Settings {
        &self.setup.settings
    }

    /// Runs on a shape and hands the leaves to a sink. The sink is not [finished](Sink::finish): more runs may follow.
    ///
    /// # Errors
    /// [`Error::Shape`], [`Error::Lot`], [`Error::Limit`], [`Error::Cycle`]. The session can be used again after an error.
    pub fn run<S: Sink + ?Sized>(&mut self, shape: &Shape, sink: &mut S) -> Result<Report, Error> {
        let outcome = self.outcome(shape, None, &mut { sink });
        if self.setup.settings.echo {
            derive::echo(&outcome.report.prints);
        }
        outcome.error.map_or(Ok(outcome.report), Err)
    }

    /// Runs on a shape and collects a model.
    ///
    /// # Errors
    /// As [`run`](Session::run).
    pub fn generate(&mut self, shape: &Shape) -> Result<Model, Error> {
        let mut model = Model::new();
        let report = self.run(shape, &mut model)?;
        Ok(model.with_report(report).with_assets(self.setup.settings.assets.clone()))
    }

    /// Runs on a shape among shapes of other initial shapes, without echo.
    fn outcome(&mut self, shape: &Shape, neighbours: Option<&Arc<Neighbours>>, sink: &mut dyn Sink) -> RunOutcome {
        let prepared = match self.prepared(shape) {
            Ok(prepared) => prepared,
            Err(reason) => return reason.into(),
        };
        let Prepared { grammar, start, settings, kept, faults } = prepared;
        let mut outcome = derive::run(&Derivation { rules: grammar, start, shape, settings }, neighbours, kept, sink);
        outcome.report.begin_with(faults);
        outcome
    }

    /// The shapes that a run on a shape leaves for the queries of its neighbours.
    fn ghost(&mut self, shape: &Shape, collect: Collect) -> Result<Ghost, NoResult> {
        let Prepared { grammar, start, settings, .. } = self.prepared(shape)?;
        Derivation { rules: grammar, start, shape, settings }.ghost(collect)
    }

    /// The queries of other shapes that a run on a shape can reach.
    fn queries(&self, shape: &Shape) -> Queries {
        let own = shape.start_name().and_then(|rule| Start::find(self.setup.grammar.tables(), Some(rule)).ok());
        own.unwrap_or(self.setup.start).queries
    }

    /// Prepares a run on a shape.
    fn prepared(&mut self, shape: &Shape) -> Result<Prepared<'_, G>, NoResult> {
        if RunOutcome::stopped(&self.setup.settings).is_some() {
            return Err(NoResult::Stopped);
        }
        shape.check_initial().map_err(NoResult::Failed)?;
        if let Some(lot) = shape.lot() {
            return self.prepared_lot(lot, shape);
        }
        let Session { setup: Setup { grammar, settings, start }, kept, .. } = self;
        Ok(Prepared { grammar, start: *start, settings, kept, faults: Vec::new() })
    }

    /// Prepares a run on a shape with data of its own.
    fn prepared_lot(&mut self, lot: &Lot, shape: &Shape) -> Result<Prepared<'_, G>, NoResult> {
        let Session { setup, of_lots, .. } = self;
        match of_lots.iter().position(|known| known.lot.is_same(lot)) {
            Some(at) => of_lots[..=at].rotate_right(1),
            None => {
                let (grammar, start, problems) = setup.of_lot(lot);
                of_lots.truncate(KEPT_LOTS - 1);
                of_lots.insert(0, LotGrammar { lot: lot.clone(), grammar, start, problems, kept: Kept::default() });
            }
        }
        let LotGrammar { grammar, start, problems, kept, .. } = &mut of_lots[0];
        let faults = lots::faults(shape, problems, setup.settings.wrong_lots).map_err(NoResult::Failed)?;
        Ok(Prepared { grammar, start: *start, settings: &setup.settings, kept, faults })
    }
}

/// A session of a grammar that is chosen at run time. Made by [`Grammar::session`].
pub trait DynSession {
    /// Runs on a shape and hands the leaves to a sink; see [`Session::run`].
    ///
    /// # Errors
    /// See [`Error`].
    fn run(&mut self, shape: &Shape, sink: &mut dyn Sink) -> Result<Report, Error>;

    /// Runs on a shape among shapes of other initial shapes, without echo, and keeps the report of a run that fails.
    #[doc(hidden)]
    fn outcome(&mut self, shape: &Shape, _neighbours: Option<&Arc<Neighbours>>, sink: &mut dyn Sink) -> RunOutcome {
        match self.run(shape, sink) {
            Ok(report) => report.into(),
            Err(error) => RunOutcome::failed(error),
        }
    }

    /// The queries of other shapes that a run on a shape can reach. A grammar that is written by hand has none.
    #[doc(hidden)]
    fn queries(&mut self, _shape: &Shape) -> Queries {
        Queries::default()
    }

    /// The shapes that a run on a shape leaves for the queries of its neighbours. A grammar that is written by hand leaves its closed
    /// leaves.
    #[doc(hidden)]
    fn ghost(&mut self, shape: &Shape, collect: Collect) -> Result<Ghost, NoResult> {
        let mut leaves = LeafGhost::new(collect);
        match self.outcome(shape, None, &mut leaves) {
            RunOutcome { report, error: None, .. } if !report.stopped => Ok(leaves.finish()),
            RunOutcome { error, .. } => Err(error.map_or(NoResult::Stopped, NoResult::Failed)),
        }
    }
}

impl<G: Rules + Grammar + Clone> DynSession for Session<'_, G> {
    fn run(&mut self, shape: &Shape, sink: &mut dyn Sink) -> Result<Report, Error> {
        Session::run(self, shape, sink)
    }

    fn outcome(&mut self, shape: &Shape, neighbours: Option<&Arc<Neighbours>>, sink: &mut dyn Sink) -> RunOutcome {
        Session::outcome(self, shape, neighbours, sink)
    }

    fn queries(&mut self, shape: &Shape) -> Queries {
        Session::queries(self, shape)
    }

    fn ghost(&mut self, shape: &Shape, collect: Collect) -> Result<Ghost, NoResult> {
        Session::ghost(self, shape, collect)
    }
}

/// A session of a grammar that only has `run`.
pub(crate) struct SingleRuns<'g, G: ?Sized> {
    pub(crate) grammar: &'g G,
    pub(crate) settings: Settings,
}

impl<G: Grammar + ?Sized> DynSession for SingleRuns<'_, G> {
    fn run(&mut self, shape: &Shape, sink: &mut dyn Sink) -> Result<Report, Error> {
        let Some(lot) = shape.lot() else { return self.grammar.run(shape, &self.settings, sink) };
        let mut grammar = self.grammar.boxed();
        let mut problems = lots::set_values(&mut *grammar, lot);
        let own = lot.start.as_deref().map(|rule| derive::known_start(rule, grammar.start_rules()));
        let own = own.transpose().unwrap_or_else(|error| {
            problems.push(error.to_string());
            None
        });
        let faults = lots::faults(shape, &problems, self.settings.wrong_lots)?;
        let start = own.map(|start| start.name.to_string()).or_else(|| self.settings.start.clone());
        // The grammar may pass the shape on to another grammar, for which the data is not meant.
        let mut report = grammar.run(&shape.without_lot(), &Settings { start, ..self.settings.clone() }, sink)?;
        report.begin_with(faults);
        Ok(report)
    }
}

/// Runs a grammar on a shape, in a session of one run. Used by generated code.
///
/// # Errors
/// See [`Error`].
pub fn run<G: Rules + Grammar + Clone, S: Sink + ?Sized>(
    grammar: &G,
    shape: &Shape,
    settings: &Settings,
    sink: &mut S,
) -> Result<Report, Error> {
    once(grammar, settings)?.run(shape, sink)
}

/// Runs a grammar and collects a model. Used by generated code.
///
/// # Errors
/// See [`Error`].
pub fn generate<G: Rules + Grammar + Clone>(grammar: &G, shape: &Shape, settings: &Settings) -> Result<Model, Error> {
    once(grammar, settings)?.generate(shape)
}

/// Runs a rule of a grammar by its name, also if the lot names another one, and collects a model. Used by generated code.
///
/// # Errors
/// See [`Error`].
pub fn generate_from<G: Rules + Grammar + Clone>(grammar: &G, rule: &str, shape: &Shape) -> Result<Model, Error> {
    let settings = Settings { start: Some(rule.to_owned()), ..Settings::default() };
    generate(grammar, &shape.with_start(None), &settings)
}

/// The names and values of the attributes of a run on a shape, without running rules. Used by generated code.
///
/// # Errors
/// See [`Grammar::used_values`].
pub fn used_values<G: Rules + Grammar + Clone>(
    grammar: &G,
    shape: &Shape,
    settings: &Settings,
) -> Result<Vec<(Text, Value)>, Error> {
    let setup = Setup::new(grammar, Cow::Borrowed(settings))?;
    shape.check_initial()?;
    let values = match shape.lot() {
        None => derive::used_values(grammar, setup.start, shape, settings)?,
        Some(lot) => {
            let (grammar, start, problems) = setup.of_lot(lot);
            lots::faults(shape, &problems, settings.wrong_lots)?;
            derive::used_values(&grammar, start, shape, settings)?
        }
    };
    let pairs = grammar.attributes().iter().zip(values);
    Ok(pairs.filter_map(|(attribute, value)| Some((attribute.name.clone(), value?))).collect())
}

/// A session for one run.
fn once<'g, G: Rules + Grammar + Clone>(grammar: &'g G, settings: &'g Settings) -> Result<Session<'g, G>, Error> {
    Ok(Session::of(Setup::new(grammar, Cow::Borrowed(settings))?))
}
