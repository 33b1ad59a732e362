//! Further derivations of a run, without output: the ghosts that queries ask, and the tree of shapes.

use std::sync::Arc;

use glam::DAffine3;

use crate::geometry::mesh::Mesh;
use crate::run::derive::{Derivation, NoResult};
use crate::run::env::Env;
use crate::run::ghost::{Collect, Ghost};
use crate::run::queries::Queries;
use crate::run::report::Report;
use crate::run::settings::Repeats;
use crate::run::shape_tree::ShapeTree;
use crate::run::sink::{Cuboid, Filled, Flow, Leaf, Quad, Sink};
use crate::run::surroundings::{Neighbours, Surroundings};
use crate::shape::look_table::LookTable;

/// A sink for runs without output.
struct NoOutput;

impl Sink for NoOutput {
    fn filled(&mut self, _: &Filled<'_>) -> Flow {
        Flow::Continue(())
    }

    fn quad(&mut self, _: &Leaf<'_>, _: &Quad) -> Flow {
        Flow::Continue(())
    }

    fn cuboid(&mut self, _: &Leaf<'_>, _: &Cuboid) -> Flow {
        Flow::Continue(())
    }

    fn mesh(&mut self, _: &Leaf<'_>, _: &Arc<Mesh>, _: &DAffine3) -> Flow {
        Flow::Continue(())
    }
}

impl Derivation<'_> {
    /// The state of the run before its first rule. Rules that ask for keys run without templates, which have leaves alone.
    pub(super) fn env(&self, around: Surroundings, looks: LookTable) -> Env {
        let needs_keys = self.start.queries.has_any(Queries::TREE_KEY | Queries::INTRA_OCCLUSION);
        let mut env = self.start.env(self.tables, self.shape, self.settings, looks);
        env.tags_edges = self.tables.tags;
        if needs_keys {
            env.record_keys();
            env.settings.repeats = Repeats::Direct;
        }
        env.scene.around = around;
        env
    }

    /// The shapes that queries of the run ask about. The ones of its own initial shape are derived first (*CGA and its context*).
    ///
    /// # Errors
    /// The first derivation has an error or is stopped.
    pub(super) fn surroundings(&self, neighbours: Option<Arc<Neighbours>>) -> Result<Surroundings, NoResult> {
        let around = Surroundings { own: None, neighbours };
        let queries = self.start.queries;
        let occluders = queries.has_any(Queries::INTRA_OCCLUSION);
        let collect = Collect { labels: queries.has_any(Queries::INTRA_CONTEXT), occluders };
        if collect.is_nothing() {
            return Ok(around);
        }
        let own = self.collected(around.clone(), collect)?;
        Ok(Surroundings { own: Some(Arc::new(own)), ..around })
    }

    /// The shapes of the run that queries of its neighbours find. Queries of neighbours have their defaults in it.
    ///
    /// # Errors
    /// The run has an error or is stopped.
    pub(crate) fn ghost(&self, collect: Collect) -> Result<Ghost, NoResult> {
        self.collected(self.surroundings(None)?, collect).map(Ghost::without_keys)
    }

    /// Derives the run and collects its shapes. Its reports, prints and faults are dropped.
    fn collected(&self, around: Surroundings, collect: Collect) -> Result<Ghost, NoResult> {
        let mut env = self.env(around, LookTable::default());
        env.collect(collect);
        let flow = self.derive_silently(&mut env);
        let is_complete = flow.is_continue() && env.spend(0).is_continue();
        match env.error.take() {
            None if is_complete => Ok(env.take_ghost()),
            error => Err(error.map_or(NoResult::Stopped, NoResult::Failed)),
        }
    }

    /// The tree of the shapes of the run, which had that report. `None` if this derivation ends early or differs.
    pub(super) fn shape_tree(&self, report: &Report, around: Surroundings) -> Option<ShapeTree> {
        let mut env = self.env(around, LookTable::default());
        env.settings.repeats = Repeats::Direct;
        env.record_tree();
        let flow = self.derive_silently(&mut env);
        let is_complete = flow.is_continue() && env.spend(0).is_continue();
        let is_same = (env.shape_count(), env.leaf_count()) == (report.shapes, report.leaves);
        (is_complete && is_same).then(|| env.take_tree())
    }

    /// Derives the run without output. Its shapes are not progress.
    fn derive_silently(&self, env: &mut Env) -> Flow {
        env.tell_no_progress();
        self.derive_again(env, &mut NoOutput)
    }
}
