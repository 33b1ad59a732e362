//! Operations that divide the current shape, without splits.

use cga_runtime::rt::{self, Arm, Cx, Env, Flow, Shape, ShapeRef, Size};
use cga_runtime::rt_eval::Candidate;

use super::values::Values;
use crate::call::Call;
use crate::current::Current;
use crate::dispatch::SizeKind;
use crate::stack::{Frame, SharedStack};
use crate::steps::{ArmsKind, ArmsStep, EachStep, SectionsStep, SlotsCode};

impl Values {
    /// A comp, or another operation with arms.
    #[inline(never)]
    pub(super) fn arms(&self, cx: &mut Cx<'_, Call>, shape: &ShapeRef<'_>, step: &ArmsStep, frame: Frame) -> Flow {
        self.eval(cx.env, shape, &step.args, frame);
        if let Some(table) = step.arms.fixed() {
            return self.divide(cx, shape, step, table, frame);
        }
        self.eval(cx.env, shape, &step.arms.indices, frame);
        let table = step.arms.table(&mut self.stack.borrow_mut());
        self.divide(cx, shape, step, &table, frame)
    }

    fn divide(
        &self,
        cx: &mut Cx<'_, Call>,
        shape: &ShapeRef<'_>,
        step: &ArmsStep,
        table: &[Arm],
        frame: Frame,
    ) -> Flow {
        let when = &mut |env: &mut Env, arm: u32, candidate: &mut Candidate<'_>| {
            self.condition(env, candidate, &step.arms.conditions, arm, frame)
        };
        let visit = &mut |cx: &mut Cx<'_, Call>, arm: u32, part: &ShapeRef<'_>| {
            self.part_of(cx, part, &step.targets, arm, frame)
        };
        match &step.kind {
            ArmsKind::Comp(components, align) => {
                rt::comp(cx, shape, step.number, *components, *align, table, when, visit)
            }
            ArmsKind::CompAndRest(components, align) => {
                rt::comp_and_rest(cx, shape, step.number, *components, *align, table, when, visit)
            }
            ArmsKind::Divide(call) => (call.0)(SharedStack(&self.stack), cx, shape, step.number, table, when, visit),
        }
    }

    /// An operation with sections.
    #[inline(never)]
    pub(super) fn sections(
        &self,
        cx: &mut Cx<'_, Call>,
        shape: &ShapeRef<'_>,
        step: &SectionsStep,
        frame: Frame,
    ) -> Flow {
        self.eval(cx.env, shape, &step.args, frame);
        let mut sizes = self.sizes(cx, shape, &step.slots, frame);
        self.eval(cx.env, shape, &step.rest.indices, frame);
        let rest = step.rest.table(&mut self.stack.borrow_mut());
        let depth = &mut |env: &mut Env, slot: u32, part: &mut Shape| {
            let Some(depth) = step.depths.get(slot as usize) else { return 0.0 };
            let stack = &mut *self.stack.borrow_mut();
            self.run(stack, env, &mut Current::Whole(part), depth, frame);
            stack.float()
        };
        let visit = &mut |cx: &mut Cx<'_, Call>, slot: u32, part: &ShapeRef<'_>| {
            self.part_of(cx, part, &step.slots.targets, slot, frame)
        };
        let pattern = (&*step.slots.pattern, &mut sizes[..]);
        (step.call.0)(SharedStack(&self.stack), cx, shape, step.number, pattern, &rest, depth, visit)
    }

    /// The sizes of slots.
    pub(super) fn sizes(
        &self,
        cx: &mut Cx<'_, Call>,
        shape: &ShapeRef<'_>,
        slots: &SlotsCode,
        frame: Frame,
    ) -> Vec<Size> {
        if let Some(known) = &slots.known {
            return known.to_vec();
        }
        self.eval(cx.env, shape, &slots.values, frame);
        let stack = &mut *self.stack.borrow_mut();
        let first = stack.numbers.len().saturating_sub(slots.prefixes.len());
        let values = stack.numbers.drain(first..);
        slots.prefixes.iter().zip(values).map(|(prefix, value)| SizeKind(*prefix).of(value)).collect()
    }

    /// An operation with the same successor for each part.
    #[inline(never)]
    pub(super) fn each(&self, cx: &mut Cx<'_, Call>, shape: &ShapeRef<'_>, step: &EachStep, frame: Frame) -> Flow {
        self.eval(cx.env, shape, &step.args, frame);
        let visit = &mut |cx: &mut Cx<'_, Call>, part: &ShapeRef<'_>| self.part(cx, part, &step.target, frame);
        (step.call.0)(SharedStack(&self.stack), cx, shape, step.number, visit)
    }
}
