//! Splits.

use std::ops::ControlFlow;

use cga_lang::ir::Type;
use cga_runtime::rt::{self, Cx, Flow, Read, RepeatedSlot, ShapeRef, Split, Value};

use super::values::Values;
use crate::call::Call;
use crate::stack::{Frame, Stack};
use crate::steps::{RuleCall, SplitKind, SplitStep, TargetCode, TemplateCode};

impl Values {
    /// Divides the shape. Returns true if there was a piece.
    #[inline(never)]
    pub(super) fn split(
        &self,
        cx: &mut Cx<'_, Call>,
        shape: &ShapeRef<'_>,
        step: &SplitStep,
        frame: Frame,
    ) -> ControlFlow<(), bool> {
        let split = Split {
            axis: step.axis,
            adjust: step.adjust,
            number: step.number,
            pattern: &step.slots.pattern,
            successors: &step.successors,
            has_total: step.has_total,
        };
        if step.templates.is_empty() {
            return self.divided(cx, shape, step, &split, frame, &mut |cx, slot, part| {
                self.part_of(cx, part, &step.slots.targets, slot, frame)
            });
        }
        let mut last: Vec<_> = step.templates.iter().map(|_| Default::default()).collect();
        self.divided(cx, shape, step, &split, frame, &mut |cx, slot, part| {
            let (target, last) = (step.slots.targets.get(slot as usize), last.get_mut(slot as usize));
            let template = step.templates.get(slot as usize).and_then(Option::as_ref);
            match (target, template, last) {
                (Some(TargetCode::Rule(call)), Some(template), Some(last)) => {
                    let (called, reads) = self.repeated(cx, part, call, template, frame);
                    let reads: Vec<Read<'_>> = reads.iter().map(read).collect();
                    let site = if call.sites.are_many() { frame.site } else { 0 };
                    let flow = cx.repeat(
                        RepeatedSlot {
                            place: template.place + site,
                            is_whole: template.is_whole,
                            reads_axes: template.reads_axes,
                            reads: &reads,
                        },
                        last,
                        self,
                        (part, step.axis),
                        &mut |cx, part| self.rule_again(cx, part, call, called),
                        Values::resume,
                    );
                    self.stack.borrow_mut().truncate(called);
                    flow
                }
                (Some(target), ..) => self.part(cx, part, target, frame),
                (None, ..) => Flow::Continue(()),
            }
        })
    }

    fn divided(
        &self,
        cx: &mut Cx<'_, Call>,
        shape: &ShapeRef<'_>,
        step: &SplitStep,
        split: &Split<'_>,
        frame: Frame,
        visit: &mut dyn FnMut(&mut Cx<'_, Call>, u32, &ShapeRef<'_>) -> Flow,
    ) -> ControlFlow<(), bool> {
        if let SplitKind::Solved(extent, pieces) = &step.form {
            return rt::split_solved(cx, shape, split, *extent, pieces, visit);
        }
        let mut sizes = self.sizes(cx, shape, &step.slots, frame);
        let mut lengths = vec![0.0; sizes.len()];
        match &step.form {
            SplitKind::Area => rt::split_area(cx, shape, split, &mut sizes, &mut lengths, visit),
            SplitKind::Texture(axis, space, set) => {
                let set = self.number(cx.env, shape, set, frame);
                rt::split_texture(cx, shape, split, (*axis, *space, set), &mut sizes, &mut lengths, visit)
            }
            SplitKind::Length | SplitKind::Solved(..) => rt::split(cx, shape, split, &mut sizes, &mut lengths, visit),
        }
    }

    /// Puts the arguments of a part that repeats on the stack, and returns the values that it reads.
    fn repeated(
        &self,
        cx: &mut Cx<'_, Call>,
        part: &ShapeRef<'_>,
        call: &RuleCall,
        template: &TemplateCode,
        frame: Frame,
    ) -> (Frame, Vec<KeptRead>) {
        let called = self.called(cx, part, call, frame);
        if call.reseeds {
            rt::hand_on(part);
        }
        let mut reads = Vec::new();
        if !template.args.is_empty() {
            arguments(&self.stack.borrow(), called, &template.args, &mut reads);
        }
        if !template.global_types.is_empty() {
            self.eval(cx.env, part, &template.globals, frame);
            let stack = &mut *self.stack.borrow_mut();
            let first = reads.len();
            reads.extend(template.global_types.iter().rev().map(|ty| KeptRead::Value(stack.value(*ty))));
            reads[first..].reverse();
        }
        if template.is_of_run {
            reads.push(KeptRead::Run(cx.env.run));
        }
        (called, reads)
    }

    /// Runs a rule with arguments that stay on the stack.
    fn rule_again(&self, cx: &mut Cx<'_, Call>, part: &ShapeRef<'_>, call: &RuleCall, called: Frame) -> Flow {
        let again = {
            let stack = &mut *self.stack.borrow_mut();
            let again = stack.frame(called.site);
            stack.numbers.extend_from_within(called.numbers..again.numbers);
            stack.objects.extend_from_within(called.objects..again.objects);
            again
        };
        self.rule(cx, part, call.rule, again)
    }
}

/// A value that a repeated part reads.
enum KeptRead {
    Value(Value),
    Run(u64),
}

fn read(kept: &KeptRead) -> Read<'_> {
    match kept {
        KeptRead::Value(value) => Read::from(value),
        KeptRead::Run(run) => Read::Run(*run),
    }
}

/// Adds the arguments that are not constants.
fn arguments(stack: &Stack, called: Frame, args: &[(Type, bool)], reads: &mut Vec<KeptRead>) {
    let (mut numbers, mut objects) = (called.numbers, called.objects);
    for (ty, is_read) in args {
        let value = match ty {
            Type::Float | Type::Bool => {
                numbers += 1;
                let number = stack.numbers.get(numbers - 1).copied().unwrap_or_default();
                if *ty == Type::Bool { Value::Bool(number != 0.0) } else { Value::Float(number) }
            }
            _ => {
                objects += 1;
                if !is_read {
                    continue;
                }
                let object = stack.objects.get(objects - 1).cloned();
                object.and_then(crate::object::Object::into_value).unwrap_or_else(|| crate::object::nothing(*ty))
            }
        };
        if *is_read {
            reads.push(KeptRead::Value(value));
        }
    }
}
