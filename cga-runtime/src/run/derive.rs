//! A run: rules call each other directly, leaves go to the sink as they appear.
//!
//! Order of leaves: depth first, in writing order. Only where rules go so deep that [`STACK`] is used up, calls wait on
//! a list and run, first in first out, when the direct ones are through. What a call takes of the stack is an estimate
//! of the code generator that follows from the rules alone, so the order is the same in every run and every build.

use std::collections::VecDeque;
use std::io::Write as _;
use std::rc::Rc;

use crate::env::{Env, Trail};
use crate::fault::{Error, Fault, LimitKind};
use crate::grammar::Rules;
use crate::material::ids::MaterialIds;
use crate::place;
use crate::report::{Collection, Print, Reports};
use crate::settings::Settings;
use crate::shape::base::Form;
use crate::shape::{Geometry, Inserted, Shape, ShapeRef};
use crate::sink::{Filled, Flow, Leaf, Sink};
use crate::template::{Tape, Templates};

/// How much of the stack direct calls may use, in the units of generated code: about a kilobyte each in a build without
/// optimisation, much less with it. Threads have two megabytes, of which functions (`FUNCTIONS` in
/// `env.rs`), sinks and Rust operations need their share.
pub const STACK: u32 = 640;

/// What a run says besides what it gave the sink.
#[derive(Clone, Debug, Default)]
#[non_exhaustive]
pub struct Report {
    /// Shapes derived, leaves included.
    pub shapes: u64,
    /// Leaves handed to the sink. If the sink stops the run among the leaves of a part that repeats, all leaves of the part count.
    pub leaves: u64,
    /// What went wrong on the way; the first thousand.
    pub faults: Vec<Fault>,
    /// Faults beyond those kept.
    pub faults_left_out: u64,
    /// True if the sink or a [`Watch`](crate::watch::Watch) ended the run.
    pub stopped: bool,
    pub(crate) reports: Reports,
    pub(crate) prints: Vec<Print>,
    pub(crate) prints_left_out: u64,
    /// Bytes of the printed values.
    pub(crate) prints_bytes: usize,
}

impl Report {
    /// What rules reported, sorted by key (*report operation*).
    pub fn reports(&self) -> &Reports {
        &self.reports
    }

    /// What rules reported under one key; of several types the first, see [`Reports::of_type`].
    pub fn reported(&self, key: &str) -> Option<&Collection> {
        self.reports.get(key)
    }

    /// The lines that rules printed, breadth first: by the depth of their shape in the tree of shapes, lines of equal depth
    /// in order of derivation (*getTreeKey function*).
    pub fn prints(&self) -> &[Print] {
        &self.prints
    }

    /// Printed lines that found no room; see [`Limits::prints`](crate::settings::Limits::prints).
    pub fn prints_left_out(&self) -> u64 {
        self.prints_left_out
    }
}

/// A run under way: what generated code hands from rule to rule.
#[expect(missing_debug_implementations, reason = "sinks need not be printable")]
pub struct Cx<'r, C> {
    /// The part that does not depend on the sink.
    pub env: &'r mut Env,
    pub(crate) sink: &'r mut dyn Sink,
    pub(crate) waiting: VecDeque<Waiting<C>>,
    /// What direct calls take of [`STACK`] at the moment.
    pub(crate) stack: u32,
    /// Nesting of rules that can reach themselves.
    pub(crate) depth: u32,
    /// Parts that repeat.
    pub(crate) templates: &'r mut Templates<C>,
    /// The template that is made, if one is.
    pub(crate) tape: Option<Tape<'r, C>>,
}

/// A rule without parameters, as generated code has it.
pub type RuleFn<G, C> = fn(&G, &mut Cx<'_, C>, &ShapeRef<'_>) -> Flow;

/// A call that waited, or that a template left out.
pub type ResumeFn<G, C> = fn(&G, &mut Cx<'_, C>, &ShapeRef<'_>, C) -> Flow;

/// The run inside an operation that changes a material: expressions get at it as in a rule.
#[derive(Debug)]
pub struct Painting<'r> {
    /// The run.
    pub env: &'r mut Env,
}

#[derive(Debug)]
pub(crate) struct Waiting<C> {
    shape: Shape,
    call: C,
    depth: u32,
    trail: Rc<Trail>,
}

impl<C> Cx<'_, C> {
    /// Enters a rule. Every rule that was entered is left again unless the run ends in it.
    #[inline]
    pub fn enter(&mut self, rule: u32) -> Flow {
        self.env.enter(rule);
        self.env.count_shapes(1)
    }

    /// Leaves a rule.
    #[inline]
    pub fn leave(&mut self) -> Flow {
        self.env.leave();
        Flow::Continue(())
    }

    /// Returns true if a call may use the stack: one that goes down `levels` of recursion, 0 or 1, and takes so much of [`STACK`].
    /// If so, [`Cx::ascend`] follows the call, else [`Cx::defer`].
    #[inline]
    pub fn descend(&mut self, levels: u32, stack: u32) -> bool {
        let may = self.stack + stack <= STACK && self.depth + levels <= self.env.settings.limits.depth;
        if may {
            self.stack += stack;
            self.depth += levels;
        }
        may
    }

    /// Comes back from a direct call.
    #[inline]
    pub fn ascend(&mut self, levels: u32, stack: u32) {
        self.stack -= stack;
        self.depth -= levels;
    }

    /// Puts a call on the list.
    #[cold]
    pub fn defer(&mut self, shape: &ShapeRef<'_>, levels: u32, call: C) -> Flow {
        let depth = self.depth + levels;
        if self.env.settings.limits.depth < depth {
            return self.env.limit(LimitKind::Depth, u64::from(self.env.settings.limits.depth));
        }
        if self.env.settings.limits.waiting <= self.waiting.len() as u64 {
            return self.env.limit(LimitKind::Waiting, self.env.settings.limits.waiting);
        }
        let trail = self.env.keep_trail();
        self.waiting.push_back(Waiting { shape: self.env.whole(shape), call, depth, trail });
        Flow::Continue(())
    }

    /// Hands the shape of a rule to the sink as a leaf. A shape without faces leaves nothing.
    #[inline]
    pub fn leaf(&mut self, shape: &ShapeRef<'_>, rule: u32) -> Flow {
        if self.env.ended() {
            return Flow::Break(());
        }
        // It was counted when its rule was entered.
        self.env.shapes -= 1;
        filled(self.env, self.sink, shape, rule)
    }

    /// A leaf symbol: counts as a shape of its own.
    #[inline]
    pub fn symbol(&mut self, shape: &ShapeRef<'_>, rule: u32) -> Flow {
        if !self.env.has_room(1) {
            self.env.make_room(1)?;
        }
        filled(self.env, self.sink, shape, rule)
    }
}

/// Hands a leaf symbol, for which there is room, to the sink.
#[inline]
pub(crate) fn filled(env: &mut Env, sink: &mut dyn Sink, shape: &ShapeRef<'_>, rule: u32) -> Flow {
    let is_filled = match shape.form {
        Form::Rect(_) => true,
        Form::Box => !shape.has_sides(),
        Form::Empty | Form::Other => false,
    };
    if !is_filled {
        return other_leaf(env, sink, shape, rule);
    }
    env.filled += 1;
    sink.filled(&Filled { shape, tables: &env.leaf_tables, rule })
}

/// A leaf that does not simply fill its scope, or a box whose sides have texture coordinates of their own.
#[cold]
#[inline(never)]
fn other_leaf(env: &mut Env, sink: &mut dyn Sink, shape: &ShapeRef<'_>, rule: u32) -> Flow {
    env.shapes += 1;
    let mut shape = env.whole(shape);
    shape.bake();
    env.leaves += u64::from(shape.geometry.has_surface());
    let rule = env.leaf_tables.names.get(rule as usize).copied().unwrap_or_default();
    let leaf = Leaf::new(rule, shape.state.material(), &shape.scope);
    match &shape.geometry {
        Geometry::Rect(axis, unit) => sink.quad(&leaf, &place::rectangle(&shape.scope, *axis, *unit)),
        Geometry::Box(unit) => sink.cuboid(&leaf, &place::cuboid(&shape.scope, *unit)),
        Geometry::Empty | Geometry::Vertex | Geometry::Edge | Geometry::Wire(_) => Flow::Continue(()),
        Geometry::Mesh(placed) => {
            let placement = shape.scope.placement() * placed.to_scope(shape.scope.size);
            if placed.inserted == Inserted::Asset {
                sink.instance(&leaf, &placed.mesh, &placement)
            } else {
                sink.mesh(&leaf, &placed.mesh, &placement)
            }
        }
    }
}

/// The start rule of a run: its number, its style and its name.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Start {
    rule: u32,
    style: u32,
    name: &'static str,
}

/// The part of a run that the next run of the session can use. No result depends on it.
pub(crate) struct Kept<C> {
    templates: Templates<C>,
    materials: MaterialIds,
}

impl<C> Default for Kept<C> {
    fn default() -> Self {
        Kept { templates: Templates::default(), materials: MaterialIds::default() }
    }
}

impl<C> Kept<C> {
    /// A run begins. Templates and painted materials of attributes that are computed for each initial shape are of no use to it.
    fn begin(&mut self, is_settled: bool) {
        if !is_settled || self.materials.is_full() {
            *self = Kept::default();
        }
    }
}

/// The result of a run, with or without an error.
#[derive(Debug, Default)]
pub(crate) struct Outcome {
    pub(crate) report: Report,
    pub(crate) error: Option<Error>,
}

/// Runs a grammar on a shape that was checked.
pub(crate) fn run<R: Rules>(
    rules: &R,
    Start { rule, style, name }: Start,
    shape: &Shape,
    settings: &Settings,
    kept: &mut Kept<R::Call>,
    sink: &mut dyn Sink,
) -> Outcome {
    let mut env = Env::new(settings, R::NAMES, shape, name);
    env.leaf_tables.names = R::LEAVES;
    sink.begin();
    kept.begin(R::SETTLED);
    // Both at once: templates have numbers of these materials. A sink that panics leaves neither in the session.
    std::mem::swap(&mut env.leaf_tables.materials, &mut kept.materials);
    let mut templates = std::mem::take(&mut kept.templates);
    let mut cx =
        Cx { env: &mut env, sink, waiting: VecDeque::new(), stack: 0, depth: 0, templates: &mut templates, tape: None };
    let values = rules.values(cx.env, shape, style);
    // A break with no error is the sink's or the watch's.
    let mut flow = if cx.env.ended() { Flow::Break(()) } else { Flow::Continue(()) };
    if flow.is_continue() {
        let base = cx.env.base(shape.without_trim_planes());
        flow = R::start(&values, &mut cx, rule, &base.shape());
    }
    while flow.is_continue() {
        let Some(next) = cx.waiting.pop_front() else { break };
        (cx.depth, cx.stack) = (next.depth, 0);
        cx.env.resume_trail(next.trail);
        let base = cx.env.base(next.shape);
        flow = R::resume(&values, &mut cx, &base.shape(), next.call);
    }
    std::mem::swap(&mut env.leaf_tables.materials, &mut kept.materials);
    kept.templates = templates;
    env.tell_watch(flow.is_continue());
    let (faults, faults_left_out) = env.take_faults();
    let prints = std::mem::take(&mut env.prints);
    let (prints_left_out, prints_bytes) = (prints.left_out, prints.bytes);
    let report = Report {
        shapes: env.shapes_made(),
        leaves: env.leaf_count(),
        faults,
        faults_left_out,
        stopped: flow.is_break() && env.error.is_none(),
        reports: std::mem::take(&mut env.reports),
        prints: prints.in_order(),
        prints_left_out,
        prints_bytes,
    };
    Outcome { report, error: env.error.take() }
}

/// Writes lines to standard output. A closed output does not end the run.
pub(crate) fn echo(prints: &[Print]) {
    let mut out = std::io::stdout().lock();
    let _ = prints.iter().try_for_each(|print| writeln!(out, "{print}"));
}

/// The start rule of a name, or the default one. `Default$Lot` is `Lot`.
pub(crate) fn start_rule<R: Rules>(name: Option<&str>) -> Result<Start, Error> {
    let at = match name {
        None => Some(0),
        Some(name) => {
            let plain = name.strip_prefix("Default$").unwrap_or(name);
            R::STARTS.iter().position(|start| start.name == name || start.name == plain)
        }
    };
    let start = at.and_then(|at| {
        let (rule, style) = (*R::START_RULES.get(at)?, *R::START_STYLES.get(at)?);
        Some(Start { rule, style, name: R::STARTS.get(at)?.name })
    });
    start.ok_or_else(|| {
        let known = R::STARTS.iter().filter(|start| !start.hidden).map(|start| start.name).collect();
        Error::StartRule { name: name.unwrap_or_default().to_owned(), known }
    })
}
