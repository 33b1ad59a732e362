//! Models of many shapes, with the methods of one model of all shapes.

use crate::geometry::mesh::Bounds;
use crate::output::batches::Batches;
use crate::output::model::{LeafView, Model};
use crate::output::stats::Stats;
use crate::run::sink::{Flow, Sink};

impl Batches<Model> {
    /// The leaves of all models, in the order of the shapes.
    pub fn leaves(&self) -> impl DoubleEndedIterator<Item = LeafView<'_>> + Clone + '_ {
        self.sinks().flat_map(Model::leaves)
    }

    /// The number of leaves of one rule.
    pub fn count(&self, rule: &str) -> usize {
        self.sinks().map(|model| model.count(rule)).sum()
    }

    /// The axis-aligned bounding box of all geometry, in the world.
    pub fn bounds(&self) -> Bounds {
        self.sinks().map(Model::bounds).fold(Bounds::EMPTY, Bounds::union)
    }

    /// All counts and measures.
    pub fn stats(&self) -> Stats {
        let mut stats = Stats::new();
        // `Stats` never ends a run.
        let _ = self.replay(&mut stats);
        stats
    }

    /// All leaves as one model, with the report of all runs.
    pub fn to_model(&self) -> Model {
        let mut model = Model::new();
        self.sinks().for_each(|other| model.append(other));
        // For several models, `append` drops what this keeps.
        model.with_report(self.report().clone())
    }

    /// Writes a picture of all models, as [`Model::write_png`] does.
    ///
    /// # Errors
    /// Errors of the file system.
    #[cfg(feature = "png")]
    pub fn write_png(&self, path: impl AsRef<std::path::Path>) -> Result<(), crate::output::error::WriteError> {
        self.to_model().write_png(path)
    }

    /// Passes every leaf to a sink, in order, until it ends the run. The sink is not [finished](Sink::finish).
    pub fn replay<S: Sink + ?Sized>(&self, sink: &mut S) -> Flow {
        self.sinks().try_for_each(|model| model.replay(sink))
    }
}
