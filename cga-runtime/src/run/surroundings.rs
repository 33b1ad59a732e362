//! The shapes that the queries of a run ask about.

use std::sync::Arc;

use super::ghost::near::AskedGhosts;
use super::ghost::{ContextComparison, Ghost, LabelIndex, LabelledShape};
use crate::shape::scope::Scope;

/// The initial shapes that a query asks about (*occlusion queries*).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum QueryTarget {
    /// The initial shape of the run.
    Intra,
    /// Other initial shapes of the scene.
    Inter,
    /// Both.
    All,
}

/// The shapes around the shapes of a run. Queries of shapes that are not known have their defaults.
#[derive(Clone, Debug, Default)]
pub(crate) struct Surroundings {
    /// The shapes of a first derivation of the same initial shape.
    pub(crate) own: Option<Arc<Ghost>>,
    /// The shapes of other initial shapes.
    pub(crate) neighbours: Option<Arc<Neighbours>>,
}

/// The shapes of other initial shapes.
#[derive(Debug, Default)]
pub struct Neighbours {
    /// The ghosts of those near enough for occlusion queries, in the order of the scene.
    pub(crate) occlusion: Vec<Arc<Ghost>>,
    /// The labelled shapes of those near enough for context queries.
    pub(crate) context: LabelledNeighbours,
}

/// The labelled shapes of other initial shapes.
#[derive(Debug)]
pub(crate) enum LabelledNeighbours {
    /// The shapes of some initial shapes.
    Some(Vec<Arc<Ghost>>),
    /// The shapes of all initial shapes of a scene without the one with this number.
    AllBut(Arc<LabelIndex>, usize),
}

impl Default for LabelledNeighbours {
    fn default() -> Self {
        LabelledNeighbours::Some(Vec::new())
    }
}

impl LabelledNeighbours {
    fn count(&self, label: &str) -> usize {
        match self {
            LabelledNeighbours::Some(ghosts) => ghosts.iter().map(|ghost| ghost.labels().count(label, None)).sum(),
            LabelledNeighbours::AllBut(index, own) => index.count(label, Some(*own)),
        }
    }

    fn rank(&self, label: &str, shape: &LabelledShape, by: ContextComparison) -> usize {
        match self {
            LabelledNeighbours::Some(ghosts) => {
                ghosts.iter().map(|ghost| ghost.labels().rank(label, None, shape, by)).sum()
            }
            LabelledNeighbours::AllBut(index, own) => index.rank(label, Some(*own), shape, by),
        }
    }

    fn least_distance(&self, label: &str, scope: &Scope, least: f64) -> f64 {
        match self {
            LabelledNeighbours::Some(ghosts) => {
                ghosts.iter().fold(least, |least, ghost| ghost.labels().least_distance(label, None, scope, least))
            }
            LabelledNeighbours::AllBut(index, own) => index.least_distance(label, Some(*own), scope, least),
        }
    }
}

impl Surroundings {
    /// The ghosts with the closed shapes of a target.
    pub(crate) fn occluding(&self, target: QueryTarget) -> AskedGhosts<'_> {
        let others = self.neighbours(target).map_or(&[][..], |neighbours| &neighbours.occlusion);
        AskedGhosts { own: self.own(target), others }
    }

    /// The distance from a scope to the nearest scope with a label, in metres; infinite without one.
    pub(crate) fn least_distance(&self, target: QueryTarget, label: &str, scope: &Scope) -> f64 {
        let far = f64::INFINITY;
        let own = self.own(target).map_or(far, |ghost| ghost.labels().least_distance(label, None, scope, far));
        self.neighbours(target).map_or(own, |neighbours| neighbours.context.least_distance(label, scope, own))
    }

    /// The number of shapes with a label.
    pub(crate) fn count(&self, target: QueryTarget, label: &str) -> usize {
        let own = self.own(target).map_or(0, |ghost| ghost.labels().count(label, None));
        own + self.neighbours(target).map_or(0, |neighbours| neighbours.context.count(label))
    }

    /// The number of shapes with a label that are better than a shape.
    pub(crate) fn rank(&self, target: QueryTarget, label: &str, shape: &LabelledShape, by: ContextComparison) -> usize {
        let own = self.own(target).map_or(0, |ghost| ghost.labels().rank(label, None, shape, by));
        own + self.neighbours(target).map_or(0, |neighbours| neighbours.context.rank(label, shape, by))
    }

    fn own(&self, target: QueryTarget) -> Option<&Ghost> {
        self.own.as_deref().filter(|_| target != QueryTarget::Inter)
    }

    fn neighbours(&self, target: QueryTarget) -> Option<&Neighbours> {
        self.neighbours.as_deref().filter(|_| target != QueryTarget::Intra)
    }
}
