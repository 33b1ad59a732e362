//! Rules and their steps.

use cga_lang::ir::plan::{ChangeForm, SlimChange, reads_first_scope};
use cga_lang::ir::{Arg, Block, BlockParts, Childless, Renew, Rule, RuleId, Step, StepKind, Target};
use cga_lang::ops::{Changes, Operation, SET_BY_NAME};
use cga_runtime::rt::ChangePlace;

use super::expr::{Compiler, Locals, Steps, spelling};
use crate::code::{Code, Sites};
use crate::dispatch::{self, FunctionCall};
use crate::steps::{
    Body, End, HostStep, MaterialStep, RenewStep, RuleCall, RuleCode, SlimStep, StepCode, TargetCode, WholeStep,
};

/// The rule that contains the steps, with its parameters.
#[derive(Clone, Copy)]
pub(super) struct InRule<'r> {
    pub(super) id: RuleId,
    pub(super) rule: &'r Rule,
    pub(super) locals: &'r Locals,
}

impl Compiler<'_> {
    /// A rule or a block.
    pub(super) fn rule(&self, id: RuleId, rule: &Rule) -> RuleCode {
        let locals = &Locals::new(&rule.params);
        let at = InRule { id, rule, locals };
        let given = &rule.params[..rule.params.len().saturating_sub(rule.locals.len())];
        RuleCode {
            body: self.body(&rule.body, at, 0, true, true),
            locals: self.code(&rule.locals, locals),
            params: if rule.block { Box::default() } else { given.iter().map(|param| param.ty).collect() },
            has_values: !rule.params.is_empty(),
            is_block: rule.block,
            tells_part: self.tells_parts,
            trail: Sites::new(self.plan.trails.of(id)),
            label: Sites::new(self.plan.leaves.implicit(rule)),
        }
    }

    /// Steps up to the end of a rule, a bracket or a branch. `number` counts the children made so far.
    fn body(&self, steps: &[Step], at: InRule<'_>, mut number: u32, is_tail: bool, begins: bool) -> Body {
        let (mut list, mut rest) = (Vec::new(), steps);
        let reads_scope = begins && reads_first_scope(steps);
        while let Some((step, after)) = rest.split_first() {
            let count = rest.iter().take_while(|step| step.changes_shape()).count();
            if 0 < count {
                let (changes, after) = rest.split_at(count);
                list.push(self.changed(changes, at));
                rest = after;
                continue;
            }
            rest = after;
            if let StepKind::Case { arms, otherwise } = &step.kind {
                let arms = arms.iter().map(|(condition, steps)| {
                    (self.code([condition], at.locals), self.body(steps, at, number, is_tail, false))
                });
                let arms = arms.collect();
                let otherwise = Box::new(self.body(otherwise, at, number, is_tail, false));
                list.push(StepCode::Case(arms, otherwise));
                return Body { steps: list.into(), end: End::Nothing, reads_scope };
            }
            list.extend(self.found(step, self.step(step, at, number, rest.is_empty())));
            number += step.children();
        }
        let end = match at.rule.leaf {
            _ if !is_tail => End::Nothing,
            Childless::Always => End::Leaf,
            Childless::Depends if number == 0 => End::Leaf,
            Childless::Depends => End::IfChildless,
            Childless::Never => End::Nothing,
        };
        Body { steps: list.into(), end, reads_scope }
    }

    /// Steps that change the current shape.
    fn changed(&self, steps: &[Step], at: InRule<'_>) -> StepCode {
        if let ChangeForm::Slim(changes) = self.plan.change_form(steps) {
            let (mut slim, mut rest) = (Vec::new(), steps);
            for change in changes {
                let (own, behind) = rest.split_at(change.steps());
                slim.extend(own.first().and_then(|first| self.found(first, self.slim(own, change, at))));
                rest = behind;
            }
            return StepCode::Slim(slim.into());
        }
        StepCode::Whole(steps.iter().filter_map(|step| self.found(step, self.whole(step, at))).collect())
    }

    /// Reports an operation without a call. The tests of the tables keep that from happening.
    fn found<T>(&self, step: &Step, code: Option<T>) -> Option<T> {
        if let (None, StepKind::Do(row, _) | StepKind::Block(Block { row, .. })) = (&code, &step.kind) {
            self.problems.missing(row.name, step.span);
        }
        code
    }

    fn slim(&self, steps: &[Step], change: SlimChange, at: InRule<'_>) -> Option<SlimStep> {
        match (change, &steps.first()?.kind) {
            (SlimChange::Nothing, StepKind::Do(row, args)) => {
                let (args, call) = self.says(row, args, at)?;
                Some(SlimStep::Says(args, call))
            }
            (SlimChange::Scope, StepKind::Do(row, args)) => {
                let call = dispatch::slim::call(&row.key(), args)?;
                Some(SlimStep::Scope(self.args(row.params, args, at.locals), call))
            }
            (SlimChange::Material(change), _) => {
                let place = if change.is_of_run { ChangePlace::of_run } else { ChangePlace::lasting };
                let first = self.changes.get();
                let count = change.sites.max(1);
                self.changes.set(first + count);
                let places = (first..first + count).map(place).collect();
                let params = change.params.iter().map(|(number, ty)| (at.locals.index(*number), *ty)).collect();
                let steps = steps.iter().filter_map(|step| self.found(step, self.whole(step, at))).collect();
                Some(SlimStep::Material(MaterialStep { steps, places, reaches_caps: change.reaches_caps, params }))
            }
            (SlimChange::Nothing | SlimChange::Scope, _) => None,
        }
    }

    /// An operation that reads the shape alone.
    fn says(&self, row: &Operation, args: &[Arg], at: InRule<'_>) -> Option<(Code, FunctionCall)> {
        let call = dispatch::says::call(&row.key(), args)?;
        Some((self.args(row.params, args, at.locals), call))
    }

    fn whole(&self, step: &Step, at: InRule<'_>) -> Option<WholeStep> {
        match &step.kind {
            StepKind::Do(row, args) if row.run == SET_BY_NAME.run => {
                let value =
                    args.iter().rev().find_map(|arg| if let Arg::Value(value) = arg { Some(value) } else { None })?;
                Some(WholeStep::Named(self.args(row.params, args, at.locals), value.ty))
            }
            StepKind::Do(row, args) if row.changes == Changes::Nothing => {
                let (args, call) = self.says(row, args, at)?;
                Some(WholeStep::Says(args, call))
            }
            StepKind::Do(row, args) => Some(WholeStep::Change {
                change: dispatch::change(row, args)?,
                args: self.args(row.params, args, at.locals),
                asks: row.changes == Changes::Whole,
                bakes: row.reshapes(),
            }),
            StepKind::SetAttr(id, value) => Some(WholeStep::Attribute(self.code([value], at.locals), id.0, value.ty)),
            StepKind::SetShape(attr, value) => {
                let change = dispatch::set(attr)?;
                let mut steps = Steps::default();
                self.image(value, at.locals, &mut steps);
                let args = Code { is_whole: self.plan.needs_whole(value), ..steps.finish() };
                Some(WholeStep::Change { args, change, asks: false, bakes: false })
            }
            StepKind::Rust(path, args) => {
                let name = spelling(path);
                let Some(operation) = self.registered.operation(&name, args) else {
                    self.problems.unregistered(&name, "operation", self.registered.is_live, step.span);
                    return None;
                };
                let types = args.iter().map(|arg| arg.ty).collect();
                let operation = HostStep(operation);
                Some(WholeStep::Host { args: self.code(args, at.locals), types, operation })
            }
            _ => None,
        }
    }

    /// A step that makes children.
    fn step(&self, step: &Step, at: InRule<'_>, number: u32, is_last: bool) -> Option<StepCode> {
        Some(match &step.kind {
            StepKind::Give(target) => StepCode::Give { target: self.target(target, at), number, is_last },
            StepKind::Renew(call) => StepCode::Renew(Box::new(self.renew(call, at, number))),
            StepKind::Push(steps) => StepCode::Push(self.body(steps, at, 0, false, true), number),
            StepKind::Block(block) => self.block(block, at, number)?,
            StepKind::Do(..)
            | StepKind::SetAttr(..)
            | StepKind::SetShape(..)
            | StepKind::Rust(..)
            | StepKind::Case { .. } => return None,
        })
    }

    fn block(&self, block: &Block, at: InRule<'_>, number: u32) -> Option<StepCode> {
        Some(match &block.parts {
            BlockParts::Slots(slots) => StepCode::Split(Box::new(self.split(block, slots, at, number)?)),
            BlockParts::Arms(arms) => StepCode::Arms(Box::new(self.divided(block, arms, at, number)?)),
            BlockParts::Sections(parts) => StepCode::Sections(Box::new(self.sections(block, parts, at, number)?)),
            BlockParts::Each(target) => StepCode::Each(Box::new(self.each(block, target, at, number)?)),
            BlockParts::Operands(targets) => StepCode::Operands(Box::new(self.derived(block, targets, at, number)?)),
        })
    }

    fn renew(&self, call: &Renew, at: InRule<'_>, number: u32) -> RenewStep {
        let attributes: Box<[_]> = call.given.iter().map(|(id, value)| (id.0, value.ty)).collect();
        let mut sorted: Vec<u32> = attributes.iter().map(|(id, _)| *id).collect();
        sorted.sort_unstable();
        RenewStep {
            given: self.code(call.given.iter().map(|(_, value)| value), at.locals),
            attributes,
            sorted: sorted.into(),
            renewal: call.renewal.0 as usize,
            target: self.target(&call.target, at),
            number,
        }
    }

    /// The successor of a child.
    pub(super) fn target(&self, target: &Target, at: InRule<'_>) -> TargetCode {
        match target {
            Target::Nil if self.plan.vanishes(target, at.id) => TargetCode::Vanish,
            Target::Nil => TargetCode::Nil,
            Target::Leaf(name) => TargetCode::Leaf(self.plan.leaves.number(name)),
            Target::Rule { rule, sites, args, .. } => {
                let request = self.plan.rule_stack.request(at.id, *rule);
                TargetCode::Rule(RuleCall {
                    rule: rule.0 as usize,
                    args: self.code(args, at.locals),
                    sites: Sites::new(sites.iter().copied()),
                    request: request.map(|request| (request.levels, request.stack)),
                    is_hole: self.plan.holes.is_hole(at.id, *rule),
                    draws: self.plan.draws(*rule),
                    reseeds: self.plan.reseeds(*rule),
                })
            }
        }
    }
}
