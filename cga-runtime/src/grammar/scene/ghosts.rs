//! The ghosts of the initial shapes of a scene: each is derived once, when the first query needs it.

use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

use crate::geometry::bounds_tree::BoundsTree;
use crate::geometry::mesh::Bounds;
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
use crate::shape::body::Body;

/// The distances up to which initial shapes are neighbours, in metres.
#[derive(Clone, Copy, Debug)]
pub(super) struct Distances {
    pub(super) occlusion: f64,
    pub(super) context: f64,
}

/// The number of initial shapes with labels up to which each is derived once for all queries. In larger scenes whose rules ask for labels
/// of all and for closed shapes nearby, neighbours are derived twice, so that memory does not grow with the closed shapes of a city.
const MOST_KEPT: usize = 1 << 12;

/// What the runs of a scene share.
pub(super) struct SceneRun<'s> {
    lots: &'s [Shape],
    distances: Distances,
    /// The queries that each initial shape can reach.
    queries: Vec<Queries>,
    /// What ghosts contain.
    collect: Collect,
    /// The boxes around the initial shapes, without their height. Empty in a scene without queries of neighbours.
    plan: Vec<Bounds>,
    plan_tree: BoundsTree,
    ghosts: Vec<Mutex<Option<Arc<Ghost>>>>,
    /// The number of initial shapes that can still ask about each one. `MAX` where this is not counted.
    users: Vec<AtomicUsize>,
    /// The labelled shapes of all initial shapes, where the distance is infinite.
    labels: OnceLock<Arc<LabelIndex>>,
}

impl<'s> SceneRun<'s> {
    /// Finds the queries of all initial shapes.
    pub(super) fn new(lots: &'s [Shape], distances: Distances, session: &mut Worker<'_>) -> Self {
        let queries: Vec<Queries> = lots.iter().map(|lot| session.queries(lot)).collect();
        let all = queries.iter().fold(Queries::default(), |all, own| all | *own);
        let collect =
            Collect { labels: all.has_any(Queries::INTER_CONTEXT), occluders: all.has_any(Queries::INTER_OCCLUSION) };
        let plan: Vec<Bounds> = if collect.is_nothing() { Vec::new() } else { lots.iter().map(plan_box).collect() };
        let (ghosts, users) = plan.iter().map(|_| (Mutex::default(), AtomicUsize::new(usize::MAX))).unzip();
        let plan_tree = BoundsTree::of(&plan);
        SceneRun { lots, distances, queries, collect, plan, plan_tree, ghosts, users, labels: OnceLock::new() }
    }

    /// Runs an initial shape among its neighbours.
    pub(super) fn outcome(&self, session: &mut Worker<'_>, index: usize, sink: &mut dyn Sink) -> RunOutcome {
        if !self.queries[index].has_any(Queries::INTER_CONTEXT | Queries::INTER_OCCLUSION) {
            return session.outcome(&self.lots[index], None, sink);
        }
        let neighbours = match self.neighbours(session, index) {
            Ok(neighbours) => Arc::new(neighbours),
            Err((at, reason)) => return RunOutcome { failed_neighbour: Some(at), ..reason.into() },
        };
        let outcome = session.outcome(&self.lots[index], Some(&neighbours), sink);
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
    pub(super) fn index_labels(&self, open: Open<'_, '_>, settings: &Settings) -> Result<(), RunError> {
        let labelled: Vec<usize> =
            (0..self.lots.len()).filter(|at| self.queries[*at].has_any(Queries::LABELS)).collect();
        let quiet = Settings { echo: false, ..settings.clone() };
        let (first, again) = (open(&quiet)?, || open(&quiet).ok());
        let job = |session: &mut Worker<'_>, number: usize, _: &dyn Fn() -> bool| {
            let at = labelled[number];
            let found = self.ghost(session, at);
            let ends = found.is_err();
            (found.map(|ghost| (at, ghost)).map_err(|reason| (at, reason)), ends)
        };
        let (mut index, mut failed) = (LabelIndex::default(), None);
        in_order(
            labelled.len(),
            first,
            again,
            job,
            |found: Result<(usize, Arc<Ghost>), (usize, NoResult)>| match found {
                Ok((at, ghost)) => {
                    index.add_all(at, ghost.labels());
                    // Of many, those that occlusion queries ask about are derived again when their turn comes.
                    let is_asked = self.collect.occluders && self.users[at].load(Ordering::Relaxed) != 0;
                    if !is_asked || MOST_KEPT < labelled.len() {
                        self.forget(at);
                    }
                }
                Err((at, NoResult::Failed(error))) => failed = Some(RunError { shape: Some(at), error }),
                Err((_, NoResult::Stopped)) => {}
            },
        );
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
        for index in 0..self.lots.len() {
            self.asked(index).for_each(|at| {
                self.users[at].fetch_add(1, Ordering::Relaxed);
            });
        }
    }

    /// The initial shapes whose models depend on one.
    pub(super) fn affected_by(&self, index: usize) -> Vec<usize> {
        let Some(own) = self.lots.get(index) else { return Vec::new() };
        let has = |at: usize, kind: Queries| self.queries[at].has_any(kind);
        let near = |kind: Queries, distance: f64| {
            self.within(&plan_box(own), distance).into_iter().filter(move |at| has(*at, kind))
        };
        let mut list: Vec<usize> = near(Queries::INTER_OCCLUSION, self.distances.occlusion)
            .chain(near(Queries::INTER_CONTEXT, self.distances.context))
            .chain([index])
            .collect();
        list.sort_unstable();
        list.dedup();
        list
    }

    /// The other initial shapes that one can ask about with a kind of query.
    fn near(&self, index: usize, kind: Queries, distance: f64) -> Vec<usize> {
        if !self.queries[index].has_any(kind) {
            return Vec::new();
        }
        let near = self.within(&self.plan[index], distance);
        near.into_iter().filter(|at| *at != index).collect()
    }

    /// The initial shapes that are at most so far from a box in plan, in ascending order.
    fn within(&self, query: &Bounds, distance: f64) -> Vec<usize> {
        let is_near = |bounds: &Bounds| bounds.distance(query) <= distance;
        let mut found = Vec::new();
        self.plan_tree.visit(is_near, |at| {
            found.extend(is_near(&self.plan[at as usize]).then_some(at as usize));
            true
        });
        found.sort_unstable();
        found
    }

    /// The other initial shapes whose ghosts one asks for, each once.
    fn asked(&self, index: usize) -> impl Iterator<Item = usize> {
        let mut list = self.near(index, Queries::INTER_OCCLUSION, self.distances.occlusion);
        if !self.asks_about_all(index) {
            list.extend(self.near(index, Queries::INTER_CONTEXT, self.distances.context));
            list.sort_unstable();
            list.dedup();
        }
        list.into_iter()
    }

    /// The shapes around an initial shape. An error has the index of the neighbour whose derivation has no result.
    fn neighbours(&self, session: &mut Worker<'_>, index: usize) -> Result<Neighbours, (usize, NoResult)> {
        let mut ghosts = |list: Vec<usize>| -> Result<Vec<Arc<Ghost>>, (usize, NoResult)> {
            list.into_iter().map(|at| self.ghost(session, at).map_err(|reason| (at, reason))).collect()
        };
        let occlusion = ghosts(self.near(index, Queries::INTER_OCCLUSION, self.distances.occlusion))?;
        let context = match self.labels.get() {
            Some(labels) if self.asks_about_all(index) => LabelledNeighbours::AllBut(labels.clone(), index),
            _ => LabelledNeighbours::Some(ghosts(self.near(index, Queries::INTER_CONTEXT, self.distances.context))?),
        };
        Ok(Neighbours { occlusion, context })
    }

    /// The ghost of an initial shape. Threads that need the same one wait for the first of them.
    fn ghost(&self, session: &mut Worker<'_>, index: usize) -> Result<Arc<Ghost>, NoResult> {
        let known = &mut *self.ghosts[index].lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(ghost) = known {
            return Ok(ghost.clone());
        }
        let leaves_any = self.collect.occluders || self.queries[index].has_any(Queries::LABELS);
        let ghost = if leaves_any { session.ghost(&self.lots[index], self.collect)? } else { Ghost::default() };
        Ok(known.insert(Arc::new(ghost)).clone())
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

/// The box around an initial shape, without its height.
fn plan_box(lot: &Shape) -> Bounds {
    let Bounds { mut low, mut high } = Body::from(lot).bounds();
    (low.y, high.y) = (0.0, 0.0);
    Bounds { low, high }
}
