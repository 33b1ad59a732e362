//! Scenes whose lots have grammars and settings of their own, for programs in which lots change.

use std::collections::BTreeSet;
use std::fmt;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::ptr;
use std::sync::{Arc, OnceLock};

use super::ghosts::{Derivations, Distances, SceneRun};
use super::plan::{Plan, plan_box};
use crate::fault::Error;
use crate::geometry::mesh::Bounds;
use crate::geometry::small_sort::SmallSort;
use crate::grammar::Grammar;
use crate::grammar::parallel::Worker;
use crate::output::model::Model;
use crate::run::derive::{NoResult, RunOutcome};
use crate::run::ghost::{Collect, Ghost};
use crate::run::queries::Queries;
use crate::run::settings::Settings;
use crate::run::sink::Sink;
use crate::run::surroundings::Neighbours;
use crate::run::watch::Watch;
use crate::shape::Shape;

/// A lot of a [`SharedScene`]: a grammar, an initial shape and settings. It does not change; a changed lot is another one.
pub struct SceneLot {
    grammar: Box<dyn Grammar + Send + Sync>,
    shape: Shape,
    settings: Settings,
    facts: OnceLock<LotFacts>,
}

/// The data of a lot that decide which lots are neighbours.
struct LotFacts {
    queries: Queries,
    plan: Bounds,
}

impl fmt::Debug for SceneLot {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("SceneLot")
            .field("grammar", &self.grammar.name())
            .field("shape", &self.shape)
            .field("settings", &self.settings)
            .finish_non_exhaustive()
    }
}

impl SceneLot {
    /// A grammar on a shape, with settings.
    pub fn new(grammar: Box<dyn Grammar + Send + Sync>, shape: Shape, settings: Settings) -> Self {
        SceneLot { grammar, shape, settings, facts: OnceLock::new() }
    }

    /// The initial shape.
    pub fn shape(&self) -> &Shape {
        &self.shape
    }

    /// Returns true if the rules can ask about neighbours.
    pub fn asks_about_neighbours(&self) -> bool {
        self.has_any(Queries::INTER_OCCLUSION | Queries::INTER_CONTEXT)
    }

    fn has_any(&self, kind: Queries) -> bool {
        self.facts().queries.has_any(kind)
    }

    /// Finds the queries of the rules once. A lot that is refused has none, as its run never begins.
    fn facts(&self) -> &LotFacts {
        self.facts.get_or_init(|| {
            let queries = || {
                self.shape.check_initial()?;
                self.grammar.session(&self.settings).map(|mut session| session.queries(&self.shape))
            };
            // A grammar that is written by hand may panic, which its own run reports.
            let queries = catch_unwind(AssertUnwindSafe(queries)).ok().and_then(Result::ok);
            LotFacts { queries: queries.unwrap_or_default(), plan: plan_box(&self.shape) }
        })
    }

    /// The settings of a run with a watch.
    fn watched(&self, watch: Option<&Watch>) -> Settings {
        Settings { echo: false, watch: watch.cloned(), ..self.settings.clone() }
    }
}

/// A [`Scene`](super::Scene) whose lots have grammars and settings of their own, for programs in which lots change: editors and games.
///
/// It owns its lots, so threads can share it, and the next scene can share the lots that stay. Each thread generates one lot after the other.
/// The models equal the models of a [`Scene`](super::Scene) with the same lots, in any order. Each neighbour is derived once for all lots,
/// and stays until the scene is dropped.
///
/// The derivation of a neighbour has the settings of this lot and the watch of the run that asks for it. A neighbour that fails or panics leaves
/// no shapes, and its own run reports the error. In a [`Scene`](super::Scene) the runs that ask for it fail too.
///
/// ```
/// # // Rules are compiled by the crate `cga`; its tests run an example.
/// # use cga_runtime::facade as cga;
/// use std::sync::Arc;
///
/// use cga::{Error, Grammar, Model, SceneLot, Settings, Shape, SharedScene};
///
/// /// Replaces a lot of a scene. Returns the new scene, and the models that may be different.
/// fn replaced(scene: &SharedScene, at: usize, grammar: &dyn Grammar, shape: Shape) -> (SharedScene, Vec<Result<Model, Error>>) {
///     let mut lots = scene.lots().to_vec();
///     let new = Arc::new(SceneLot::new(grammar.boxed(), shape, Settings::default()));
///     let old = std::mem::replace(&mut lots[at], new.clone());
///     let next = SharedScene::new(lots);
///     let affected = next.affected_by(&[&*old, &*new]);
///     let models = affected.into_iter().map(|index| next.generate_lot(index, None)).collect();
///     (next, models)
/// }
/// ```
pub struct SharedScene {
    lots: Vec<Arc<SceneLot>>,
    distances: Distances,
    run: OnceLock<SceneRun>,
}

impl fmt::Debug for SharedScene {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("SharedScene")
            .field("lots", &self.lots.len())
            .field("distances", &self.distances)
            .finish_non_exhaustive()
    }
}

impl SharedScene {
    /// A scene of lots.
    pub fn new(lots: Vec<Arc<SceneLot>>) -> Self {
        SharedScene { lots, distances: Distances::default(), run: OnceLock::new() }
    }

    /// Sets the distance of occlusion queries; see [`Scene::occlusion_distance`](super::Scene::occlusion_distance).
    #[must_use]
    pub fn occlusion_distance(self, metres: f64) -> Self {
        SharedScene { distances: self.distances.with_occlusion(metres), run: OnceLock::new(), ..self }
    }

    /// Sets the distance of queries of labelled shapes; see [`Scene::context_distance`](super::Scene::context_distance).
    #[must_use]
    pub fn context_distance(self, metres: f64) -> Self {
        SharedScene { distances: self.distances.with_context(metres), run: OnceLock::new(), ..self }
    }

    /// The lots.
    pub fn lots(&self) -> &[Arc<SceneLot>] {
        &self.lots
    }

    /// The indices of the other lots that the rules of one can ask about, in ascending order. Empty for an index out of range.
    pub fn neighbours(&self, index: usize) -> Vec<usize> {
        let mut list = self.occlusion_neighbours(index);
        list.extend(self.context_neighbours(index));
        list.small_sort_unstable();
        list.dedup();
        list
    }

    /// The [`neighbours`](SharedScene::neighbours) that occlusion queries ask about.
    pub fn occlusion_neighbours(&self, index: usize) -> Vec<usize> {
        if self.asks(index) { self.run().occlusion_neighbours(index) } else { Vec::new() }
    }

    /// The [`neighbours`](SharedScene::neighbours) that queries of labelled shapes ask about: those whose rules make labels.
    pub fn context_neighbours(&self, index: usize) -> Vec<usize> {
        if self.asks(index) { self.run().context_neighbours(index) } else { Vec::new() }
    }

    /// Returns true if the rules of a lot can ask about neighbours.
    fn asks(&self, index: usize) -> bool {
        self.lots.get(index).is_some_and(|lot| lot.asks_about_neighbours())
    }

    /// The indices of the lots whose models may change if the lots of `changed` do: themselves, and those whose rules can ask about one of
    /// them. For a lot that changes, `changed` has its old and its new state, for one that comes or goes its only state.
    pub fn affected_by(&self, changed: &[&SceneLot]) -> Vec<usize> {
        let own: BTreeSet<*const SceneLot> = changed.iter().map(|lot| ptr::from_ref(*lot)).collect();
        let asks = self.lots.iter().any(|lot| lot.asks_about_neighbours());
        let near = if asks { changed } else { &[] };
        let plan = |lots: &mut dyn Iterator<Item = &&SceneLot>| Plan::of(lots.map(|lot| lot.facts().plan).collect());
        let occluding = plan(&mut near.iter());
        let labelled = plan(&mut near.iter().filter(|lot| lot.has_any(Queries::LABELS)));
        let is_affected = |lot: &SceneLot| {
            let Distances { occlusion, context } = self.distances;
            own.contains(&ptr::from_ref(lot))
                || lot.has_any(Queries::INTER_OCCLUSION) && occluding.has_within(&lot.facts().plan, occlusion)
                || lot.has_any(Queries::INTER_CONTEXT) && labelled.has_within(&lot.facts().plan, context)
        };
        let affected = self.lots.iter().enumerate().filter(|(_, lot)| is_affected(lot));
        affected.map(|(index, _)| index).collect()
    }

    /// Runs the lot with an index among its neighbours, and collects a model. The watch takes the place of the watch in the settings of the lot.
    ///
    /// # Errors
    /// [`Error::Shape`] for an index out of range, and the errors of a run.
    pub fn generate_lot(&self, index: usize, watch: Option<&Watch>) -> Result<Model, Error> {
        let Some(lot) = self.lots.get(index) else {
            return Err(Error::Shape(format!("the scene has no initial shape {index}")));
        };
        let watch = watch.or(lot.settings.watch.as_ref());
        let settings = lot.watched(watch);
        let (mut session, mut model) = (lot.grammar.session(&settings)?, Model::new());
        let outcome = if lot.asks_about_neighbours() {
            let mut runs = OwnSessions { lots: &self.lots, watch, session };
            self.run().outcome(&mut runs, index, &mut model)
        } else {
            session.outcome(&lot.shape, None, &mut model)
        };
        let report = outcome.result(lot.settings.echo)?;
        Ok(model.with_report(report).with_assets(settings.assets))
    }

    fn run(&self) -> &SceneRun {
        self.run.get_or_init(|| {
            let queries = self.lots.iter().map(|lot| lot.facts().queries).collect();
            SceneRun::new(self.distances, queries, || self.lots.iter().map(|lot| lot.facts().plan).collect())
        })
    }
}

/// The derivations of lots on one thread, for the run of one of them.
struct OwnSessions<'a> {
    lots: &'a [Arc<SceneLot>],
    watch: Option<&'a Watch>,
    /// The session of this run.
    session: Worker<'a>,
}

impl Derivations for OwnSessions<'_> {
    fn outcome(&mut self, index: usize, neighbours: Option<&Arc<Neighbours>>, sink: &mut dyn Sink) -> RunOutcome {
        self.session.outcome(&self.lots[index].shape, neighbours, sink)
    }

    fn ghost(&mut self, index: usize, collect: Collect) -> Result<Option<Ghost>, NoResult> {
        let lot = &self.lots[index];
        let derive = || {
            let settings = Settings { tree: false, ..lot.watched(self.watch) };
            let mut session = lot.grammar.session(&settings).map_err(NoResult::Failed)?;
            session.ghost(&lot.shape, collect)
        };
        match catch_unwind(AssertUnwindSafe(derive)) {
            Ok(Ok(ghost)) => Ok(Some(ghost)),
            Ok(Err(NoResult::Failed(_))) => Ok(Some(Ghost::default())),
            Ok(Err(NoResult::Stopped)) => Err(NoResult::Stopped),
            // The watch of this run may be the reason, so other runs try again.
            Err(_) => Ok(None),
        }
    }
}
