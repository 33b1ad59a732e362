//! Operands: rules that run at once, and whose leaves an operation takes (*Rule inlining*).

use std::collections::VecDeque;
use std::ops::ControlFlow;
use std::sync::Arc;

use glam::DAffine3;

use crate::fault::LimitKind;
use crate::geometry::mesh::Mesh;
use crate::geometry::trace::Trace;
use crate::run::context::{Cx, ResumeFn, STACK};
use crate::run::sink::{Filled, Flow, Leaf, Sink};
use crate::shape::{Geometry, Shape};

/// The stack that calls may use inside operands beyond [`STACK`], in the same units. Calls in operands cannot wait until
/// the stack is empty.
const MORE_STACK: u32 = 128;

/// A sink that keeps leaves as whole shapes.
struct OperandLeaves {
    list: Vec<Shape>,
    /// The number of leaves that may be kept.
    most: u64,
    is_full: bool,
}

impl OperandLeaves {
    fn add(&mut self, shape: Shape) -> Flow {
        if matches!(shape.geometry, Geometry::Empty) {
            return Flow::Continue(());
        }
        if self.most <= self.list.len() as u64 {
            self.is_full = true;
            return Flow::Break(());
        }
        self.list.push(shape);
        Flow::Continue(())
    }
}

impl Sink for OperandLeaves {
    fn filled(&mut self, leaf: &Filled<'_>) -> Flow {
        self.add(leaf.whole())
    }

    fn keep(&mut self, shape: &dyn Fn() -> Shape) -> Option<Flow> {
        Some(self.add(shape()))
    }

    fn gone(&mut self, shape: &Shape) -> Flow {
        let mut shape = shape.clone();
        shape.change_trace(Trace::remove);
        if shape.trace().is_some_and(Trace::is_gone) { self.add(shape) } else { Flow::Continue(()) }
    }

    fn mesh(&mut self, _: &Leaf<'_>, _: &Arc<Mesh>, _: &DAffine3) -> Flow {
        Flow::Continue(())
    }
}

/// Derives an operand from the current shape, with `start` as its first step, and returns its leaves that have geometry,
/// in order. They are neither leaves of the run nor shapes of its tree.
pub fn operand<G, C>(
    cx: &mut Cx<'_, C>,
    g: &G,
    start: &mut dyn FnMut(&mut Cx<'_, C>) -> Flow,
    resume: ResumeFn<G, C>,
) -> ControlFlow<(), Vec<Shape>> {
    let most = cx.env.settings.limits.waiting;
    let mut leaves = OperandLeaves { list: Vec::new(), most, is_full: false };
    let (filled, others) = (cx.env.filled, cx.env.leaves);
    let (tree, before) = (cx.env.tree.take(), cx.env.begin_operand());
    let mut inner = Cx {
        env: cx.env,
        sink: &mut leaves,
        waiting: VecDeque::new(),
        stack: cx.stack,
        depth: cx.depth,
        templates: cx.templates,
        tape: None,
        is_operand: true,
    };
    let flow = start(&mut inner);
    let flow = if flow.is_continue() { inner.run_waiting(g, resume) } else { flow };
    cx.env.tree = tree;
    cx.env.end_operand(before);
    // A full list must not look like a sink that has enough.
    if leaves.is_full && !cx.env.ended() {
        return cx.env.limit(LimitKind::Waiting, most);
    }
    flow?;
    // The leaves stay counted as shapes.
    cx.env.shapes += cx.env.filled - filled;
    (cx.env.filled, cx.env.leaves) = (filled, others);
    ControlFlow::Continue(leaves.list)
}

impl<C> Cx<'_, C> {
    /// Runs the calls that wait in an operand, on top of the stack that is in use.
    fn run_waiting<G>(&mut self, g: &G, resume: ResumeFn<G, C>) -> Flow {
        if self.waiting.is_empty() {
            return Flow::Continue(());
        }
        let (stack, depth, trail, before) = (self.stack, self.depth, self.env.trail.clone(), self.env.before.clone());
        while let Some(next) = self.waiting.pop_front() {
            if STACK + MORE_STACK < stack + next.stack {
                return self.env.limit(LimitKind::Depth, u64::from(next.depth));
            }
            (self.depth, self.stack) = (next.depth, stack + next.stack);
            self.env.resume_trail(next.trail);
            let base = self.env.base(next.shape);
            resume(g, self, &base.shape(), next.call)?;
        }
        (self.stack, self.depth) = (stack, depth);
        (self.env.trail, self.env.before) = (trail, before);
        Flow::Continue(())
    }
}
