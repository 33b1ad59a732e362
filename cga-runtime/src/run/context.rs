//! A run as seen by rules: rules call each other directly, and leaves go to the sink as they appear.
//!
//! Leaves come depth first, in writing order. Only where rules nest so deeply that [`STACK`] is used up, calls wait
//! in a list. They run, first in first out, after the direct calls. The stack use of a call is an estimate of the
//! compiler that follows from the rules alone, so the order is the same in every run and every build.

use std::collections::VecDeque;
use std::rc::Rc;

use glam::DAffine3;

use crate::fault::LimitKind;
use crate::run::env::tree::RecordedShape;
use crate::run::env::{Env, Trail};
use crate::run::sink::{Filled, Flow, Leaf, Sink};
use crate::run::template::{Tape, Templates};
use crate::shape::base::Form;
use crate::shape::scope::Scope;
use crate::shape::{Geometry, Inserted, Placed, Shape, ShapeRef, filled_scope};
use crate::value::text::Text;

/// The stack that direct calls may use, in the units of generated code: about a kilobyte each in a build without
/// optimisation, much less with it. Threads have two megabytes, of which functions (`FUNCTIONS` in `run/env`), sinks
/// and Rust operations need their share.
pub(crate) const STACK: u32 = 640;

/// The state of a run, passed from rule to rule by generated code.
#[expect(missing_debug_implementations, reason = "sinks need not be printable")]
pub struct Cx<'r, C> {
    /// The part of the state that does not depend on the sink.
    pub env: &'r mut Env,
    pub(crate) sink: &'r mut dyn Sink,
    pub(crate) waiting: VecDeque<WaitingCall<C>>,
    /// The part of [`STACK`] that direct calls use at present.
    pub(crate) stack: u32,
    /// The nesting of recursive rules.
    pub(crate) depth: u32,
    /// The templates of parts that repeat.
    pub(crate) templates: &'r mut Templates<C>,
    /// The recording of the template under construction.
    pub(crate) tape: Option<Tape<'r, C>>,
    /// True if an operation takes the leaves as whole shapes.
    pub(crate) is_operand: bool,
}

/// A call that waited, or a hole of a template.
pub(crate) type ResumeFn<G, C> = fn(&G, &mut Cx<'_, C>, &ShapeRef<'_>, C) -> Flow;

/// The run inside an operation that changes a material, for the expressions among its arguments.
#[derive(Debug)]
pub struct MaterialCx<'r> {
    /// The run.
    pub env: &'r mut Env,
}

#[derive(Debug)]
pub(crate) struct WaitingCall<C> {
    pub(super) shape: Shape,
    pub(super) call: C,
    pub(super) depth: u32,
    /// The units of [`STACK`] that the call asked for.
    pub(super) stack: u32,
    pub(super) trail: Rc<Trail>,
}

impl<'r, C> Cx<'r, C> {
    /// The state before the first rule.
    pub(crate) fn new(env: &'r mut Env, sink: &'r mut dyn Sink, templates: &'r mut Templates<C>) -> Self {
        Cx { env, sink, waiting: VecDeque::new(), stack: 0, depth: 0, templates, tape: None, is_operand: false }
    }
}

impl<C> Cx<'_, C> {
    /// Enters a rule. Every rule that was entered is left again unless the run ends inside it.
    #[inline]
    pub fn enter(&mut self, rule: u32, shape: &ShapeRef<'_>) -> Flow {
        self.env.trail.push(rule);
        self.env.shapes += 1;
        if self.env.has_room(0) { Flow::Continue(()) } else { self.env.enter(shape) }
    }

    /// Returns true if the rest of a rule makes no difference: this derivation collects shapes for queries, and the rule makes none of this
    /// shape. The rule makes no labels, and solids of flat faces only if `makes_solids`.
    #[inline]
    pub fn leaves_nothing(&self, shape: &ShapeRef<'_>, makes_solids: bool) -> bool {
        self.env.leaves_nothing(shape, makes_solids)
    }

    /// Leaves a rule.
    #[inline]
    pub fn leave(&mut self) -> Flow {
        self.env.trail.pop();
        Flow::Continue(())
    }

    /// Enters a block, in grammars whose rules ask about closed shapes of the same initial shape.
    #[inline]
    pub fn enter_block(&mut self) {
        self.env.enter_block();
    }

    /// Leaves a block.
    #[inline]
    pub fn leave_block(&mut self) -> Flow {
        self.env.leave_block();
        Flow::Continue(())
    }

    /// Reserves stack for a call: `levels` of recursion, 0 or 1, and `stack` units of [`STACK`]. Returns true if they
    /// are available; [`Cx::ascend`] then follows the call. Otherwise [`Cx::defer`] replaces the call.
    #[inline]
    pub fn descend(&mut self, levels: u32, stack: u32) -> bool {
        let may = self.stack + stack <= STACK && self.depth + levels <= self.env.settings.limits.depth;
        if may {
            self.stack += stack;
            self.depth += levels;
        }
        may
    }

    /// Releases the stack of a direct call.
    #[inline]
    pub fn ascend(&mut self, levels: u32, stack: u32) {
        self.stack -= stack;
        self.depth -= levels;
    }

    /// Adds a call to the list of waiting calls. `levels` and `stack` are the arguments of [`Cx::descend`].
    #[cold]
    pub fn defer(&mut self, shape: &ShapeRef<'_>, levels: u32, stack: u32, call: C) -> Flow {
        let depth = self.depth + levels;
        if self.env.settings.limits.depth < depth {
            return self.env.limit(LimitKind::Depth, u64::from(self.env.settings.limits.depth));
        }
        if self.env.settings.limits.waiting <= self.waiting.len() as u64 {
            return self.env.limit(LimitKind::Waiting, self.env.settings.limits.waiting);
        }
        let trail = self.env.keep_trail();
        self.waiting.push_back(WaitingCall { shape: self.env.whole(shape), call, depth, stack, trail });
        Flow::Continue(())
    }

    /// Passes the shape of a rule to the sink as a leaf. A shape without faces is a placement; a shape
    /// without geometry, of which nothing is left, makes no leaf.
    #[inline]
    pub fn leaf(&mut self, shape: &ShapeRef<'_>, rule: u32) -> Flow {
        if !self.env.has_room(0) {
            return leaf_at_checkpoint(self.env, self.sink, shape, rule);
        }
        // It was counted when its rule was entered.
        self.env.shapes -= 1;
        filled(self.env, self.sink, shape, rule)
    }

    /// As [`Cx::leaf`], compiled once for a grammar, for rare leaves.
    #[inline(never)]
    pub fn any_leaf(&mut self, shape: &ShapeRef<'_>, rule: u32) -> Flow {
        self.leaf(shape, rule)
    }

    /// As [`Cx::symbol`], compiled once for a grammar, for rare leaves.
    #[inline(never)]
    pub fn any_symbol(&mut self, shape: &ShapeRef<'_>, rule: u32) -> Flow {
        self.symbol(shape, rule)
    }

    /// Removes a shape, `NIL`, in a rule that an operand may reach. It still moves its neighbours when the operand is recomposed
    /// (*Shape recomposition*).
    #[inline(never)]
    pub fn vanish(&mut self, shape: &ShapeRef<'_>) -> Flow {
        if self.env.recompositions.is_empty() {
            return Flow::Continue(());
        }
        let whole = self.env.whole(shape);
        self.sink.gone(&whole)
    }

    /// Passes a leaf symbol to the sink. It counts as a shape of its own.
    #[inline(always)]
    pub fn symbol(&mut self, shape: &ShapeRef<'_>, rule: u32) -> Flow {
        if !self.env.has_room(1) {
            return symbol_at_checkpoint(self.env, self.sink, shape, rule);
        }
        filled(self.env, self.sink, shape, rule)
    }
}

/// Passes a leaf symbol, for which there is room, to the sink.
#[inline]
pub(crate) fn filled(env: &mut Env, sink: &mut dyn Sink, shape: &ShapeRef<'_>, rule: u32) -> Flow {
    let is_filled = match shape.form {
        Form::Rect(_) => true,
        Form::Box if shape.has_sides() => return box_with_sides(env, sink, shape, rule),
        Form::Box => true,
        Form::Empty | Form::Other => false,
    };
    if !is_filled {
        return other_leaf(env, sink, shape, rule);
    }
    env.filled += 1;
    sink.filled(&Filled { shape, tables: &env.leaf_tables, rule })
}

/// Passes the shape of a rule to the sink, at the checkpoint.
#[cold]
#[inline(never)]
fn leaf_at_checkpoint(env: &mut Env, sink: &mut dyn Sink, shape: &ShapeRef<'_>, rule: u32) -> Flow {
    if env.ended() {
        return Flow::Break(());
    }
    env.shapes -= 1;
    let recorded = env.recorded_shape();
    recorded_leaf(env, sink, shape, rule, recorded)
}

/// Passes a leaf symbol to the sink, at the checkpoint.
#[cold]
#[inline(never)]
fn symbol_at_checkpoint(env: &mut Env, sink: &mut dyn Sink, shape: &ShapeRef<'_>, rule: u32) -> Flow {
    if !env.has_quiet_room(1) {
        env.make_room(1)?;
    }
    if env.only_counts_symbol() {
        return filled(env, sink, shape, rule);
    }
    recorded_symbol(env, sink, shape, rule)
}

/// Passes a leaf symbol, for which there is room, to the sink, and records its shape.
#[cold]
#[inline(never)]
pub(crate) fn recorded_symbol(env: &mut Env, sink: &mut dyn Sink, shape: &ShapeRef<'_>, rule: u32) -> Flow {
    let recorded = env.record_symbol(shape, rule);
    recorded_leaf(env, sink, shape, rule, recorded)
}

/// Passes a leaf with its recorded shape, if any, to the sink.
fn recorded_leaf(env: &mut Env, sink: &mut dyn Sink, shape: &ShapeRef<'_>, rule: u32, recorded: RecordedShape) -> Flow {
    let leaves = env.leaf_count();
    let flow = filled(env, sink, shape, rule);
    // A shape of which nothing is left is not a leaf.
    if leaves < env.leaf_count() {
        env.record_leaf(recorded, shape, rule);
    }
    flow
}

/// A box whose sides have different texture coordinates. A cube as it is inserted has a mesh that all cubes share, so templates and sinks do
/// not hold one for each.
#[cold]
#[inline(never)]
fn box_with_sides(env: &mut Env, sink: &mut dyn Sink, shape: &ShapeRef<'_>, rule: u32) -> Flow {
    env.ask()?;
    env.shapes += 1;
    if let Some(flow) = sink.keep(&|| env.leaf_tables.whole(shape)) {
        return flow;
    }
    let (unit, scope, base) = (shape.unit.get(), shape.scope(), &shape.base.shape.state);
    let look = env.leaf_tables.looks.get(shape.look.get()).unwrap_or(base.look());
    let is_inserted = look.coordinates.is_cube_in(&scope);
    let sets = if is_inserted { Vec::new() } else { look.coordinates.on_box(unit, &scope, base.projections()) };
    env.leaves += 1;
    env.count_leaf(4 * unit.face_count() as u64, sets.len() as u64)?;
    let rule = env.leaf_tables.names.get(rule as usize).unwrap_or(Text::EMPTY);
    let material = env.leaf_tables.looks.get(shape.look.get()).map_or(base.material(), |look| &look.material);
    let (leaf, cuboid) = (Leaf::new(rule, material, &scope).with_uvs(&sets), filled_scope::cuboid(&scope, unit));
    if is_inserted {
        let placement = DAffine3 { matrix3: cuboid.sides, translation: cuboid.origin };
        return sink.mesh(&leaf, unit.with_cube_coordinates(), &placement);
    }
    sink.cuboid(&leaf, &cuboid)
}

/// A leaf that does not fill its scope.
#[cold]
#[inline(never)]
fn other_leaf(env: &mut Env, sink: &mut dyn Sink, shape: &ShapeRef<'_>, rule: u32) -> Flow {
    env.ask()?;
    env.shapes += 1;
    if shape.form == Form::Other
        && let Geometry::Mesh(placed) = &shape.base.shape.geometry
        && env.leaf_tables.look(shape).coordinates.is_empty()
    {
        return mesh_leaf(env, sink, shape, placed, rule);
    }
    let mut shape = env.whole(shape);
    if let Some(flow) = sink.keep(&|| shape.clone()) {
        return flow;
    }
    let has_own_sets = !shape.state.coordinates().is_empty();
    if has_own_sets {
        env.kept.shared_sets.write(&mut shape);
    }
    env.leaves += u64::from(!matches!(shape.geometry, Geometry::Empty));
    if let Geometry::Mesh(placed) = &shape.geometry {
        let own = if has_own_sets { placed.mesh.corners().len() as u64 } else { 0 };
        env.count_leaf(own, placed.mesh.uv_numbers().count() as u64)?;
    }
    let rule = env.leaf_tables.names.get(rule as usize).cloned().unwrap_or_default();
    let leaf = Leaf::new(&rule, shape.state.material(), &shape.scope);
    match &shape.geometry {
        Geometry::Rect(axis, unit) => sink.quad(&leaf, &filled_scope::rectangle(&shape.scope, *axis, *unit)),
        Geometry::Box(unit) => sink.cuboid(&leaf, &filled_scope::cuboid(&shape.scope, *unit)),
        Geometry::Empty => Flow::Continue(()),
        Geometry::Vertex | Geometry::Edge | Geometry::Wire(_) => sink.placement(&leaf),
        Geometry::Mesh(placed) => pass_mesh(sink, &leaf, placed, &shape.scope),
    }
}

/// A leaf that is a mesh without implicit texture coordinates. Its shape need not be copied.
fn mesh_leaf(env: &mut Env, sink: &mut dyn Sink, shape: &ShapeRef<'_>, placed: &Placed, rule: u32) -> Flow {
    let is_read = env.reads(&placed.mesh);
    let whole = || {
        let whole = env.leaf_tables.whole(shape);
        if is_read { whole } else { Shape { geometry: Geometry::Empty, ..whole } }
    };
    if let Some(flow) = sink.keep(&whole) {
        return flow;
    }
    if !is_read {
        return Flow::Continue(());
    }
    env.leaves += 1;
    env.count_leaf(0, placed.mesh.uv_numbers().count() as u64)?;
    let rule = env.leaf_tables.names.get(rule as usize).unwrap_or(Text::EMPTY);
    let scope = shape.scope();
    pass_mesh(sink, &Leaf::new(rule, &env.leaf_tables.look(shape).material, &scope), placed, &scope)
}

/// Passes a mesh in a scope to the sink.
fn pass_mesh(sink: &mut dyn Sink, leaf: &Leaf<'_>, placed: &Placed, scope: &Scope) -> Flow {
    let placement = scope.placement() * placed.to_scope(scope.size);
    match placed.inserted {
        Inserted::Asset => sink.instance(leaf, &placed.mesh, &placement),
        Inserted::No | Inserted::Plain => sink.mesh(leaf, &placed.mesh, &placement),
    }
}
