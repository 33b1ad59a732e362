//! The state of a run besides its sink: limits, faults, the trail of rules, assets.

mod base;
mod calls;
mod checkpoint;
mod counters;
mod edge_attributes;
mod faults;
mod kept;
mod memory;
pub(crate) mod mesh_counts;
mod recompose;
pub(crate) mod records;
pub(crate) mod scene;
mod trail;
pub(crate) mod tree;
mod uv_set;

use std::ops::ControlFlow;
use std::rc::Rc;
use std::sync::Arc;

use crate::fault::{Error, LimitKind};
use crate::geometry::Frame;
use crate::geometry::mesh::Bounds;
use crate::geometry::work::Supervisor;
use crate::run::report::{Prints, Reports};
use crate::run::settings::{Limits, Settings};
use crate::run::shape_tree::builder::TreeBuilder;
use crate::run::sink::LeafTables;
use crate::shape::Shape;
use crate::shape::street::Streets;
use crate::value::text::Text;

pub(crate) use base::READING;
use calls::FunctionCalls;
use checkpoint::Checkpoint;
use faults::FaultList;
use kept::KeptResults;
use mesh_counts::MeshCounts;
use recompose::Recompositions;
use records::TapedReport;
use scene::SceneState;
pub(crate) use trail::Trail;

/// A share of the initial shape's largest extent below which shapes are not split further, and an upper limit of that
/// threshold in metres. The limit keeps small parts on large sites; it also serves runs that start from a point.
pub(crate) const TOO_SMALL: (f64, f64) = (1e-6, 1e-4);

/// The length of most trails: a longer one grows.
const USUAL_TRAIL: usize = 32;

/// The largest count of shapes in a run; a count of [`ENDED`] marks a run that has ended.
pub(crate) const MOST_SHAPES: u64 = u64::MAX / 8;
pub(crate) const ENDED: u64 = u64::MAX / 4;

/// The state of a run that does not depend on the sink.
#[derive(Debug)]
pub struct Env {
    pub(crate) settings: Settings,
    /// Lets the watch end long operations of this thread, as long as the run lasts.
    #[expect(dead_code, reason = "its life is its use")]
    supervisor: Option<Supervisor>,
    /// The extent below which shapes are not split further, so that recursive splits end (*Subdivision split*: "the
    /// recursion stops when the geometry gets too small"). It is relative to the initial shape.
    pub(crate) too_small: f64,
    pub(crate) initial: Initial,
    /// True if operations tag the edges that they make (*Geometry tagging*, auto-tags on edges).
    pub(crate) tags_edges: bool,
    names: Arc<[Text]>,
    /// The names and looks of leaves, by number.
    pub(crate) leaf_tables: LeafTables,
    /// The number of the run in its session.
    pub run: u64,
    /// The rules entered and not yet left, since the last waiting call was resumed.
    pub(crate) trail: Vec<u32>,
    /// The rules that led to the waiting call that was resumed last.
    pub(crate) before: Option<Rc<Trail>>,
    /// The counts of shapes and leaves without the counts of `filled`.
    pub(crate) shapes: u64,
    pub(crate) leaves: u64,
    /// The number of leaf symbols that fill their scopes: a shape and a leaf each.
    pub(crate) filled: u64,
    /// The counts at which counting leaves the fast path: a limit, or the next report to a watch.
    pub(crate) checkpoint: Checkpoint,
    /// The smallest extent of a split so far.
    pub(crate) least_split: f64,
    /// The meshes that operations made.
    meshes: MeshCounts,
    /// True if looks that operations make count for the limit of bytes.
    pub(crate) counts_looks: bool,
    /// A box around everything that trim planes could cut, while a template is recorded.
    pub(crate) reach: Option<Bounds>,
    /// The functions that are being called.
    pub(crate) calls: FunctionCalls,
    faults: FaultList,
    pub(crate) error: Option<Error>,
    pub(crate) reports: Reports,
    /// The values that were reported while a template was recorded.
    pub(crate) taped_reports: Vec<TapedReport>,
    pub(crate) prints: Prints,
    /// The tree of shapes, while it is recorded. Operands are not recorded.
    pub(crate) tree: Option<Box<TreeBuilder>>,
    /// Other shapes, for queries.
    pub(crate) scene: SceneState,
    /// The operands whose shapes remember their connectivity.
    pub(crate) recompositions: Recompositions,
    /// What rules ask for again and again.
    pub(crate) kept: KeptResults,
}

/// The properties of the initial shape that a run uses.
#[derive(Clone, Debug, Default)]
pub(crate) struct Initial {
    /// The frame of object coordinates: the initial shape's pivot (*initialShape attribute*).
    pub(crate) object: Frame,
    pub(crate) name: Text,
    pub(crate) start_rule: Text,
    /// The streets at its edges, if any.
    pub(crate) streets: Option<Arc<Streets>>,
    /// True if boxes and rectangles are held as meshes.
    pub(crate) as_meshes: bool,
    /// The shape itself.
    pub(crate) shape: Option<Shape>,
}

impl Env {
    /// The state of a run from that shape, with that start rule; `names` are the names of all rules.
    pub(crate) fn new(
        settings: &Settings,
        names: Arc<[Text]>,
        leaf_tables: LeafTables,
        (shape, start_rule): (&Shape, Text),
    ) -> Self {
        let extent = shape.scope.size.abs().max_element();
        let name = shape.state.get().map_or_else(Text::default, |state| state.name.clone());
        Env {
            initial: Initial {
                object: shape.pivot,
                name,
                start_rule,
                streets: shape.find_streets(),
                as_meshes: shape.state.get().is_some_and(|state| state.as_meshes),
                shape: Some(shape.clone()),
            },
            // The largest number marks a run that has ended; see `limit`.
            settings: Settings {
                limits: Limits { shapes: settings.limits.shapes.min(MOST_SHAPES), ..settings.limits },
                ..settings.clone()
            },
            // Also without a watch: the watch of a run around this one must not end it.
            supervisor: Some(match settings.watch.clone() {
                Some(watch) => Supervisor::new(move |units| watch.allows(units)),
                None => Supervisor::new(|_| true),
            }),
            too_small: if extent == 0.0 { TOO_SMALL.1 } else { (extent * TOO_SMALL.0).min(TOO_SMALL.1) },
            tags_edges: false,
            names,
            leaf_tables,
            run: 0,
            trail: Vec::with_capacity(USUAL_TRAIL),
            before: None,
            shapes: 0,
            leaves: 0,
            filled: 0,
            checkpoint: Checkpoint::first(settings),
            least_split: f64::INFINITY,
            meshes: MeshCounts::default(),
            counts_looks: true,
            reach: None,
            calls: FunctionCalls::default(),
            faults: FaultList::default(),
            error: None,
            reports: Reports::default(),
            taped_reports: Vec::new(),
            prints: Prints::default(),
            tree: None,
            scene: SceneState::default(),
            recompositions: Recompositions::default(),
            kept: KeptResults::default(),
        }
    }

    /// The state of a run, with names that are literals.
    #[cfg(test)]
    pub(crate) fn with_names(settings: &Settings, names: &[&'static str], shape: &Shape, start: &'static str) -> Self {
        let names = names.iter().copied().map(Text::fixed).collect();
        Env::new(settings, names, LeafTables::default(), (shape, Text::fixed(start)))
    }

    /// The state of a run from a box of 1 m.
    #[cfg(test)]
    pub(crate) fn for_tests() -> Self {
        Env::with_names(&Settings::default(), &["Lot"], &Shape::cuboid(1.0, 1.0, 1.0), "Lot")
    }

    /// Returns true if `more` shapes do not pass the checkpoint.
    #[inline]
    pub(crate) fn has_room(&self, more: u64) -> bool {
        (self.shapes + self.filled).saturating_add(more) <= self.checkpoint.shapes
    }

    /// The number of leaves so far.
    pub(crate) fn leaf_count(&self) -> u64 {
        self.leaves + self.filled
    }

    /// The number of shapes so far.
    pub(crate) fn shape_count(&self) -> u64 {
        self.shapes + self.filled
    }

    /// Ends the run with the error of a limit.
    #[cold]
    pub(crate) fn limit<T>(&mut self, what: LimitKind, limit: u64) -> ControlFlow<(), T> {
        // A run that the watch has stopped has no error: an operation that was ended may seem to need too much.
        if self.ask().is_continue() {
            let trail = self.trail();
            self.error.get_or_insert(Error::Limit { what, limit, trail });
        }
        self.end();
        ControlFlow::Break(())
    }

    /// Ends the run. The next count breaks off, as operations and functions cannot do so by themselves. Work of the thread goes on: a
    /// template whose recording reaches a limit is derived again.
    fn end(&mut self) {
        self.shapes = ENDED;
    }

    /// Returns true if the run has ended by an error or by the watch.
    #[inline]
    pub fn ended(&self) -> bool {
        ENDED <= self.shapes
    }

    fn rule_name(&self, rule: u32) -> Text {
        self.names.get(rule as usize).cloned().unwrap_or(Text::fixed("?"))
    }
}
