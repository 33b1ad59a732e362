//! The shapes that the queries of a run ask about.

use std::sync::Arc;

use super::ghost::relation::Relation;
use super::ghost::{ContextComparison, Ghost, LabelledShape};
use crate::geometry::mesh::Mesh;
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

/// The shapes around those of a run. Queries of shapes that are not known have their defaults.
#[derive(Clone, Debug, Default)]
pub(crate) struct Surroundings {
    /// The shapes of a first derivation of the same initial shape.
    pub(crate) own: Option<Arc<Ghost>>,
    /// The shapes of other initial shapes.
    pub(crate) neighbours: Option<Arc<Neighbours>>,
}

/// The ghosts of other initial shapes, in the order of the scene.
#[derive(Debug, Default)]
pub(crate) struct Neighbours {
    /// The ones near enough for occlusion queries.
    pub(crate) occlusion: Vec<Arc<Ghost>>,
    /// The ones near enough for context queries.
    pub(crate) context: Vec<Arc<Ghost>>,
}

impl Surroundings {
    /// The relation of a mesh in the world to the closed shapes of a target. `key` is the place of the query in the tree of its shapes.
    pub(crate) fn relation(&self, target: QueryTarget, query: &Mesh, label: Option<&str>, key: &[u32]) -> Relation {
        let (own, others) = self.ghosts(target, |neighbours| &neighbours.occlusion);
        let own = own.map(|ghost| ghost.occluders().relation(query, label, Some(key)));
        let others = others.iter().map(|ghost| ghost.occluders().relation(query, label, None));
        own.into_iter().chain(others).fold(Relation::default(), Relation::or)
    }

    /// The distance from a scope to the nearest scope with a label, in metres; infinite without one.
    pub(crate) fn least_distance(&self, target: QueryTarget, label: &str, scope: &Scope) -> f64 {
        self.labelled(target, label).map(|shape| shape.distance_to(scope)).fold(f64::INFINITY, f64::min)
    }

    /// The number of shapes with a label.
    pub(crate) fn count(&self, target: QueryTarget, label: &str) -> usize {
        self.labelled(target, label).count()
    }

    /// The number of shapes with a label that are better than a shape.
    pub(crate) fn rank(&self, target: QueryTarget, label: &str, own: &LabelledShape, by: ContextComparison) -> usize {
        self.labelled(target, label).filter(|shape| shape.is_better(own, by)).count()
    }

    /// The shapes with a label.
    fn labelled<'a>(&'a self, target: QueryTarget, label: &'a str) -> impl Iterator<Item = &'a LabelledShape> {
        let (own, others) = self.ghosts(target, |neighbours| &neighbours.context);
        own.into_iter().chain(others).flat_map(move |ghost| ghost.labelled(label))
    }

    /// The ghosts of a target.
    fn ghosts<'a>(
        &'a self,
        target: QueryTarget,
        others: impl Fn(&'a Neighbours) -> &'a [Arc<Ghost>],
    ) -> (Option<&'a Arc<Ghost>>, &'a [Arc<Ghost>]) {
        let own = self.own.as_ref().filter(|_| target != QueryTarget::Inter);
        let neighbours = self.neighbours.as_deref().filter(|_| target != QueryTarget::Intra);
        (own, neighbours.map_or(&[], others))
    }
}
