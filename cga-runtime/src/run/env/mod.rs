//! The state of a run besides its sink: limits, faults, the trail of rules, assets.

mod base;
mod checkpoint;
mod counters;
mod edge_attributes;
mod memory;
mod recompose;
mod trail;
mod tree;
mod uv_set;

use std::cell::Cell;
use std::collections::BTreeMap;
use std::fmt::Display;
use std::ops::ControlFlow;
use std::rc::Rc;
use std::sync::Arc;

use crate::asset::{File, Query};
use crate::fault::{Error, Fault, FaultKind, LimitKind};
use crate::geometry::Frame;
use crate::geometry::mesh::Mesh;
use crate::geometry::primitive::PrimitiveKind;
use crate::geometry::work::{self, Supervisor};
use crate::run::report::{FAULTS_KEPT, Prints, Reports};
use crate::run::settings::{Limits, Settings};
use crate::run::shape_tree::builder::TreeBuilder;
use crate::run::sink::{Flow, LeafTables};
use crate::shape::Shape;
use crate::shape::edge_attributes::SampledAttributes;
use crate::shape::street::Streets;
use crate::value::Value;
use crate::value::array::Array;
use crate::value::text::Text;

use checkpoint::Checkpoint;
use recompose::Recompositions;
pub(crate) use trail::Trail;

/// The largest nesting of functions that reserve stack, as CGA documents it (*CGA changelog 2014.1*).
const DEEPEST_CALLS: u32 = 1024;

/// The stack that functions may use, in bytes of a build without optimisation, by the estimate of the compiler.
/// A function that needs more can run only while no other does. Threads have two megabytes, of which rules have their
/// share: see `STACK` in `run/context.rs`.
const FUNCTIONS: u32 = 640 * 1024;

/// The number of file searches whose results are kept: rules repeat them for every shape.
const SEARCHES_KEPT: usize = 32;

/// The number of tables that are kept: functions read the same files again and again.
const TABLES_KEPT: usize = 16;

/// The number of primitives that are kept: rules insert the same few again and again.
const PRIMITIVES_KEPT: usize = 32;

/// A share of the initial shape's largest extent below which shapes are not split further, and an upper limit of that
/// threshold in metres. The limit keeps small parts on large sites; it also serves runs that start from a point.
pub(crate) const TOO_SMALL: (f64, f64) = (1e-6, 1e-4);

/// The largest count of shapes in a run; a count of [`ENDED`] marks a run that has ended.
pub(crate) const MOST_SHAPES: u64 = u64::MAX / 8;
pub(crate) const ENDED: u64 = u64::MAX / 4;

/// The state of a run that does not depend on the sink.
#[derive(Debug, Default)]
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
    names: &'static [&'static str],
    /// The names and looks of leaves, by number.
    pub(crate) leaf_tables: LeafTables,
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
    /// The number of bases made so far.
    pub(crate) bases: Cell<u64>,
    /// The smallest extent of a split so far.
    pub(crate) least_split: f64,
    vertices: u64,
    /// The bytes of meshes that operations made, and of leaves that are meshes, besides the vertices that are counted.
    mesh_bytes: u64,
    /// The nesting of functions that have reserved stack.
    calls: u32,
    /// The part of [`FUNCTIONS`] that they use.
    call_stack: u32,
    pub(crate) calls_made: u64,
    /// The lazy attributes and constants that are being computed, from the outermost on.
    pub(crate) open: Vec<&'static str>,
    faults: Vec<Fault>,
    faults_left_out: u64,
    /// The faults of files by their messages, as indices of `faults`.
    asset_faults: BTreeMap<String, usize>,
    pub(crate) error: Option<Error>,
    /// The primitives made so far.
    primitives: Vec<(PrimitiveKind, Arc<Mesh>)>,
    pub(crate) reports: Reports,
    pub(crate) prints: Prints,
    /// The tree of shapes, while it is recorded. Operands are not recorded.
    pub(crate) tree: Option<Box<TreeBuilder>>,
    /// The operands whose shapes remember their connectivity.
    pub(crate) recompositions: Recompositions,
    /// The results of file searches; see [`Env::files`].
    searches: BTreeMap<File, Rc<[Text]>>,
    /// The tables read so far, by file.
    pub(crate) tables: BTreeMap<File, Array<Text>>,
    /// The attributes of the edges of the initial shape, once a rule has asked for them.
    edge_attributes: Option<Option<Arc<SampledAttributes>>>,
    /// The texts reported so far of those that are reported once a run: names that are not implemented, messages.
    said_once: Vec<&'static str>,
    /// The number of attempts to report such a text, and of repetitions of counted faults.
    said_again: u64,
}

/// The properties of the initial shape that a run uses.
#[derive(Clone, Debug, Default)]
pub(crate) struct Initial {
    /// The frame of object coordinates: the initial shape's pivot (*initialShape attribute*).
    pub(crate) object: Frame,
    pub(crate) name: Text,
    pub(crate) start_rule: &'static str,
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
        names: &'static [&'static str],
        shape: &Shape,
        start_rule: &'static str,
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
            names,
            checkpoint: Checkpoint::first(settings),
            least_split: f64::INFINITY,
            ..Env::default()
        }
    }

    /// The state of a run from a box of 1 m.
    #[cfg(test)]
    pub(crate) fn for_tests() -> Self {
        Env::new(&Settings::default(), &["Lot"], &Shape::cuboid(1.0, 1.0, 1.0), "Lot")
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
        // The next count ends the run: operations and functions cannot break off by themselves.
        self.shapes = ENDED;
        ControlFlow::Break(())
    }

    /// Returns true if the run has ended by an error or by the watch.
    #[inline]
    pub fn ended(&self) -> bool {
        ENDED <= self.shapes
    }

    /// Enters a function that needs `stack` bytes of `FUNCTIONS`. Returns false at the depth of calls that CGA allows
    /// (*CGA changelog 2014.1*: function call depth), and if the stack has no room. If it returns true,
    /// [`Env::called`] follows.
    #[inline]
    pub fn call(&mut self, stack: u32) -> bool {
        self.calls_made += 1;
        let stack = self.call_stack + stack.min(FUNCTIONS);
        if FUNCTIONS < stack || self.calls == DEEPEST_CALLS {
            let _: Flow = self.limit(LimitKind::Nesting, u64::from(self.calls));
        } else if self.checkpoint.calls < self.calls_made || !work::spend(1) {
            let _: Flow = self.at_calls();
        }
        let may = !self.ended();
        if may {
            (self.calls, self.call_stack) = (self.calls + 1, stack);
        }
        may
    }

    /// Ends the run because a lazy attribute or constant needs its own value.
    #[cold]
    pub(crate) fn close_cycle(&mut self, name: &'static str) {
        let first = self.open.iter().rposition(|open| *open == name).unwrap_or(0);
        let names = self.open[first..].to_vec();
        self.error.get_or_insert(Error::Cycle { names });
        self.shapes = ENDED;
    }

    /// Leaves a function that has reserved `stack` bytes.
    #[inline]
    pub fn called(&mut self, stack: u32) {
        self.calls -= 1;
        self.call_stack -= stack.min(FUNCTIONS);
    }

    /// The files found by a search, sorted.
    pub(crate) fn files(&mut self, query: &File) -> Rc<[Text]> {
        if let Some(known) = self.searches.get(query) {
            return known.clone();
        }
        let asked = Query::new(&query.name);
        let (found, cut_short) = self.settings.assets.search(&asked, query.folder);
        let found: Rc<[Text]> = found.into();
        if let Some(why) = asked.trouble() {
            self.fault(FaultKind::Value, format!("a search for files is incomplete: {why}"));
        }
        if cut_short {
            self.fault_once(FaultKind::Limit, "the asset folder is too large to be searched; some files are left out");
        }
        if self.searches.len() < SEARCHES_KEPT {
            self.searches.insert(query.clone(), found.clone());
        }
        found
    }

    /// Keeps a table that was read, if there is room.
    pub(crate) fn keep_table(&mut self, file: File, table: &Array<Text>) {
        if self.tables.len() < TABLES_KEPT {
            self.tables.insert(file, table.clone());
        }
    }

    /// Adds a value to the collection with a key.
    pub(crate) fn report(&mut self, key: Text, value: Value) {
        let limit = self.settings.limits.reports;
        if !self.reports.add(key, value, limit) && self.reports.left_out() == 1 {
            self.fault(FaultKind::Limit, format!("the limit of {limit} reports is reached; further ones are left out"));
        }
    }

    /// Keeps a printed line.
    pub(crate) fn print(&mut self, value: Value) {
        let before = self.before.as_deref().map_or(&[][..], |before| &before.rules);
        let rule = self.trail.last().or(before.last()).map_or("", |&rule| self.rule_name(rule));
        let (depth, limit) = (self.depth(), self.settings.limits.prints);
        if !self.prints.add(depth, rule, value, limit) && self.prints.quota.left_out == 1 {
            self.fault(FaultKind::Limit, format!("the limit of {limit} lines is reached; further ones are left out"));
        }
    }

    /// Records a fault unless it was recorded before.
    pub(crate) fn fault_once(&mut self, kind: FaultKind, message: &'static str) {
        if self.is_new(message) {
            self.fault(kind, message);
        }
    }

    /// Records that something is not implemented, once a run.
    pub(crate) fn not_implemented(&mut self, name: &'static str, instead: &str) {
        if self.is_new(name) {
            self.fault(FaultKind::NotImplemented, format!("`{name}` is not implemented yet; {instead}"));
        }
    }

    /// Returns true if a text that is reported once a run was not reported yet.
    fn is_new(&mut self, text: &'static str) -> bool {
        self.said_again += 1;
        let is_new = !self.said_once.contains(&text);
        if is_new {
            self.said_once.push(text);
        }
        is_new
    }

    /// The number of faults so far, repetitions included.
    pub(crate) fn fault_count(&self) -> u64 {
        self.faults.len() as u64 + self.faults_left_out + self.said_again
    }

    fn rule_name(&self, rule: u32) -> &'static str {
        self.names.get(rule as usize).copied().unwrap_or("?")
    }

    /// Records a fault with the trail that led to it.
    #[cold]
    pub fn fault(&mut self, kind: FaultKind, message: impl Into<String>) {
        self.add_fault(kind, message.into());
    }

    /// Records a fault of a file. Repetitions are only counted: rules insert the same file thousands of times.
    #[cold]
    pub(crate) fn asset_fault(&mut self, message: String) {
        if let Some(&at) = self.asset_faults.get(&message) {
            self.faults[at].count = self.faults[at].count.saturating_add(1);
            self.said_again += 1;
            return;
        }
        if let Some(at) = self.add_fault(FaultKind::Asset, message.clone()) {
            self.asset_faults.insert(message, at);
        }
    }

    /// Records a fault of an image, once in a run: looks are kept, so the number of times that rules ask for an image depends on what is
    /// kept.
    #[cold]
    pub(crate) fn image_fault(&mut self, message: String) {
        if self.asset_faults.contains_key(&message) {
            self.said_again += 1;
        } else {
            self.asset_fault(message);
        }
    }

    /// Adds a fault, if there is room for it. Returns its index.
    fn add_fault(&mut self, kind: FaultKind, message: String) -> Option<usize> {
        // The failure of an operation that was ended is no fault of the rules.
        if self.ask().is_break() {
            return None;
        }
        if FAULTS_KEPT <= self.faults.len() {
            self.faults_left_out += 1;
            return None;
        }
        let trail = self.trail();
        self.faults.push(Fault { kind, message, count: 1, trail });
        Some(self.faults.len() - 1)
    }

    /// The number, or 0 with a fault if it is not finite (*CGA changelog 2013.1*: the default policy for such
    /// arguments).
    #[inline]
    pub(crate) fn finite(&mut self, value: f64, what: impl Display) -> f64 {
        if value.is_finite() {
            return value;
        }
        self.fault(FaultKind::Value, format!("{what} is {value}; 0 is used instead"));
        0.0
    }

    /// A primitive in the unit box. The first few are kept for the run. `None` when the limit of vertices is reached.
    pub(crate) fn primitive(&mut self, what: PrimitiveKind) -> Option<Arc<Mesh>> {
        if let Some((_, mesh)) = self.primitives.iter().find(|(made, _)| *made == what) {
            return Some(mesh.clone());
        }
        if self.count_corners(what.corner_count()).is_break() {
            return None;
        }
        let mesh = Arc::new(what.mesh());
        if self.primitives.len() < PRIMITIVES_KEPT {
            self.primitives.push((what, mesh.clone()));
        }
        Some(mesh)
    }

    pub(crate) fn take_faults(&mut self) -> (Vec<Fault>, u64) {
        self.asset_faults.clear();
        (std::mem::take(&mut self.faults), self.faults_left_out)
    }
}
