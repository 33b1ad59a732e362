//! Rules: they call each other, and their leaves go to the sink.

use std::ops::ControlFlow;

use cga_runtime::rt::{self, Bases, Cx, Flow, ShapeRef};

use super::values::Values;
use crate::call::Call;
use crate::stack::Frame;
use crate::steps::{Body, End, RuleCall, RuleCode, StepCode, TargetCode};

impl Values {
    /// Runs a rule whose arguments are on the stack from `frame` on.
    pub(crate) fn rule(&self, cx: &mut Cx<'_, Call>, shape: &ShapeRef<'_>, number: usize, frame: Frame) -> Flow {
        let rule = &self.program.rules[number];
        match (rule.is_block, rule.tells_part) {
            (false, _) => {
                cx.enter(rule.trail.at(frame.site), shape)?;
                if !rule.params.is_empty() {
                    cx.env.record_arguments(|| self.stack.borrow().values(&rule.params, frame));
                }
            }
            (true, true) => cx.enter_block(),
            (true, false) => {}
        }
        self.eval(cx.env, shape, &rule.locals, frame);
        let mut childless = true;
        self.body(cx, shape, &rule.body, rule, frame, &mut childless)?;
        if rule.has_values {
            self.stack.borrow_mut().truncate(frame);
        }
        match (rule.is_block, rule.tells_part) {
            (false, _) => cx.leave(),
            (true, true) => cx.leave_block(),
            (true, false) => Flow::Continue(()),
        }
    }

    /// Runs a start rule.
    pub(crate) fn start(&self, cx: &mut Cx<'_, Call>, rule: usize, shape: &ShapeRef<'_>) -> Flow {
        self.rule(cx, shape, rule, self.empty_frame(0))
    }

    /// Runs a call that waited, or a hole of a template.
    pub(crate) fn resume(&self, cx: &mut Cx<'_, Call>, shape: &ShapeRef<'_>, call: Call) -> Flow {
        let rule = call.rule;
        let frame = call.give(&mut self.stack.borrow_mut());
        self.rule(cx, shape, rule, frame)?;
        self.stack.borrow_mut().truncate(frame);
        Flow::Continue(())
    }

    /// Runs steps up to the end of a rule or a bracket.
    fn body(
        &self,
        cx: &mut Cx<'_, Call>,
        shape: &ShapeRef<'_>,
        body: &Body,
        rule: &RuleCode,
        frame: Frame,
        childless: &mut bool,
    ) -> Flow {
        let bases = Bases::new();
        let base = if body.reads_scope { Some(shape.scope()) } else { None };
        let base = base.as_ref();
        // The current shape after the first change.
        let mut own: Option<ShapeRef<'_>> = None;
        let (mut body, mut next) = (body, 0);
        while let Some(step) = body.steps.get(next) {
            next += 1;
            let current = own.as_ref().unwrap_or(shape);
            match step {
                StepCode::Slim(steps) => own = Some(self.slim(cx, current, &bases, steps, frame)),
                StepCode::Whole(steps) => own = Some(self.whole(cx, current, &bases, base, steps, frame)?),
                StepCode::Operands(step) => own = Some(self.operands(cx, current, &bases, step, frame)?),
                StepCode::Case(arms, otherwise) => {
                    body = self.branch(cx, current, arms, otherwise, frame);
                    next = 0;
                }
                StepCode::Split(step) => {
                    let has_parts = self.split(cx, current, step, frame)?;
                    *childless &= !has_parts;
                }
                StepCode::Give { target, number, is_last } => {
                    self.give(cx, current, target, *number, *is_last, frame)?;
                    *childless = false;
                }
                StepCode::Push(inside, number) => {
                    // Its steps decide whether the rule has a child.
                    self.body(cx, &rt::push(current, *number), inside, rule, frame, childless)?;
                }
                StepCode::Arms(step) => {
                    self.arms(cx, current, step, frame)?;
                    *childless = false;
                }
                StepCode::Renew(step) => {
                    self.renewed(cx, current, step, frame)?;
                    *childless = false;
                }
                StepCode::Sections(step) => {
                    self.sections(cx, current, step, frame)?;
                    *childless = false;
                }
                StepCode::Each(step) => {
                    self.each(cx, current, step, frame)?;
                    *childless = false;
                }
            }
        }
        match body.end {
            End::Leaf => {}
            End::IfChildless if *childless => {}
            End::IfChildless | End::Nothing => return Flow::Continue(()),
        }
        let (shape, label) = (own.as_ref().unwrap_or(shape), rule.label.at(frame.site));
        // A block was not counted as a shape, so its leaf is one more.
        if rule.is_block { cx.any_symbol(shape, label) } else { cx.any_leaf(shape, label) }
    }

    /// The branch whose condition is true.
    #[inline(never)]
    fn branch<'b>(
        &self,
        cx: &mut Cx<'_, Call>,
        shape: &ShapeRef<'_>,
        arms: &'b [(crate::code::Code, Body)],
        otherwise: &'b Body,
        frame: Frame,
    ) -> &'b Body {
        for (condition, then) in arms {
            if self.number(cx.env, shape, condition, frame) != 0.0 {
                return then;
            }
        }
        otherwise
    }

    /// Hands the current shape to a successor.
    #[inline(never)]
    fn give(
        &self,
        cx: &mut Cx<'_, Call>,
        shape: &ShapeRef<'_>,
        target: &TargetCode,
        number: u32,
        is_last: bool,
        frame: Frame,
    ) -> Flow {
        let call = match target {
            TargetCode::Nil => return Flow::Continue(()),
            TargetCode::Vanish => return cx.vanish(shape),
            TargetCode::Leaf(name) => return cx.symbol(shape, *name),
            TargetCode::Rule(call) => call,
        };
        let called = self.called(cx, shape, call, frame);
        if is_last {
            // It is the current shape itself.
            if call.draws {
                rt::become_successor(shape, number);
            }
            return self.call(cx, shape, call, called);
        }
        self.call(cx, &rt::successor(shape, number), call, called)
    }

    /// Puts the arguments of a call on the stack.
    #[inline]
    pub(super) fn called(&self, cx: &mut Cx<'_, Call>, shape: &ShapeRef<'_>, call: &RuleCall, frame: Frame) -> Frame {
        let called = self.empty_frame(call.sites.at(frame.site));
        self.eval(cx.env, shape, &call.args, frame);
        called
    }

    /// Calls a rule whose arguments are on the stack. Where the stack may grow long the call may wait, and while a template is made it
    /// may be left out.
    pub(super) fn call(&self, cx: &mut Cx<'_, Call>, part: &ShapeRef<'_>, call: &RuleCall, called: Frame) -> Flow {
        let (levels, stack) = call.request.unwrap_or_default();
        if call.is_hole && cx.records() {
            return cx.hole(part, levels, stack, self.taken(call, called));
        }
        if call.request.is_none() {
            return self.rule(cx, part, call.rule, called);
        }
        if !cx.descend(levels, stack) {
            return cx.defer(part, levels, stack, self.taken(call, called));
        }
        let flow = self.rule(cx, part, call.rule, called);
        cx.ascend(levels, stack);
        flow
    }

    #[cold]
    fn taken(&self, call: &RuleCall, called: Frame) -> Call {
        Call::take(call.rule, &mut self.stack.borrow_mut(), called)
    }

    /// The successor of a part.
    #[inline(never)]
    pub(super) fn part(&self, cx: &mut Cx<'_, Call>, part: &ShapeRef<'_>, target: &TargetCode, frame: Frame) -> Flow {
        let call = match target {
            TargetCode::Nil => return Flow::Continue(()),
            TargetCode::Vanish => return cx.vanish(part),
            TargetCode::Leaf(name) => return cx.symbol(part, *name),
            TargetCode::Rule(call) => call,
        };
        let called = self.called(cx, part, call, frame);
        if call.reseeds {
            rt::hand_on(part);
        }
        self.call(cx, part, call, called)
    }

    /// The successor of a part, by arm or slot.
    pub(super) fn part_of(
        &self,
        cx: &mut Cx<'_, Call>,
        part: &ShapeRef<'_>,
        targets: &[TargetCode],
        number: u32,
        frame: Frame,
    ) -> Flow {
        match targets.get(number as usize) {
            Some(target) => self.part(cx, part, target, frame),
            None => ControlFlow::Continue(()),
        }
    }

    /// Hands a copy to a successor, after its arguments were evaluated on the shape before it.
    #[inline(never)]
    fn renewed(
        &self,
        cx: &mut Cx<'_, Call>,
        shape: &ShapeRef<'_>,
        step: &crate::steps::RenewStep,
        frame: Frame,
    ) -> Flow {
        self.eval(cx.env, shape, &step.given, frame);
        let mut given: Vec<rt::Value> = {
            let stack = &mut *self.stack.borrow_mut();
            step.attributes.iter().rev().map(|(_, ty)| stack.value(*ty)).collect()
        };
        given.reverse();
        let call = match &step.target {
            TargetCode::Rule(call) => Some((call, self.called(cx, shape, call, frame))),
            TargetCode::Nil => return Flow::Continue(()),
            TargetCode::Leaf(_) | TargetCode::Vanish => None,
        };
        let mut whole = cx.env.whole(&rt::push(shape, step.number));
        for ((number, _), value) in step.attributes.iter().zip(given) {
            rt::set::attribute(&mut whole, *number, value);
        }
        self.renew(cx.env, &mut whole, step.renewal, &step.sorted);
        let renewed = cx.env.base(whole);
        let shape = &renewed.shape();
        match (&step.target, call) {
            (TargetCode::Leaf(name), _) => cx.symbol(shape, *name),
            (_, Some((call, called))) => self.call(cx, &rt::successor(shape, 0), call, called),
            _ => cx.vanish(shape),
        }
    }
}
