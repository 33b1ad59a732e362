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
use std::marker::PhantomData;
use std::sync::Arc;

use crate::fault::{Error, Fault};
use crate::grammar::attribute::Attribute;
use crate::grammar::kept_lots::KeptLots;
use crate::grammar::{Grammar, lots};
use crate::output::buffers::size::{BufferSize, Measuring};
use crate::output::model::Model;
use crate::run::derive::{self, Derivable, Derivation, Kept, NoResult, RunOutcome, Start};
use crate::run::ghost::leaf_sink::LeafGhost;
use crate::run::ghost::{Collect, Ghost};
use crate::run::queries::Queries;
use crate::run::report::Report;
use crate::run::rules::{RuleTables, Rules};
use crate::run::settings::Settings;
use crate::run::sink::Sink;
use crate::run::surroundings::Neighbours;
use crate::shape::Shape;
use crate::shape::lot::Lot;
use crate::value::Value;
use crate::value::text::Text;

/// Several runs of one grammar with the same settings. Made by `grammar.session(&settings)`.
pub struct Session<'g, G: Rules> {
    runs: GrammarSession<'g>,
    grammar: PhantomData<&'g G>,
}

impl<G: Rules> fmt::Debug for Session<'_, G> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Session").field("settings", &self.runs.settings).finish_non_exhaustive()
    }
}

/// A grammar of any type whose sessions set the values of lots.
trait AnyGrammar: Derivable {
    fn copy<'c>(&self) -> Box<dyn AnyGrammar + 'c>
    where
        Self: 'c;

    fn as_grammar(&mut self) -> &mut dyn Grammar;
}

impl<G: Rules + Grammar + Clone> AnyGrammar for G {
    fn copy<'c>(&self) -> Box<dyn AnyGrammar + 'c>
    where
        Self: 'c,
    {
        Box::new(self.clone())
    }

    fn as_grammar(&mut self) -> &mut dyn Grammar {
        self
    }
}

/// A session that does not have the type of its grammar, so it is compiled once.
struct GrammarSession<'g> {
    grammar: &'g (dyn AnyGrammar + 'g),
    /// Borrowed by sessions that end before their caller does.
    settings: Cow<'g, Settings>,
    start: Start,
    kept: Kept,
    lots: KeptLots,
    /// The grammars of `lots`.
    of_lots: Vec<LotGrammar<'g>>,
}

/// A grammar with the values of a lot. Lots with equal data share it, and all that its runs keep.
struct LotGrammar<'g> {
    grammar: Box<dyn AnyGrammar + 'g>,
    start: Start,
    problems: Vec<String>,
    kept: Kept,
}

/// The grammar of a run that can begin.
#[derive(Debug)]
struct Prepared {
    /// The index of its [`LotGrammar`]; `None` for the grammar of the session.
    lot: Option<usize>,
    /// The faults of a lot, which come first.
    faults: Vec<Fault>,
}

impl<'g, G: Rules + Grammar + Clone> Session<'g, G> {
    /// Opens a session. The method `session` of generated grammars does the same.
    ///
    /// # Errors
    /// [`Error::Attribute`] and [`Error::StartRule`], as they do not depend on the initial shape.
    pub fn new(grammar: &'g G, settings: &Settings) -> Result<Self, Error> {
        let runs = GrammarSession::new(grammar, Cow::Owned(settings.clone()))?;
        Ok(Session { runs, grammar: PhantomData })
    }

    /// The settings of all runs.
    pub fn settings(&self) -> &Settings {
        &self.runs.settings
    }

    /// Runs on a shape and hands the leaves to a sink. The sink is not [finished](Sink::finish): more runs may follow.
    ///
    /// # Errors
    /// [`Error::Shape`], [`Error::Lot`], [`Error::Limit`], [`Error::Cycle`]. The session can be used again after an error.
    pub fn run<S: Sink + ?Sized>(&mut self, shape: &Shape, sink: &mut S) -> Result<Report, Error> {
        self.runs.run(shape, &mut { sink })
    }

    /// Runs on a shape and collects a model.
    ///
    /// # Errors
    /// As [`run`](Session::run).
    pub fn generate(&mut self, shape: &Shape) -> Result<Model, Error> {
        self.runs.generate(shape)
    }

    /// The size of the buffers that a run on a shape fills, for memory that is allocated once. It takes a run without output, which is a small
    /// part of a run where rules repeat: about 5 ns a leaf from templates. Meshes are cut into triangles as for the buffers.
    ///
    /// ```
    /// # use cga_runtime::facade as cga;
    /// use cga::sink::buffers::Buffers;
    /// use cga::{DynSession, Error, Shape};
    ///
    /// fn filled(session: &mut dyn DynSession, shape: &Shape) -> Result<Buffers, Error> {
    ///     let size = session.measure(shape)?;
    ///     let mut buffers = Buffers::with_capacity(size.vertices, size.indices);
    ///     session.run(shape, &mut buffers)?;
    ///     Ok(buffers)
    /// }
    /// ```
    ///
    /// # Errors
    /// As [`run`](Session::run).
    pub fn measure(&mut self, shape: &Shape) -> Result<BufferSize, Error> {
        self.runs.measure(shape)
    }
}

impl<'g> GrammarSession<'g> {
    fn new(grammar: &'g (dyn AnyGrammar + 'g), settings: Cow<'g, Settings>) -> Result<Self, Error> {
        grammar.check_values()?;
        let start = Start::find(grammar.rule_tables(), settings.start.as_deref())?;
        let (kept, lots) = (Kept::default(), KeptLots::default());
        Ok(GrammarSession { grammar, settings, start, kept, lots, of_lots: Vec::new() })
    }

    fn generate(&mut self, shape: &Shape) -> Result<Model, Error> {
        let mut model = Model::new();
        let report = self.run(shape, &mut model)?;
        Ok(model.with_report(report).with_assets(self.settings.assets.clone()))
    }

    /// The grammar and the start rule of a run.
    fn chosen(&self, lot: Option<usize>) -> (&dyn AnyGrammar, Start) {
        match lot {
            None => (self.grammar, self.start),
            Some(at) => (&*self.of_lots[at].grammar, self.of_lots[at].start),
        }
    }

    /// Prepares a run on a shape, unless the watch is stopped.
    fn prepared(&mut self, shape: &Shape) -> Result<Prepared, NoResult> {
        if RunOutcome::stopped(&self.settings).is_some() {
            return Err(NoResult::Stopped);
        }
        self.checked(shape).map_err(NoResult::Failed)
    }

    /// Checks a shape, and finds or makes the grammar of its lot.
    fn checked(&mut self, shape: &Shape) -> Result<Prepared, Error> {
        shape.check_initial()?;
        let Some(lot) = shape.lot() else { return Ok(Prepared { lot: None, faults: Vec::new() }) };
        let at = match self.lots.find(lot) {
            Some(at) => at,
            None => self.add(lot),
        };
        let faults = lots::faults(shape, &self.of_lots[at].problems, self.settings.wrong_lots)?;
        Ok(Prepared { lot: Some(at), faults })
    }

    /// Makes the grammar of a lot. Returns its index.
    fn add(&mut self, lot: &Lot) -> usize {
        let mut grammar = self.grammar.copy();
        let mut problems = lots::set_values(grammar.as_grammar(), lot);
        let start = start_of_lot(self.grammar.rule_tables(), lot, self.start, &mut problems);
        let made = LotGrammar { grammar, start, problems, kept: Kept::default() };
        let at = self.lots.add(lot);
        match self.of_lots.get_mut(at) {
            Some(old) => *old = made,
            None => self.of_lots.push(made),
        }
        at
    }
}

/// The start rule of a lot. The start rule of the session replaces one that does not exist, which is a problem.
fn start_of_lot(tables: &RuleTables, lot: &Lot, own: Start, problems: &mut Vec<String>) -> Start {
    let start = lot.start.as_deref().map_or(Ok(own), |rule| Start::find(tables, Some(rule)));
    start.unwrap_or_else(|error| {
        problems.push(error.to_string());
        own
    })
}

/// A session of a grammar that is chosen at run time. Made by [`Grammar::session`].
pub trait DynSession {
    /// Runs on a shape and hands the leaves to a sink; see [`Session::run`].
    ///
    /// # Errors
    /// See [`Error`].
    fn run(&mut self, shape: &Shape, sink: &mut dyn Sink) -> Result<Report, Error>;

    /// The size of the buffers that a run on a shape fills; see [`Session::measure`].
    ///
    /// # Errors
    /// See [`Error`].
    fn measure(&mut self, shape: &Shape) -> Result<BufferSize, Error> {
        let mut measuring = Measuring::default();
        match self.outcome(shape, None, &mut measuring).error {
            Some(error) => Err(error),
            None => Ok(measuring.size),
        }
    }

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

impl DynSession for GrammarSession<'_> {
    fn run(&mut self, shape: &Shape, sink: &mut dyn Sink) -> Result<Report, Error> {
        self.outcome(shape, None, sink).result(self.settings.echo)
    }

    fn outcome(&mut self, shape: &Shape, neighbours: Option<&Arc<Neighbours>>, sink: &mut dyn Sink) -> RunOutcome {
        let Prepared { lot, faults } = match self.prepared(shape) {
            Ok(prepared) => prepared,
            Err(reason) => return reason.into(),
        };
        let (rules, start, kept): (&dyn AnyGrammar, _, _) = match lot {
            None => (self.grammar, self.start, &mut self.kept),
            Some(at) => {
                let LotGrammar { grammar, start, kept, .. } = &mut self.of_lots[at];
                (&**grammar, *start, kept)
            }
        };
        let derivation = Derivation { rules, tables: rules.rule_tables(), start, shape, settings: &self.settings };
        let mut outcome = derivation.run(neighbours, kept, sink);
        outcome.report.begin_with(faults);
        outcome
    }

    fn queries(&mut self, shape: &Shape) -> Queries {
        let own = shape.start_name().and_then(|rule| Start::find(self.grammar.rule_tables(), Some(rule)).ok());
        own.unwrap_or(self.start).queries
    }

    fn ghost(&mut self, shape: &Shape, collect: Collect) -> Result<Ghost, NoResult> {
        let Prepared { lot, .. } = self.prepared(shape)?;
        let (rules, start) = self.chosen(lot);
        Derivation { rules, tables: rules.rule_tables(), start, shape, settings: &self.settings }.ghost(collect)
    }
}

impl<G: Rules + Grammar + Clone> DynSession for Session<'_, G> {
    fn run(&mut self, shape: &Shape, sink: &mut dyn Sink) -> Result<Report, Error> {
        self.runs.run(shape, sink)
    }

    fn outcome(&mut self, shape: &Shape, neighbours: Option<&Arc<Neighbours>>, sink: &mut dyn Sink) -> RunOutcome {
        self.runs.outcome(shape, neighbours, sink)
    }

    fn queries(&mut self, shape: &Shape) -> Queries {
        self.runs.queries(shape)
    }

    fn ghost(&mut self, shape: &Shape, collect: Collect) -> Result<Ghost, NoResult> {
        self.runs.ghost(shape, collect)
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

/// Opens a session of a grammar that is chosen at run time. Used by generated code.
///
/// # Errors
/// As [`Session::new`].
pub fn open<'g, G: Rules + Grammar + Clone>(
    grammar: &'g G,
    settings: &Settings,
) -> Result<Box<dyn DynSession + 'g>, Error> {
    opened(grammar, settings)
}

fn opened<'g>(grammar: &'g (dyn AnyGrammar + 'g), settings: &Settings) -> Result<Box<dyn DynSession + 'g>, Error> {
    Ok(Box::new(GrammarSession::new(grammar, Cow::Owned(settings.clone()))?))
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
    single_run(grammar, shape, settings, &mut { sink })
}

fn single_run(
    grammar: &dyn AnyGrammar,
    shape: &Shape,
    settings: &Settings,
    sink: &mut dyn Sink,
) -> Result<Report, Error> {
    GrammarSession::new(grammar, Cow::Borrowed(settings))?.run(shape, sink)
}

/// Runs a grammar and collects a model. Used by generated code.
///
/// # Errors
/// See [`Error`].
pub fn generate<G: Rules + Grammar + Clone>(grammar: &G, shape: &Shape, settings: &Settings) -> Result<Model, Error> {
    single_model(grammar, shape, settings)
}

fn single_model(grammar: &dyn AnyGrammar, shape: &Shape, settings: &Settings) -> Result<Model, Error> {
    GrammarSession::new(grammar, Cow::Borrowed(settings))?.generate(shape)
}

/// Runs a rule of a grammar by its name, also if the lot names another one, and collects a model. Used by generated code.
///
/// # Errors
/// See [`Error`].
pub fn generate_from<G: Rules + Grammar + Clone>(grammar: &G, rule: &str, shape: &Shape) -> Result<Model, Error> {
    let settings = Settings { start: Some(rule.to_owned()), ..Settings::default() };
    single_model(grammar, &shape.with_start(None), &settings)
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
    Ok(named(grammar.attributes(), used_values_of(grammar, shape, settings)?))
}

fn used_values_of(grammar: &dyn AnyGrammar, shape: &Shape, settings: &Settings) -> Result<Vec<Option<Value>>, Error> {
    let mut session = GrammarSession::new(grammar, Cow::Borrowed(settings))?;
    let Prepared { lot, .. } = session.checked(shape)?;
    let (chosen, start) = session.chosen(lot);
    derive::used_values(chosen, start, shape, settings)
}

/// The values of attributes with their names.
fn named(attributes: &[Attribute], values: Vec<Option<Value>>) -> Vec<(Text, Value)> {
    let pairs = attributes.iter().zip(values);
    pairs.filter_map(|(attribute, value)| Some((attribute.name.clone(), value?))).collect()
}

/// The model of the only run of a session.
pub(super) fn model(
    session: Result<Box<dyn DynSession + '_>, Error>,
    shape: &Shape,
    settings: &Settings,
) -> Result<Model, Error> {
    let mut model = Model::new();
    let report = session?.run(shape, &mut model)?;
    Ok(model.with_report(report).with_assets(settings.assets.clone()))
}
