//! Scenes: initial shapes whose rules may ask about each other.

mod ghosts;
mod plan;
pub mod session;
pub mod shared;

use std::fmt;
use std::sync::atomic::{AtomicBool, Ordering};

use self::ghosts::{Distances, InSession, SceneRun};
use self::plan::plan_box;
use self::session::SceneSession;
use crate::fault::Error;
use crate::grammar::Grammar;
use crate::grammar::grammars::Grammars;
use crate::grammar::parallel::order::in_order;
use crate::grammar::parallel::{Runs, Stretch, Worker, generate_by, run_by};
use crate::output::batches::{Batches, RunError};
use crate::output::model::Model;
use crate::run::derive::{self, RunOutcome};
use crate::run::report::Report;
use crate::run::settings::Settings;
use crate::run::sink::{Flow, Sink};
use crate::shape::Shape;

/// Initial shapes with their grammars, whose rules may ask about each other: `touches(inter)`, `contextCount(all, "tower")`.
///
/// Each initial shape has its place, name, seed and attributes, its start rule ([`Shape::start`]) and in a set of [`Grammars`] its grammar
/// ([`Shape::grammar`]). A scene whose rules do not ask about neighbours costs as much as
/// [`generate_all`](crate::grammar::parallel::generate_all), and gives the same.
///
/// # Neighbours
///
/// A query of other initial shapes finds the shapes of those in its neighbourhood (*CGA and its context*): for occlusion queries within
/// [`occlusion_distance`](Scene::occlusion_distance), for queries of labelled shapes within
/// [`context_distance`](Scene::context_distance). The distance is horizontal, between the boxes around the initial shapes. So a building that
/// reaches far beyond its lot is missed.
///
/// While neighbours are derived for a query, their own queries of neighbours give the defaults: false, 0, and an infinite distance. So a model
/// depends neither on the order of the initial shapes nor on threads, and another initial shape can change only the models in its
/// neighbourhood. Each neighbour is derived once more for all queries of a scene, without the rules whose shapes no query finds. Its
/// reports, prints and faults are dropped, and Rust functions in its rules are called again. If its derivation fails, so does the run that needs
/// it, with the index of the neighbour.
///
/// Neighbours are dropped as soon as no later initial shape can ask about them, so initial shapes that are neighbours should be near each
/// other in the list. Labelled shapes stay until the end where the distance is infinite. If rules ask for labels of all initial shapes and for
/// closed shapes of neighbours, and more than 4,096 initial shapes have labels, each is derived twice, so that closed shapes need not stay.
///
/// A [`SharedScene`](shared::SharedScene) has lots that change.
///
/// ```
/// # // Rules are compiled by the crate `cga`; its tests run an example.
/// # use cga_runtime::facade as cga;
/// use cga::{Grammars, Scene, Settings, Shape};
///
/// let (grammars, lots) = (Grammars::new(), [Shape::rectangle(10.0, 8.0), Shape::rectangle(12.0, 8.0).at([10.0, 0.0, 0.0])]);
/// let scene = Scene::of_grammars(&grammars, &lots).occlusion_distance(0.5);
/// let error = scene.generate(&Settings::default()).unwrap_err();
/// assert_eq!((error.shape, error.error.to_string().as_str()), (Some(0), "a lot without a name: the set has no grammars"));
/// ```
#[derive(Clone, Copy)]
pub struct Scene<'s> {
    rules: SceneRules<'s>,
    lots: &'s [Shape],
    distances: Distances,
}

/// The grammars of a scene.
#[derive(Clone, Copy)]
enum SceneRules<'s> {
    One(&'s (dyn Grammar + Sync)),
    Set(&'s Grammars),
}

impl fmt::Debug for Scene<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Scene")
            .field("lots", &self.lots.len())
            .field("distances", &self.distances)
            .finish_non_exhaustive()
    }
}

impl<'s> Scene<'s> {
    /// Initial shapes of one grammar.
    pub fn new(grammar: &'s (dyn Grammar + Sync), lots: &'s [Shape]) -> Self {
        Scene::with_rules(SceneRules::One(grammar), lots)
    }

    /// Initial shapes that name their grammars in a set.
    pub fn of_grammars(grammars: &'s Grammars, lots: &'s [Shape]) -> Self {
        Scene::with_rules(SceneRules::Set(grammars), lots)
    }

    fn with_rules(rules: SceneRules<'s>, lots: &'s [Shape]) -> Self {
        Scene { rules, lots, distances: Distances::default() }
    }

    /// Sets the distance in metres up to which occlusion queries ask about another initial shape: 1 by default. NaN and negative numbers
    /// count as 0.
    #[must_use]
    pub fn occlusion_distance(self, metres: f64) -> Self {
        Scene { distances: self.distances.with_occlusion(metres), ..self }
    }

    /// Sets the distance in metres up to which queries of labelled shapes ask about another initial shape: infinite by default. NaN and
    /// negative numbers count as 0.
    #[must_use]
    pub fn context_distance(self, metres: f64) -> Self {
        Scene { distances: self.distances.with_context(metres), ..self }
    }

    /// The initial shapes.
    pub fn lots(&self) -> &'s [Shape] {
        self.lots
    }

    /// Runs all initial shapes, in parallel with the feature `rayon`, and collects a model of each.
    ///
    /// # Errors
    /// The first error in the order of the initial shapes, or an error that does not depend on one. If the derivation of a neighbour fails,
    /// the error has the index of this neighbour.
    pub fn generate(&self, settings: &Settings) -> Result<Batches<Model>, RunError> {
        self.with_runs(settings, |runs| generate_by(runs, settings))
    }

    /// Runs all initial shapes, in parallel with the feature `rayon`, with a sink for each stretch of them.
    ///
    /// # Errors
    /// As [`generate`](Scene::generate).
    pub fn run<S: Sink + Send>(
        &self,
        settings: &Settings,
        sink: impl Fn(&Stretch) -> S + Sync,
    ) -> Result<Batches<S>, RunError> {
        self.with_runs(settings, |runs| run_by(runs, settings, sink))
    }

    /// Runs all initial shapes, in parallel with the feature `rayon`, and passes the model of each to `take`, in their order. A model is
    /// dropped as soon as `take` has returned, so a scene need not fit into memory; at most 128 models that are finished early wait for their turn.
    /// `Break` ends the runs. Returns the merged report of the models that were passed on.
    ///
    /// # Errors
    /// As [`generate`](Scene::generate), after all earlier models were passed on.
    pub fn generate_each(
        &self,
        settings: &Settings,
        mut take: impl FnMut(usize, Model) -> Flow + Send,
    ) -> Result<Report, RunError> {
        self.with_runs(settings, |runs| {
            let quiet = Settings { echo: false, ..settings.clone() };
            let (first, again) = ((runs.open)(&quiet)?, || (runs.open)(&quiet).ok());
            let is_over = AtomicBool::new(false);
            let job = |session: &mut Worker<'_>, at: usize, _: &dyn Fn() -> bool| {
                let mut model = Model::new();
                if is_over.load(Ordering::Relaxed) {
                    return ((at, model, RunOutcome::default()), true);
                }
                let outcome = (runs.run)(session, at, &mut model);
                let ends = outcome.error.is_some() || outcome.report.stopped;
                ((at, model, outcome), ends)
            };
            let (mut report, mut failed) = (Report::default(), None);
            in_order(runs.count, first, again, job, |(at, model, outcome): (usize, Model, RunOutcome)| {
                if is_over.load(Ordering::Relaxed) {
                    return;
                }
                if settings.echo {
                    derive::echo(outcome.report.prints());
                }
                report.merge(outcome.report.clone(), &settings.limits);
                match outcome.error {
                    Some(error) => {
                        failed = Some(RunError { shape: Some(outcome.failed_neighbour.unwrap_or(at)), error })
                    }
                    None => {
                        let model = model.with_report(outcome.report).with_assets(settings.assets.clone());
                        is_over.store(take(at, model).is_break(), Ordering::Relaxed);
                    }
                }
            });
            report.stopped |= is_over.into_inner();
            failed.map_or(Ok(report), Err)
        })
    }

    /// Runs the initial shape with an index among its neighbours, and collects a model. Only neighbours that its rules can ask about are
    /// derived.
    ///
    /// # Errors
    /// [`Error::Shape`] for an index out of range, and the errors of a run, with the index of the initial shape whose derivation failed: this
    /// one, or a neighbour.
    pub fn generate_lot(&self, index: usize, settings: &Settings) -> Result<Model, RunError> {
        let mut model = Model::new();
        let report = self.run_lot(index, settings, &mut model)?;
        Ok(model.with_report(report).with_assets(settings.assets.clone()))
    }

    /// Runs the initial shape with an index among its neighbours, and hands the leaves to a sink.
    ///
    /// # Errors
    /// As [`generate_lot`](Scene::generate_lot).
    pub fn run_lot(&self, index: usize, settings: &Settings, sink: &mut dyn Sink) -> Result<Report, RunError> {
        if self.lots.len() <= index {
            return Err(Error::Shape(format!("the scene has no initial shape {index}")).into());
        }
        let mut session = self.open(&Settings { echo: false, ..settings.clone() })?;
        let run = self.scene_run(&mut session);
        if run.asks_about_all(index) {
            run.index_labels(self.lots, &|settings| self.open(settings), settings)?;
        }
        let mut runs = InSession { session: &mut session, lots: self.lots };
        let RunOutcome { report, error, failed_neighbour } = run.outcome(&mut runs, index, sink);
        if settings.echo {
            derive::echo(report.prints());
        }
        let shape = Some(failed_neighbour.unwrap_or(index));
        error.map_or(Ok(report), |error| Err(RunError { shape, error }))
    }

    /// Opens runs of some initial shapes, one after another on one thread, with sinks of the caller: a tile of a map whose other initial
    /// shapes are only neighbours.
    ///
    /// ```
    /// # // Rules are compiled by the crate `cga`; its tests run an example.
    /// # use cga_runtime::facade as cga;
    /// use cga::{Error, Report, Scene, Settings, Sink};
    ///
    /// /// The first `count` initial shapes in one sink.
    /// fn run(scene: &Scene<'_>, count: usize, sink: &mut dyn Sink) -> Result<Vec<Report>, Error> {
    ///     let mut session = scene.session(&Settings::default())?;
    ///     (0..count).map(|index| session.run(index, sink)).collect()
    /// }
    /// ```
    ///
    /// # Errors
    /// An attribute is refused, or the start rule is unknown.
    pub fn session(&self, settings: &Settings) -> Result<SceneSession<'s>, Error> {
        SceneSession::open(*self, settings)
    }

    /// The indices of the initial shapes whose models may change if the one with an index changes: itself, and those whose rules ask about
    /// neighbours and that are near enough. If an initial shape moves, the ones near its old place change too. Empty for an index out of
    /// range.
    ///
    /// # Errors
    /// An attribute is refused, or the start rule is unknown.
    pub fn affected_by(&self, index: usize, settings: &Settings) -> Result<Vec<usize>, Error> {
        let mut session = self.open(settings)?;
        Ok(self.scene_run(&mut session).affected_by(index))
    }

    /// Finds the queries of all initial shapes.
    fn scene_run(&self, session: &mut Worker<'_>) -> SceneRun {
        let queries = self.lots.iter().map(|lot| session.queries(lot)).collect();
        SceneRun::new(self.distances, queries, || self.lots.iter().map(plan_box).collect())
    }

    /// Opens a session for all lots.
    fn open(&self, settings: &Settings) -> Result<Worker<'s>, Error> {
        match self.rules {
            SceneRules::One(grammar) => grammar.session(settings),
            SceneRules::Set(grammars) => Ok(grammars.session(settings)),
        }
    }

    /// Passes the runs of all initial shapes to `run`.
    fn with_runs<T>(
        &self,
        settings: &Settings,
        run: impl FnOnce(&Runs<'_, '_>) -> Result<T, RunError>,
    ) -> Result<T, RunError> {
        let open = |settings: &Settings| self.open(settings);
        let mut session = self.open(&Settings { echo: false, ..settings.clone() })?;
        let scene = self.scene_run(&mut session);
        drop(session);
        scene.count_users();
        if (0..self.lots.len()).any(|index| scene.asks_about_all(index)) {
            scene.index_labels(self.lots, &open, settings)?;
        }
        let run_at = |session: &mut Worker<'_>, index: usize, sink: &mut dyn Sink| {
            scene.outcome(&mut InSession { session, lots: self.lots }, index, sink)
        };
        run(&Runs { open: &open, count: self.lots.len(), run: &run_at })
    }
}
