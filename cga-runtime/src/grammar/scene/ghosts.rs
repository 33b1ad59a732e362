//! The ghosts of the initial shapes of a scene: each is derived once, when the first query needs it.

use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

use super::plan::Plan;
use crate::geometry::mesh::Bounds;
use crate::geometry::small_sort::{SmallSort, sort_owned_by};
use crate::grammar::parallel::order::in_order;
use crate::grammar::parallel::{Open, Worker};
use crate::output::batches::RunError;
use crate::run::derive::{NoResult, RunOutcome};
use crate::run::ghost::{Collect, Ghost, LabelIndex};
use crate::run::queries::Queries;
use crate::run::settings::Settings;
use crate::run::sink::Sink;
use crate::run::surroundings::{LabelledNeighbours, Neighbours};
use crate::shape::Shape;

/// The distances up to which initial shapes are neighbours, in metres.
#[derive(Clone, Copy, Debug)]
pub(super) struct Distances {
    pub(super) occlusion: f64,
    pub(super) context: f64,
}

impl Default for Distances {
    fn default() -> Self {
        Distances { occlusion: 1.0, context: f64::INFINITY }
    }
}

impl Distances {
    /// NaN and negative numbers count as 0.
    pub(super) fn with_occlusion(self, metres: f64) -> Self {
        Distances { occlusion: metres.max(0.0), ..self }
    }

    /// NaN and negative numbers count as 0.
    pub(super) fn with_context(self, metres: f64) -> Self {
        Distances { context: metres.max(0.0), ..self }
    }
}

/// The number of initial shapes with labels up to which each is derived once for all queries. In larger scenes whose rules ask for labels
/// of all and for closed shapes nearby, neighbours are derived twice, so that memory does not grow with the closed shapes of a city.
const MOST_KEPT: usize = 1 << 12;

/// The derivations of the initial shapes of a scene, on one thread.
pub(super) trait Derivations {
    /// Runs the initial shape with an index among its neighbours.
    fn outcome(&mut self, index: usize, neighbours: Option<&Arc<Neighbours>>, sink: &mut dyn Sink) -> RunOutcome;

    /// The shapes that the initial shape with an index leaves for queries. `None` if it leaves none now and another attempt may leave some.
    ///
    /// # Errors
    /// The run that asks for them ends.
    fn ghost(&mut self, index: usize, collect: Collect) -> Result<Option<Ghost>, NoResult>;
}

/// The derivations of lots in one session.
pub(super) struct InSession<'a, 's> {
    pub(super) session: &'a mut Worker<'s>,
    pub(super) lots: &'a [Shape],
}

impl Derivations for InSession<'_, '_> {
    fn outcome(&mut self, index: usize, neighbours: Option<&Arc<Neighbours>>, sink: &mut dyn Sink) -> RunOutcome {
        self.session.outcome(&self.lots[index], neighbours, sink)
    }

    fn ghost(&mut self, index: usize, collect: Collect) -> Result<Option<Ghost>, NoResult> {
        self.session.ghost(&self.lots[index], collect).map(Some)
    }
}

/// An initial shape whose derivation has no result, with the reason.
type NoNeighbour = (usize, NoResult);

/// What the runs of a scene share.
#[derive(Debug)]
pub(super) struct SceneRun {
    distances: Distances,
    /// The queries that each initial shape can reach.
    queries: Vec<Queries>,
    /// What ghosts contain.
    collect: Collect,
    /// The boxes around the initial shapes, without their height. Empty in a scene without queries of neighbours.
    plan: Plan,
    ghosts: Vec<Mutex<Option<Arc<Ghost>>>>,
    /// The number of initial shapes that can still ask about each one. `MAX` where this is not counted.
    users: Vec<AtomicUsize>,
    /// The labelled shapes of all initial shapes, where the distance is infinite.
    labels: OnceLock<Arc<LabelIndex>>,
}

impl SceneRun {
    /// The run of initial shapes with these queries. Their boxes are found only if rules ask about neighbours.
    pub(super) fn new(distances: Distances, queries: Vec<Queries>, plan: impl FnOnce() -> Vec<Bounds>) -> Self {
        let all = queries.iter().fold(Queries::default(), |all, own| all | *own);
        let collect =
            Collect { labels: all.has_any(Queries::INTER_CONTEXT), occluders: all.has_any(Queries::INTER_OCCLUSION) };
        let plan = Plan::of(if collect.is_nothing() { Vec::new() } else { plan() });
        let (ghosts, users) = plan.boxes().iter().map(|_| (Mutex::default(), AtomicUsize::new(usize::MAX))).unzip();
        SceneRun { distances, queries, collect, plan, ghosts, users, labels: OnceLock::new() }
    }

    /// Runs an initial shape among its neighbours.
    pub(super) fn outcome(&self, runs: &mut dyn Derivations, index: usize, sink: &mut dyn Sink) -> RunOutcome {
        if !self.queries[index].has_any(Queries::INTER_CONTEXT | Queries::INTER_OCCLUSION) {
            return runs.outcome(index, None, sink);
        }
        let neighbours = match self.neighbours(runs, index) {
            Ok(neighbours) => Arc::new(neighbours),
            Err((at, reason)) => return RunOutcome { failed_neighbour: Some(at), ..reason.into() },
        };
        let outcome = runs.outcome(index, Some(&neighbours), sink);
        self.release(index);
        outcome
    }

    /// Returns true if an initial shape asks about the labelled shapes of all others.
    pub(super) fn asks_about_all(&self, index: usize) -> bool {
        self.queries[index].has_any(Queries::INTER_CONTEXT) && self.distances.context == f64::INFINITY
    }

    /// Derives all initial shapes that make labels, and makes an index of their labelled shapes.
    ///
    /// # Errors
    /// The first error in the order of the initial shapes. If the watch is stopped, the index is incomplete, and no run begins after this.
    pub(super) fn index_labels(&self, lots: &[Shape], open: Open<'_, '_>, settings: &Settings) -> Result<(), RunError> {
        let labelled = self.labelled();
        let quiet = Settings { echo: false, ..settings.clone() };
        let (first, again) = (open(&quiet)?, || open(&quiet).ok());
        let job = |session: &mut Worker<'_>, number: usize, _: &dyn Fn() -> bool| {
            let at = labelled[number];
            let found = self.ghost(&mut InSession { session, lots }, at);
            let ends = found.is_err();
            (found.map(|ghost| (at, ghost.unwrap_or_default())), ends)
        };
        let (mut index, mut failed) = (LabelIndex::default(), None);
        in_order(labelled.len(), first, again, job, |found: Result<(usize, Arc<Ghost>), NoNeighbour>| match found {
            Ok((at, ghost)) => {
                index.add_all(at, ghost.labels());
                // If there are many, they do not stay: an occlusion query derives the ones that it asks about again.
                let is_asked = self.collect.occluders && self.users[at].load(Ordering::Relaxed) != 0;
                if !is_asked || MOST_KEPT < labelled.len() {
                    self.forget(at);
                }
            }
            Err((at, NoResult::Failed(error))) => failed = Some(RunError { shape: Some(at), error }),
            Err((_, NoResult::Stopped)) => {}
        });
        let _ = self.labels.set(Arc::new(index));
        failed.map_or(Ok(()), Err)
    }

    /// Counts the initial shapes that can ask about each one, so that ghosts can be dropped.
    pub(super) fn count_users(&self) {
        let is_bounded = self.distances.occlusion.is_finite();
        if self.collect.is_nothing() || !is_bounded {
            return;
        }
        self.users.iter().for_each(|users| users.store(0, Ordering::Relaxed));
        for index in 0..self.plan.boxes().len() {
            self.asked(index).for_each(|at| {
                self.users[at].fetch_add(1, Ordering::Relaxed);
            });
        }
    }

    /// The initial shapes whose models depend on one.
    pub(super) fn affected_by(&self, index: usize) -> Vec<usize> {
        let Some(own) = self.plan.boxes().get(index) else {
            return (index < self.queries.len()).then_some(index).into_iter().collect();
        };
        let has = |at: usize, kind: Queries| self.queries[at].has_any(kind);
        let near =
            |kind: Queries, distance: f64| self.plan.within(own, distance).into_iter().filter(move |at| has(*at, kind));
        let mut list: Vec<usize> = near(Queries::INTER_OCCLUSION, self.distances.occlusion)
            .chain(near(Queries::INTER_CONTEXT, self.distances.context))
            .chain([index])
            .collect();
        list.small_sort_unstable();
        list.dedup();
        list
    }

    /// The other initial shapes that one can find with its occlusion queries.
    pub(super) fn occlusion_neighbours(&self, index: usize) -> Vec<usize> {
        self.near(index, Queries::INTER_OCCLUSION, self.distances.occlusion)
    }

    /// The other initial shapes that one can find with its queries of labelled shapes.
    pub(super) fn context_neighbours(&self, index: usize) -> Vec<usize> {
        let mut list = self.near(index, Queries::INTER_CONTEXT, self.distances.context);
        list.retain(|at| self.queries[*at].has_any(Queries::LABELS));
        list
    }

    /// The initial shapes that make labels.
    fn labelled(&self) -> Vec<usize> {
        (0..self.queries.len()).filter(|at| self.queries[*at].has_any(Queries::LABELS)).collect()
    }

    /// The other initial shapes that one can ask about with a kind of query.
    fn near(&self, index: usize, kind: Queries, distance: f64) -> Vec<usize> {
        if !self.queries[index].has_any(kind) {
            return Vec::new();
        }
        let near = self.plan.within(&self.plan.boxes()[index], distance);
        near.into_iter().filter(|at| *at != index).collect()
    }

    /// The other initial shapes whose ghosts one asks for, each once.
    fn asked(&self, index: usize) -> impl Iterator<Item = usize> {
        let mut list = self.near(index, Queries::INTER_OCCLUSION, self.distances.occlusion);
        if !self.asks_about_all(index) {
            list.extend(self.near(index, Queries::INTER_CONTEXT, self.distances.context));
            list.small_sort_unstable();
            list.dedup();
        }
        list.into_iter()
    }

    /// The shapes around an initial shape. An error has the index of the neighbour whose derivation has no result.
    fn neighbours(&self, runs: &mut dyn Derivations, index: usize) -> Result<Neighbours, NoNeighbour> {
        let mut ghosts = |list: Vec<usize>| -> Result<Vec<Arc<Ghost>>, NoNeighbour> {
            list.into_iter().filter_map(|at| self.ghost(runs, at).transpose()).collect()
        };
        let occlusion = ghosts(self.near(index, Queries::INTER_OCCLUSION, self.distances.occlusion))?;
        let context = if self.asks_about_all(index) {
            LabelledNeighbours::AllBut(self.all_labels(runs, index)?, index)
        } else {
            LabelledNeighbours::Some(ghosts(self.near(index, Queries::INTER_CONTEXT, self.distances.context))?)
        };
        Ok(Neighbours { occlusion, context })
    }

    /// The labelled shapes of all initial shapes. Without [`index_labels`](SceneRun::index_labels), each thread derives them from its own
    /// initial shape on, so threads at the same time begin at different ones.
    fn all_labels(&self, runs: &mut dyn Derivations, own: usize) -> Result<Arc<LabelIndex>, NoNeighbour> {
        if let Some(labels) = self.labels.get() {
            return Ok(labels.clone());
        }
        let mut labelled = self.labelled();
        let later = labelled.partition_point(|at| *at < own);
        labelled.rotate_left(later);
        let mut ghosts: Vec<(usize, Option<Arc<Ghost>>)> =
            labelled.into_iter().map(|at| Ok((at, self.ghost(runs, at)?))).collect::<Result<_, _>>()?;
        sort_owned_by(&mut ghosts, |a, b| a.0.cmp(&b.0));
        let mut index = LabelIndex::default();
        for (at, ghost) in &ghosts {
            if let Some(ghost) = ghost {
                index.add_all(*at, ghost.labels());
            }
        }
        let index = Arc::new(index);
        let is_complete = ghosts.iter().all(|(_, ghost)| ghost.is_some());
        Ok(if is_complete { self.labels.get_or_init(|| index).clone() } else { index })
    }

    /// The ghost of an initial shape. Threads that need the same one wait for the first of them.
    fn ghost(&self, runs: &mut dyn Derivations, index: usize) -> Result<Option<Arc<Ghost>>, NoNeighbour> {
        let known = &mut *self.ghosts[index].lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(ghost) = known {
            return Ok(Some(ghost.clone()));
        }
        let leaves_any = self.collect.occluders || self.queries[index].has_any(Queries::LABELS);
        let ghost = if leaves_any {
            runs.ghost(index, self.collect).map_err(|reason| (index, reason))?
        } else {
            Some(Ghost::default())
        };
        *known = ghost.map(Arc::new);
        Ok(known.clone())
    }

    /// Drops the ghosts that no later initial shape can ask about, after the run of one.
    fn release(&self, index: usize) {
        for at in self.asked(index) {
            let users = &self.users[at];
            let is_counted = users.load(Ordering::Relaxed) != usize::MAX;
            if is_counted && users.fetch_sub(1, Ordering::AcqRel) == 1 {
                self.forget(at);
            }
        }
    }

    fn forget(&self, index: usize) {
        *self.ghosts[index].lock().unwrap_or_else(PoisonError::into_inner) = None;
    }
}
