//! A run: rules call each other directly, leaves go to the sink as they appear.
//!
//! Order of leaves: depth first, in writing order. Calls inside a cycle of rules are direct down to [`DIRECT`] levels;
//! deeper ones wait on a list and run, first in first out, when the direct ones are through. Both follow from the rules
//! alone, so the order is the same in every run.

use std::collections::VecDeque;
use std::rc::Rc;

use crate::env::{Env, Trail};
use crate::fault::{Error, Fault};
use crate::grammar::Rules;
use crate::place;
use crate::settings::Settings;
use crate::shape::{Geometry, Shape, ShapeRef};
use crate::sink::{Flow, Leaf, Sink};

/// Levels of recursion that use the stack.
const DIRECT: u32 = 48;

/// What a run says besides what it gave the sink.
#[derive(Clone, Debug, Default)]
pub struct Report {
    /// Shapes derived, leaves included.
    pub shapes: u64,
    /// Leaves handed to the sink.
    pub leaves: u64,
    /// What went wrong on the way; the first thousand.
    pub faults: Vec<Fault>,
    /// Faults beyond those kept.
    pub faults_left_out: u64,
    /// Whether the sink ended the run.
    pub stopped: bool,
}

/// A run under way: what generated code hands from rule to rule.
#[derive(Debug)]
pub struct Cx<'r, S: ?Sized, C> {
    /// The part that does not depend on the sink.
    pub env: Env,
    sink: &'r mut S,
    waiting: VecDeque<Waiting<C>>,
    /// Recursion levels on the stack, and before the work item under way.
    direct: u32,
    depth: u32,
}

#[derive(Debug)]
struct Waiting<C> {
    shape: Shape,
    call: C,
    depth: u32,
    trail: Rc<Trail>,
}

impl<S: Sink + ?Sized, C> Cx<'_, S, C> {
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

    /// Whether a call inside a cycle of rules may use the stack. If so, [`Cx::ascend`] follows the call.
    #[inline]
    pub fn descend(&mut self) -> bool {
        let may = self.direct < DIRECT && self.depth + self.direct < self.env.settings.limits.depth;
        self.direct += u32::from(may);
        may
    }

    /// Comes back from a direct call inside a cycle.
    #[inline]
    pub fn ascend(&mut self) {
        self.direct -= 1;
    }

    /// Puts a call inside a cycle on the list.
    pub fn defer(&mut self, shape: &ShapeRef<'_>, call: C) -> Flow {
        let depth = self.depth + self.direct + 1;
        if self.env.settings.limits.depth < depth {
            return self.env.limit("depth", u64::from(self.env.settings.limits.depth));
        }
        // What waits is counted when it runs; the list must not outgrow the limit either.
        if self.env.settings.limits.shapes < self.env.shapes.saturating_add(self.waiting.len() as u64) {
            return self.env.limit("shapes", self.env.settings.limits.shapes);
        }
        let trail = self.env.keep_trail();
        self.waiting.push_back(Waiting { shape: shape.detach(), call, depth, trail });
        Flow::Continue(())
    }

    /// Hands a leaf to the sink. A shape without geometry leaves nothing.
    #[inline]
    pub fn leaf(&mut self, shape: &ShapeRef<'_>, rule: &'static str) -> Flow {
        self.env.leaves += 1;
        let leaf = Leaf { rule, material: shape.state.material(), scope: &shape.scope };
        match &shape.geometry {
            Geometry::Rect(axis) => self.sink.quad(&leaf, &place::rect(&shape.scope, *axis)),
            Geometry::Box => self.sink.cuboid(&leaf, &place::cuboid(&shape.scope)),
            Geometry::Empty => Flow::Continue(()),
            Geometry::Mesh(placed) => {
                let placement = shape.scope.placement() * placed.to_scope(shape.scope.size);
                if placed.whole {
                    self.sink.instance(&leaf, &placed.mesh, &placement)
                } else {
                    self.sink.mesh(&leaf, &placed.mesh, &placement)
                }
            }
        }
    }

    /// A leaf symbol: counts as a shape of its own.
    #[inline]
    pub fn symbol(&mut self, shape: &ShapeRef<'_>, name: &'static str) -> Flow {
        self.env.count_shapes(1)?;
        self.leaf(shape, name)
    }
}

/// Runs a grammar on a shape.
///
/// # Errors
/// See [`Error`]: a limit, an attribute out of its range, a shape that is no shape.
pub fn run<R: Rules, S: Sink + ?Sized>(
    rules: &R,
    shape: &Shape,
    settings: &Settings,
    sink: &mut S,
) -> Result<Report, Error> {
    shape.check()?;
    rules.check()?;
    let start = start_rule::<R>(settings.start.as_deref())?;
    let env = Env::new(settings, R::NAMES, shape.scope.size.abs().max_element());
    let mut cx = Cx { env, sink, waiting: VecDeque::new(), direct: 0, depth: 0 };
    let values = rules.values(&mut cx.env, shape);
    // A break with no error is the sink's.
    let mut flow = if cx.env.error.is_some() { Flow::Break(()) } else { Flow::Continue(()) };
    if flow.is_continue() {
        flow = R::start(&values, &mut cx, start, shape.clone());
    }
    while flow.is_continue() {
        let Some(next) = cx.waiting.pop_front() else { break };
        (cx.depth, cx.direct) = (next.depth, 0);
        cx.env.resume_trail(next.trail);
        flow = R::resume(&values, &mut cx, next.shape, next.call);
    }
    let (faults, faults_left_out) = cx.env.take_faults();
    match cx.env.error.take() {
        Some(error) => Err(error),
        None => Ok(Report {
            shapes: cx.env.shapes,
            leaves: cx.env.leaves,
            faults,
            faults_left_out,
            stopped: flow.is_break(),
        }),
    }
}

/// The number of a start rule, the default one for `None`.
fn start_rule<R: Rules>(name: Option<&str>) -> Result<u32, Error> {
    let at = match name {
        None => Some(0),
        Some(name) => R::STARTS.iter().position(|start| *start == name),
    };
    at.and_then(|at| R::START_RULES.get(at)).copied().ok_or_else(|| Error::StartRule {
        name: name.unwrap_or_default().to_owned(),
        known: R::STARTS,
    })
}
