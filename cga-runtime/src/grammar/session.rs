//! Several runs of one grammar with the same settings.
//!
//! A [`Session`] checks the attributes and finds the start rule once, and keeps data that runs can share. The results
//! of its runs equal the results of single runs. A session belongs to one thread; parallel runs have one session each, see
//! [`parallel`](crate::grammar::parallel).

use std::borrow::Cow;
use std::fmt;

use crate::fault::Error;
use crate::grammar::Grammar;
use crate::output::model::Model;
use crate::run::derive::{self, Kept, RunOutcome, Start};
use crate::run::report::Report;
use crate::run::rules::Rules;
use crate::run::settings::Settings;
use crate::run::sink::Sink;
use crate::shape::Shape;
use crate::value::Value;

/// Several runs of one grammar with the same settings. Made by `grammar.session(&settings)`.
pub struct Session<'g, G: Rules> {
    setup: Setup<'g, G>,
    kept: Kept<G::Call>,
}

impl<G: Rules> fmt::Debug for Session<'_, G> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Session").field("settings", self.settings()).finish_non_exhaustive()
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

impl<'g, G: Rules> Setup<'g, G> {
    /// Checks the attributes and finds the start rule.
    fn new(grammar: &'g G, settings: Cow<'g, Settings>) -> Result<Self, Error> {
        grammar.check()?;
        let start = derive::start_rule::<G>(settings.start.as_deref())?;
        Ok(Setup { grammar, settings, start })
    }
}

impl<'g, G: Rules> Session<'g, G> {
    /// Opens a session. The method `session` of generated grammars does the same.
    ///
    /// # Errors
    /// [`Error::Attribute`] and [`Error::StartRule`], as they do not depend on the initial shape.
    pub fn new(grammar: &'g G, settings: &Settings) -> Result<Self, Error> {
        Ok(Session { setup: Setup::new(grammar, Cow::Owned(settings.clone()))?, kept: Kept::default() })
    }

    /// The settings of all runs.
    pub fn settings(&self) -> &Settings {
        &self.setup.settings
    }

    /// Runs on a shape and hands the leaves to a sink. The sink is not [finished](Sink::finish): more runs may follow.
    ///
    /// # Errors
    /// [`Error::Shape`], [`Error::Limit`], [`Error::Cycle`]. The session can be used again after an error.
    pub fn run<S: Sink + ?Sized>(&mut self, shape: &Shape, sink: &mut S) -> Result<Report, Error> {
        let outcome = self.outcome(shape, &mut { sink });
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

    /// Runs on a shape, without echo.
    fn outcome(&mut self, shape: &Shape, sink: &mut dyn Sink) -> RunOutcome {
        let Setup { grammar, settings, start } = &self.setup;
        if settings.watch.as_ref().is_some_and(|watch| watch.is_stopped()) {
            return RunOutcome { report: Report { stopped: true, ..Report::default() }, error: None };
        }
        if let Err(error) = shape.check_initial() {
            return RunOutcome { error: Some(error), ..RunOutcome::default() };
        }
        derive::run(*grammar, *start, shape, settings, &mut self.kept, sink)
    }
}

/// A session of a grammar that is chosen at run time. Made by [`Grammar::session`].
pub trait DynSession {
    /// Runs on a shape and hands the leaves to a sink; see [`Session::run`].
    ///
    /// # Errors
    /// See [`Error`].
    fn run(&mut self, shape: &Shape, sink: &mut dyn Sink) -> Result<Report, Error>;

    /// Runs on a shape, without echo, and keeps the report of a run that fails.
    #[doc(hidden)]
    fn outcome(&mut self, shape: &Shape, sink: &mut dyn Sink) -> RunOutcome {
        match self.run(shape, sink) {
            Ok(report) => RunOutcome { report, error: None },
            Err(error) => RunOutcome { report: Report::default(), error: Some(error) },
        }
    }
}

impl<G: Rules> DynSession for Session<'_, G> {
    fn run(&mut self, shape: &Shape, sink: &mut dyn Sink) -> Result<Report, Error> {
        Session::run(self, shape, sink)
    }

    fn outcome(&mut self, shape: &Shape, sink: &mut dyn Sink) -> RunOutcome {
        Session::outcome(self, shape, sink)
    }
}

/// A session of a grammar that only has `run`.
pub(crate) struct SingleRuns<'g, G: ?Sized> {
    pub(crate) grammar: &'g G,
    pub(crate) settings: Settings,
}

impl<G: Grammar + ?Sized> DynSession for SingleRuns<'_, G> {
    fn run(&mut self, shape: &Shape, sink: &mut dyn Sink) -> Result<Report, Error> {
        self.grammar.run(shape, &self.settings, sink)
    }
}

/// Runs a grammar on a shape, in a session of one run. Used by generated code.
///
/// # Errors
/// See [`Error`].
pub fn run<G: Rules, S: Sink + ?Sized>(
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
pub fn generate<G: Rules>(grammar: &G, shape: &Shape, settings: &Settings) -> Result<Model, Error> {
    once(grammar, settings)?.generate(shape)
}

/// The names and values of the attributes of a run on a shape, without running rules. Used by generated code.
///
/// # Errors
/// See [`Grammar::used_values`].
pub fn used_values<G: Rules + Grammar>(
    grammar: &G,
    shape: &Shape,
    settings: &Settings,
) -> Result<Vec<(&'static str, Value)>, Error> {
    let setup = Setup::new(grammar, Cow::Borrowed(settings))?;
    shape.check_initial()?;
    let values = derive::used_values(grammar, setup.start, shape, settings)?;
    let pairs = grammar.attributes().iter().zip(values);
    Ok(pairs.filter_map(|(attribute, value)| Some((attribute.name, value?))).collect())
}

/// A session for one run.
fn once<'g, G: Rules>(grammar: &'g G, settings: &'g Settings) -> Result<Session<'g, G>, Error> {
    Ok(Session { setup: Setup::new(grammar, Cow::Borrowed(settings))?, kept: Kept::default() })
}
